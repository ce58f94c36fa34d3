#include "report/LeftData.hpp"

#include "io/Units.hpp"
#include "math/Angles.hpp"

#include <nlohmann/json.hpp>
#include <vector>

namespace naocal {

using nlohmann::json;

namespace {

constexpr Range shiftPx{-1e9, 1e9, "px"};

std::size_t pictureAt(const JsonPlace& place, const json& data) {
  return static_cast<std::size_t>(place.integer(0, static_cast<int>(data["pictures"].size()) - 1));
}

/// A driver, its value at each picture; `joint` where it can only drive that one.
json driverData(const JsonPlace& driver, std::size_t pictures) {
  const auto [unit, scale] = shownUnit(driver.at("unit").text());
  json values = json::array();
  for (const double value : driver.at("values").numbers(pictures, anyNumber, "one per picture")) {
    values.push_back(scale * value);
  }
  const auto joint = driver.find("at");
  return {{"what", driver.at("what").text()},
          {"unit", unit},
          {"joint", joint ? joint->text() : ""},
          {"values", std::move(values)}};
}

/// Per joint a list of (pictures, deflection and its standard error in degrees).
json whatIfData(const JsonPlace& list, const json& data) {
  json result = json::array();
  for (const JsonPlace& joint : list.elements()) {
    json points = json::array();
    for (const JsonPlace& point : joint.at("points").elements()) {
      json pictures = json::array();
      for (const JsonPlace& picture : point.at("pictures").elements()) {
        pictures.push_back(pictureAt(picture, data));
      }
      if (pictures.empty()) {
        point.at("pictures").refuse("at least one picture");
      }
      points.push_back({std::move(pictures), degrees(point.at("deflection").number(anyNumber)),
                        degrees(point.at("sigma").number(anyNumber))});
    }
    result.push_back({{"joint", joint.at("joint").text()}, {"points", std::move(points)}});
  }
  return result;
}

/// Cells (camera, u, v, du, dv, sigma, corners, worst picture) and boards (picture, board, distance, rms).
json withinData(const JsonPlace& within, const json& data) {
  json cells = json::array(), boards = json::array();
  for (const JsonPlace& cell : within.at("cells").elements()) {
    cells.push_back({{"camera", cell.at("camera").text()},
                     {"corners", cell.at("corners").integer(1, largestNumber)},
                     {"worst", pictureAt(cell.at("worstPicture"), data)}});
    for (const char* number : {"u", "v", "du", "dv", "sigma"}) {
      cells.back()[number] = cell.at(number).number(shiftPx);
    }
  }
  for (const JsonPlace& board : within.at("boards").elements()) {
    boards.push_back({{"picture", pictureAt(board.at("picture"), data)},
                      {"board", board.at("board").text()},
                      {"distance", board.at("distance").number({0, 1e6, "m"})},
                      {"rms", board.at("rmsPx").number(shiftPx)}});
  }
  return {{"noise", within.at("noisePx").number(shiftPx)}, {"cells", std::move(cells)}, {"boards", std::move(boards)}};
}

/// Boards (name, p) with corners (place and id, off and sigma in millimetres).
json shapeData(const JsonPlace& list) {
  constexpr Range metres{-1e3, 1e3, "m"};
  constexpr double millimetre = 1e-3;
  json result = json::array();
  for (const JsonPlace& shape : list.elements()) {
    json corners = json::array();
    for (const JsonPlace& corner : shape.at("corners").elements()) {
      json shown{{"id", corner.at("id").integer(0, largestNumber)},
                 {"place", corner.at("place").numbers(3, metres, "x, y and z")}};
      for (const char* name : {"off", "sigma"}) {
        for (const double value : corner.at(name).numbers(3, metres, "x, y and z")) {
          shown[name].push_back(value / millimetre);
        }
      }
      corners.push_back(std::move(shown));
    }
    result.push_back({{"board", shape.at("board").text()},
                      {"p", shape.at("p").number({0, 1, ""})},
                      {"corners", std::move(corners)}});
  }
  return result;
}

} // namespace

void addLeft(const JsonPlace& diagnosis, json& data) {
  data["drivers"] = json::array();
  data["left"] = json::object();
  if (const auto recorded = diagnosis.find("recorded")) {
    for (const JsonPlace& driver : recorded->elements()) {
      data["drivers"].push_back(driverData(driver, data["pictures"].size()));
    }
  }
  const auto left = diagnosis.find("left");
  for (const auto& [model, over] : left ? left->members() : std::vector<std::pair<std::string, JsonPlace>>{}) {
    data["left"][model] = {{"whatIf", whatIfData(over.at("whatIf"), data)},
                           {"within", withinData(over.at("withinPictures"), data)},
                           {"shapes", shapeData(over.at("boardShapes"))}};
  }
}

} // namespace naocal

#include "report/ResidualViewsData.hpp"

#include "io/Units.hpp"
#include "report/PageValues.hpp"
#include "report/ReadingsData.hpp"

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace naocal {

using nlohmann::json;

namespace {

constexpr Range shiftPx{-1e9, 1e9, "px"};

/// A driver with its value at each image; `joint` if it can affect only that one.
json driverData(const JsonCursor& driver, std::size_t pictures) {
  const auto [unit, scale] = displayUnit(driver.at("unit").text());
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

/// The images of a point, at least one.
json picturesOf(const JsonCursor& point, const json& data) {
  json pictures = json::array();
  for (const JsonCursor& picture : point.at("pictures").elements()) {
    pictures.push_back(indexIn(data["pictures"], picture));
  }
  if (pictures.empty()) {
    point.at("pictures").refuse("at least one picture");
  }
  return pictures;
}

/// Per joint its unit and a list of (images, deflection and its standard error).
json whatIfData(const JsonCursor& diagnosis, const JsonCursor& list, const json& data) {
  json result = json::array();
  for (const JsonCursor& joint : list.elements()) {
    const auto [unit, scale] = displayUnit(recordedUnit(diagnosis, joint.at("joint").text()).value_or("rad"));
    json points = json::array();
    for (const JsonCursor& point : joint.at("points").elements()) {
      points.push_back({picturesOf(point, data), scale * point.at("deflection").number(anyNumber),
                        scale * point.at("sigma").number(anyNumber)});
    }
    result.push_back({{"joint", joint.at("joint").text()}, {"unit", unit}, {"points", std::move(points)}});
  }
  return result;
}

/// Cells (camera, u, v, du, dv, sigma, corners, worst image) and boards (image, board, distance, rms).
json withinData(const JsonCursor& within, const json& data) {
  json cells = json::array(), boards = json::array();
  for (const JsonCursor& cell : within.at("cells").elements()) {
    cells.push_back({{"camera", cell.at("camera").text()},
                     {"corners", cell.at("corners").integer(1, maxInteger)},
                     {"worst", indexIn(data["pictures"], cell.at("worstPicture"))}});
    for (const char* number : {"u", "v", "du", "dv", "sigma"}) {
      cells.back()[number] = cell.at(number).number(shiftPx);
    }
  }
  for (const JsonCursor& board : within.at("boards").elements()) {
    boards.push_back({{"picture", indexIn(data["pictures"], board.at("picture"))},
                      {"board", board.at("board").text()},
                      {"distance", board.at("distance").number({0, 1e6, "m"})},
                      {"rms", board.at("rmsPx").number(shiftPx)}});
  }
  return {{"noise", within.at("noisePx").number(shiftPx)}, {"cells", std::move(cells)}, {"boards", std::move(boards)}};
}

/// Boards (name, p) with corners (place and id, off and sigma in millimetres).
json shapeData(const JsonCursor& list) {
  constexpr Range metres{-1e3, 1e3, "m"};
  constexpr double millimetre = 1e-3;
  json result = json::array();
  for (const JsonCursor& shape : list.elements()) {
    json corners = json::array();
    for (const JsonCursor& corner : shape.at("corners").elements()) {
      json shown{{"id", corner.at("id").integer(0, maxInteger)},
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

/// Partial residuals of each cause, per point its pictures; displacements in the unit of the errors.
json causeData(const JsonCursor& cause, const ErrorUnit& errors, const json& data) {
  const auto shown = [&](const std::string& unit) {
    return unit == "px" ? std::pair{errors.name, errors.perPx} : displayUnit(unit);
  };
  const auto [unit, scale] = shown(cause.at("unit").text());
  const auto [overUnit, overScale] = shown(cause.at("overUnit").text());
  json points = json::array();
  for (const JsonCursor& point : cause.at("points").elements()) {
    points.push_back({{"pictures", picturesOf(point, data)}, {"over", overScale * point.at("over").number(anyNumber)}});
    for (const char* number : {"own", "left", "sigma"}) {
      points.back()[number] = scale * point.at(number).number(anyNumber);
    }
  }
  return {{"label", cause.at("label").text()},
          {"error", label(cause.at("error"))},
          {"over", label(cause.at("over"))},
          {"unit", unit},
          {"overUnit", overUnit},
          {"before", scale * cause.at("before").number(anyNumber)},
          {"after", scale * cause.at("after").number(anyNumber)},
          {"points", std::move(points)}};
}

} // namespace

void addResidualViewsData(const JsonCursor& diagnosis, json& data) {
  data["drivers"] = json::array();
  data["left"] = json::object();
  data["causes"] = json::array();
  if (const auto causes = diagnosis.find("causes")) { // absent in files of earlier versions
    const ErrorUnit errors = shownErrorUnit(diagnosis);
    for (const JsonCursor& cause : causes->elements()) {
      data["causes"].push_back(causeData(cause, errors, data));
    }
  }
  if (const auto recorded = diagnosis.find("recorded")) {
    for (const JsonCursor& driver : recorded->elements()) {
      data["drivers"].push_back(driverData(driver, data["pictures"].size()));
    }
  }
  const auto left = diagnosis.find("left");
  for (const auto& [model, over] : left ? left->members() : std::vector<std::pair<std::string, JsonCursor>>{}) {
    data["left"][model] = {{"whatIf", whatIfData(diagnosis, over.at("whatIf"), data)},
                           {"within", withinData(over.at("withinPictures"), data)},
                           {"shapes", shapeData(over.at("boardShapes"))},
                           {"readings", readingsOfPictures(over, data["pictures"].size())}};
  }
}

} // namespace naocal

#include "report/ResultData.hpp"
#include "report/FindingsData.hpp"

#include "io/Units.hpp"
#include "report/PageValues.hpp"
#include "report/ReadingsData.hpp"
#include "report/ResultFacts.hpp"
#include "report/SourceCaptures.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

using nlohmann::json;

namespace {

/// "joint offset" for jointOffset.
std::string spaced(const std::string& name) {
  std::string words;
  for (const char letter : name) {
    if (std::isupper(static_cast<unsigned char>(letter))) {
      words += ' ';
    }
    words += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return words;
}

/// "NAO V6"; of other robots the name alone.
std::string nameRobot(const std::string& model) {
  const bool isNao = model.size() == 2 && model[0] == 'V' && std::isdigit(static_cast<unsigned char>(model[1]));
  return isNao ? "NAO " + model : model;
}

/// The averaged estimate if alternative models were tested, otherwise that of the model, which is also given as
/// `fitted`.
json estimateJson(const std::string& name, const JsonCursor& unknown, double scale) {
  const auto averaged = unknown.find("averaged");
  const JsonCursor& answer = averaged ? *averaged : unknown;
  const std::vector<double> ends =
      answer.at(averaged ? "interval" : "interval95").numbers(2, {-1e15, 1e15, ""}, "lower and upper end");
  return {{"name", name},
          {"value", scale * answer.at("value").number({-1e15, 1e15, ""})},
          {"sigma", scale * answer.at("sigma").number({0, 1e15, ""})},
          {"fitted", scale * unknown.at("value").number({-1e15, 1e15, ""})},
          {"low", scale * ends[0]},
          {"high", scale * ends[1]},
          {"learned", unknown.at("learned").number({-1e15, 1, ""})}};
}

/// Joint readings of a capture, as people read them.
json jointsJson(const SourceCaptures& sources, const std::string& set, int capture) {
  json joints = json::object();
  for (const auto& [joint, reading] : sources.jointReadings(set, capture)) {
    const auto [unit, scale] = displayUnit(reading.unit);
    joints[joint] = roundToDecimals(scale * reading.value, 2);
  }
  return joints;
}

/// Units of the joints that do not read in degrees.
json jointUnitsJson(const SourceCaptures& sources) {
  json units = json::object();
  for (const auto& [joint, unit] : sources.jointUnits()) {
    if (const std::string shown = displayUnit(unit).first; shown != "°") {
      units[joint] = shown;
    }
  }
  return units;
}

/// The captures of a result's readings that are no corners, in the order of those.
json readCapturesJson(const JsonCursor& result, const SourceCaptures& sources) {
  json captures = json::array();
  const auto readings = result.find("readings");
  for (const JsonCursor& reading : readings ? readings->elements() : std::vector<JsonCursor>{}) {
    const std::string set = label(reading.at("set"));
    const int capture = reading.at("capture").integer(0, maxInteger);
    captures.push_back({{"set", set},
                        {"capture", capture},
                        {"pose", label(reading.at("pose"))},
                        {"repeat", reading.at("repeat").integer(0, maxInteger)},
                        {"time", reading.at("time").number({-1e12, 1e12, "s"})},
                        {"camera", ""},
                        {"angles", jointsJson(sources, set, capture)}});
  }
  return captures;
}

/// The images, worst first; includes photographs up to a total size that keeps the page small.
json picturesJson(const std::vector<PictureRecord>& seen, const SourceCaptures& sources) {
  constexpr std::size_t mostPhotographs = 3'000'000; // [bytes]
  json pictures = json::array();
  std::size_t photographs = 0;
  for (const PictureRecord& one : seen) {
    json picture = pictureJson(one);
    picture["angles"] = jointsJson(sources, one.set, one.capture);
    if (const auto file = photographs < mostPhotographs ? sources.image(one) : std::nullopt) {
      if (auto photograph = makeThumbnail(*file, {one.width, one.height})) {
        photographs += photograph->size();
        picture["photograph"] = std::move(*photograph);
      }
    }
    pictures.push_back(std::move(picture));
  }
  return pictures;
}

/// u and v of all corners in sequence.
json flat(const Eigen::Matrix2Xd& points, int decimals) {
  json list = json::array();
  for (const double value : points.reshaped()) {
    list.push_back(roundToDecimals(value, decimals));
  }
  return list;
}

json boardJson(const BoardInPicture& seen) {
  json board{{"board", seen.board},
             {"ids", seen.ids},
             {"measured", flat(seen.measured, 1)},
             {"reported", flat(seen.predicted - seen.measured, 3)},
             {"fitted", flat(seen.fitted - seen.measured, 3)}};
  if (std::any_of(seen.weight.begin(), seen.weight.end(), [](double weight) { return weight < 1; })) {
    board["weight"] = json::array();
    for (const double weight : seen.weight) {
      board["weight"].push_back(roundToDecimals(weight, 2));
    }
  }
  return board;
}

} // namespace

json estimatesData(const JsonCursor& effects) {
  json groups = json::array();
  for (const JsonCursor& effect : effects.elements()) {
    const std::string title = spaced(effect.at("effect").text()), at = effect.at("at").text();
    const auto unknowns = effect.at("unknowns").members();
    for (const auto& [name, unknown] : unknowns) {
      const auto [unit, scale] = displayUnit(unknown.at("unit").text());
      auto group = std::find_if(groups.begin(), groups.end(),
                                [&, &u = unit](const json& g) { return g["title"] == title && g["unit"] == u; });
      if (group == groups.end()) {
        const json empty{{"title", title}, {"unit", unit}, {"rows", json::array()}};
        group = groups.insert(groups.end(), empty);
      }
      (*group)["rows"].push_back(estimateJson(unknowns.size() == 1 ? at : at + " " + name, unknown, scale));
    }
  }
  return groups;
}

json resultData(const JsonCursor& result, const SourceCaptures& sources) {
  const VerdictWords words = verdictWords(result);
  json data{{"robot", nameRobot(result.at("model").at("robot").text())},
            {"verdict", result.at("verdict").text()},
            {"headline", words.headline},
            {"sentence", words.sentence},
            {"facts", json::array()},
            {"findings", findingsData(result)},
            {"groups", estimatesData(result.at("effects"))},
            {"pixelNoise", result.at("noise").at("pixel").number({0, 1e6, "px"})},
            {"pictures", picturesJson(readPictures(result), sources)},
            {"readings", readingsOfResult(result)},
            {"captures", readCapturesJson(result, sources)},
            {"jointUnits", jointUnitsJson(sources)},
            {"sets", sources.names()},
            {"missing", sources.unavailable()}};
  for (const auto& [figure, sentence] : facts(result, data["pictures"].size(), sources.drawingErrors())) {
    data["facts"].push_back({{"figure", figure}, {"sentence", sentence}});
  }
  return data;
}

json pictureJson(const PictureRecord& seen) {
  json picture{{"set", seen.set},       {"capture", seen.capture}, {"pose", seen.pose},
               {"repeat", seen.repeat}, {"time", seen.time},       {"camera", seen.camera},
               {"width", seen.width},   {"height", seen.height},   {"boards", json::array()}};
  for (const BoardInPicture& board : seen.boards) {
    picture["boards"].push_back(boardJson(board));
  }
  return picture;
}

} // namespace naocal

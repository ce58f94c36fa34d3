#include "report/ResultData.hpp"

#include "io/Units.hpp"
#include "math/Angles.hpp"
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

/// The images, worst first; includes photographs up to a total size that keeps the page small.
json picturesJson(const std::vector<PictureRecord>& seen, const SourceCaptures& sources) {
  constexpr std::size_t mostPhotographs = 3'000'000; // [bytes]
  json pictures = json::array();
  std::size_t photographs = 0;
  for (const PictureRecord& one : seen) {
    json picture = pictureJson(one);
    picture["angles"] = json::object();
    for (const auto& [joint, angle] : sources.angles(one)) {
      picture["angles"][joint] = roundToDecimals(degrees(angle), 2);
    }
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

double numberAt(const JsonCursor& place, const std::string& key) {
  return place.at(key).number({-1e15, 1e15, ""});
}

Fact cornerFact(const JsonCursor& result, std::size_t pictures, std::optional<double> drawingRms) {
  const double rms = numberAt(result, "rmsPx");
  const std::string where =
      fmt::format("rms distance between {:.0f} measured corners in {} pictures and where the result predicts them",
                  numberAt(result, "corners"), pictures);
  if (!drawingRms) {
    return {fmt::format("{:.2f} px", rms), where + fmt::format(" (median {:.2f} px).", numberAt(result, "medianPx"))};
  }
  return {fmt::format("{:.3g} → {:.2f} px", *drawingRms, rms),
          where + "; the first number is with the robot's drawing alone, boards where they fit best."};
}

Fact noiseFact(const JsonCursor& noise) {
  const bool told = noise.at("source").text() == "repeats";
  const double stance = numberAt(noise, "stance");
  return {fmt::format("{:.2g} px", numberAt(noise, "pixel")),
          fmt::format("noise of a corner per axis; {:.3f}° of an encoder's reading; {:.3f}° of a joint from pose to "
                      "pose{}: {}.",
                      degrees(numberAt(noise, "encoder")), degrees(numberAt(noise, "pose")),
                      stance > 0 ? fmt::format("; {:.3f}° more wherever the robot stands anew", degrees(stance)) : "",
                      told ? "measured from poses that were taken more than once"
                           : "partly assumed, because no pose was taken more than once")};
}

/// The noise floor, and how often noise alone would give such evidence for a missing effect.
Fact misfitFact(const JsonCursor& result) {
  const double p = numberAt(result, "pValue");
  const std::string chance =
      p >= 0.05 ? "the best candidate for more is no more striking than pure noise."
      : p >= 0.001
          ? fmt::format("if nothing were missing, evidence this strong for a cause would turn up once in {:.0f} "
                        "calibrations.",
                        1 / p)
          : "if nothing were missing, evidence this strong for a cause would turn up less than once in 1000 "
            "calibrations.";
  return {fmt::format("{:.2f} px", numberAt(result, "noiseFloorPx")), "is the noise floor; " + chance};
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
  json data{{"robot", result.at("model").at("robot").text()},
            {"verdict", result.at("verdict").text()},
            {"headline", words.headline},
            {"sentence", words.sentence},
            {"facts", json::array()},
            {"warnings", result.at("warnings").texts()},
            {"weak", json::array()},
            {"groups", estimatesData(result.at("effects"))},
            {"pixelNoise", result.at("noise").at("pixel").number({0, 1e6, "px"})},
            {"pictures", picturesJson(readPictures(result), sources)},
            {"sets", sources.names()},
            {"missing", sources.unavailable()}};
  for (const auto& [figure, sentence] : facts(result, data["pictures"].size(), sources.nominalRms())) {
    data["facts"].push_back({{"figure", figure}, {"sentence", sentence}});
  }
  for (const JsonCursor& direction : result.at("weak").elements()) {
    data["weak"].push_back({{"sentence", direction.at("sentence").text()},
                            {"sigma", direction.at("sigma").number({0, 1e15, ""})},
                            {"unit", direction.at("unit").text()}});
  }
  return data;
}

double roundToDecimals(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return std::round(value * scale) / scale;
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

VerdictWords verdictWords(const JsonCursor& result) {
  const std::string said = result.at("sentence").text(), between = ": ";
  const std::size_t colon = said.find(between);
  if (colon == said.npos) {
    return {said, ""};
  }
  std::string rest = said.substr(colon + between.size());
  if (!rest.empty() && rest.front() >= 'a' && rest.front() <= 'z') {
    rest.front() = static_cast<char>(rest.front() - 'a' + 'A');
  }
  return {said.substr(0, colon) + ".", std::move(rest)};
}

std::vector<Fact> facts(const JsonCursor& result, std::size_t pictures, std::optional<double> drawingRms) {
  std::vector<Fact> all{cornerFact(result, pictures, drawingRms), misfitFact(result), noiseFact(result.at("noise"))};
  if (const double floor = numberAt(result, "floorErrorAt2m"); floor > 0) {
    all.insert(all.begin() + 1,
               {fmt::format("± {:.1f} mm", 1000 * floor),
                "is how far off the robot will see a point on the floor 2 m ahead (1 sigma); below 50 mm is good "
                "enough to play."});
  }
  return all;
}

} // namespace naocal

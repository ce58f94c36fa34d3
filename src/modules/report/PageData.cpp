#include "report/PageData.hpp"

#include "geometry/Angles.hpp"
#include "report/SeenPictures.hpp"
#include "report/Sentences.hpp"
#include "report/ShownUnit.hpp"
#include "report/Thumbnail.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

namespace naocal {

using nlohmann::json;

namespace {

/// A number with as many decimals as a figure can show.
double shortened(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return std::round(value * scale) / scale;
}

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

json estimateJson(const std::string& name, const JsonPlace& unknown, double scale) {
  const std::vector<double> ends = unknown.at("interval95").numbers(2, {-1e15, 1e15, ""}, "lower and upper end");
  return {{"name", name},
          {"value", scale * unknown.at("value").number({-1e15, 1e15, ""})},
          {"low", scale * ends[0]},
          {"high", scale * ends[1]},
          {"learned", unknown.at("learned").number({-1e15, 1, ""})}};
}

/// Estimates by effect and unit: what can share an axis stands together.
json groupsJson(const JsonPlace& effects) {
  json groups = json::array();
  for (const JsonPlace& effect : effects.elements()) {
    const std::string title = spaced(effect.at("effect").text()), at = effect.at("at").text();
    const auto unknowns = effect.at("unknowns").members();
    for (const auto& [name, unknown] : unknowns) {
      const auto [unit, scale] = shownUnit(unknown.at("unit").text());
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

/// u and v of every corner, one after the other.
json flat(const Eigen::Matrix2Xd& points, int decimals) {
  json list = json::array();
  for (const double value : points.reshaped()) {
    list.push_back(shortened(value, decimals));
  }
  return list;
}

json boardJson(const SeenBoard& seen) {
  json board{{"board", seen.board},
             {"ids", seen.ids},
             {"measured", flat(seen.measured, 1)},
             {"reported", flat(seen.predicted - seen.measured, 3)},
             {"fitted", flat(seen.fitted - seen.measured, 3)}};
  if (std::any_of(seen.weight.begin(), seen.weight.end(), [](double weight) { return weight < 1; })) {
    board["weight"] = json::array();
    for (const double weight : seen.weight) {
      board["weight"].push_back(shortened(weight, 2));
    }
  }
  return board;
}

json pictureJson(const SeenPicture& seen, const Sources& sources) {
  json picture{{"set", seen.set},          {"capture", seen.capture}, {"pose", seen.pose},   {"repeat", seen.repeat},
               {"time", seen.time},        {"camera", seen.camera},   {"width", seen.width}, {"height", seen.height},
               {"angles", json::object()}, {"boards", json::array()}};
  for (const SeenBoard& board : seen.boards) {
    picture["boards"].push_back(boardJson(board));
  }
  for (const auto& [joint, angle] : sources.angles(seen)) {
    picture["angles"][joint] = shortened(degrees(angle), 2);
  }
  return picture;
}

/// The pictures, worst first, with what was photographed as long as the page stays small enough to be sent around.
json picturesJson(const std::vector<SeenPicture>& seen, const Sources& sources) {
  constexpr std::size_t mostPhotographs = 3'000'000; // [bytes]
  json pictures = json::array();
  std::size_t photographs = 0;
  for (const SeenPicture& one : seen) {
    json picture = pictureJson(one, sources);
    if (const auto file = photographs < mostPhotographs ? sources.image(one) : std::nullopt) {
      if (auto photograph = thumbnail(*file)) {
        photographs += photograph->size();
        picture["photograph"] = std::move(*photograph);
      }
    }
    pictures.push_back(std::move(picture));
  }
  return pictures;
}

json textsAt(const JsonPlace& list) {
  json texts = json::array();
  for (const JsonPlace& text : list.elements()) {
    texts.push_back(text.text());
  }
  return texts;
}

} // namespace

json pageData(const JsonPlace& result, const Sources& sources) {
  json data{{"robot", result.at("model").at("robot").text()},
            {"usable", result.at("usable").boolean()},
            {"headline", headline(result)},
            {"facts", json::array()},
            {"warnings", textsAt(result.at("warnings"))},
            {"weak", json::array()},
            {"groups", groupsJson(result.at("effects"))},
            {"pixelNoise", result.at("noise").at("pixel").number({0, 1e6, "px"})},
            {"pictures", picturesJson(seenPictures(result), sources)},
            {"sets", textsAt(result.at("inputs").at("sets"))},
            {"missing", sources.missing()}};
  for (const auto& [figure, sentence] : facts(result, data["pictures"].size(), sources.drawingRms())) {
    data["facts"].push_back({{"figure", figure}, {"sentence", sentence}});
  }
  for (const JsonPlace& direction : result.at("weak").elements()) {
    data["weak"].push_back({{"sentence", direction.at("sentence").text()},
                            {"sigma", direction.at("sigma").number({0, 1e15, ""})},
                            {"unit", direction.at("unit").text()}});
  }
  return data;
}

} // namespace naocal

#include "report/PageData.hpp"

#include "math/Angles.hpp"
#include "report/EstimatesData.hpp"
#include "report/PictureData.hpp"
#include "report/SeenPictures.hpp"
#include "report/Sentences.hpp"
#include "report/Thumbnail.hpp"

#include <nlohmann/json.hpp>

namespace naocal {

using nlohmann::json;

namespace {

/// The pictures, worst first, with what was photographed as long as the page stays small enough to be sent around.
json picturesJson(const std::vector<SeenPicture>& seen, const Sources& sources) {
  constexpr std::size_t mostPhotographs = 3'000'000; // [bytes]
  json pictures = json::array();
  std::size_t photographs = 0;
  for (const SeenPicture& one : seen) {
    json picture = pictureJson(one);
    picture["angles"] = json::object();
    for (const auto& [joint, angle] : sources.angles(one)) {
      picture["angles"][joint] = withDecimals(degrees(angle), 2);
    }
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
  const VerdictWords words = verdictWords(result);
  json data{{"robot", result.at("model").at("robot").text()},
            {"verdict", result.at("verdict").text()},
            {"headline", words.headline},
            {"sentence", words.sentence},
            {"facts", json::array()},
            {"warnings", textsAt(result.at("warnings"))},
            {"weak", json::array()},
            {"groups", estimatesData(result.at("effects"))},
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

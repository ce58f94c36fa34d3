#include "report/DiagnosisData.hpp"
#include "report/FindingsData.hpp"

#include "report/AliasesData.hpp"
#include "report/CandidatesData.hpp"
#include "report/CurvesData.hpp"
#include "report/DiagnosisFacts.hpp"
#include "report/PageValues.hpp"
#include "report/ReadingsData.hpp"
#include "report/ResidualViewsData.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace naocal {

using nlohmann::json;

namespace {

json stepJson(const JsonCursor& step, const ErrorUnit& errors) {
  constexpr Range pixels{0, 1e9, "px"};
  const auto dropped = step.find("dropped");
  const JsonCursor heldOut = step.at("heldOutPx");
  return {{"added", step.at("added").value().is_null() ? "" : step.at("added").text()},
          {"dropped", dropped ? json(dropped->texts()) : json::array()},
          {"rms", errors.perPx * step.at("rmsPx").number(pixels)},
          {"heldOut", heldOut.value().is_null() ? json(nullptr) : json(errors.perPx * heldOut.number(anyNumber))},
          {"floor", errors.perPx * step.at("noiseFloorPx").number(pixels)},
          {"alarm", step.at("alarm").number({0, 1, ""})}};
}

/// Adds images (capture, camera, pose), poses (set, name, images) and cameras (width, height).
void addTaken(const JsonCursor& diagnosis, json& data) {
  data["pictures"] = data["poses"] = json::array();
  data["cameras"] = json::object();
  for (const JsonCursor& picture : elementsOf(diagnosis, "pictures")) {
    data["pictures"].push_back(
        {{"capture", picture.at("capture").integer(0, maxInteger)}, {"camera", label(picture.at("camera"))}});
  }
  for (const JsonCursor& pose : elementsOf(diagnosis, "poses")) {
    json pictures = json::array();
    for (const JsonCursor& picture : pose.at("pictures").elements()) {
      pictures.push_back(indexIn(data["pictures"], picture));
      data["pictures"][pictures.back().get<std::size_t>()]["pose"] = data["poses"].size();
    }
    const JsonCursor name = pose.at("name");
    data["poses"].push_back({{"set", pose.at("set").text()},
                             {"name", name.value() == "" ? "–" : name.text()},
                             {"pictures", std::move(pictures)}});
  }
  if (const auto cameras = diagnosis.find("cameras")) {
    for (const auto& [name, camera] : cameras->members()) {
      data["cameras"][name] = {{"width", camera.at("width").integer(1, CameraIntrinsics::mostPixels)},
                               {"height", camera.at("height").integer(1, CameraIntrinsics::mostPixels)}};
    }
  }
}

} // namespace

json diagnosisData(const JsonCursor& diagnosis) {
  const ErrorUnit errors = shownErrorUnit(diagnosis);
  const auto defined = diagnosis.find("define");
  const bool own = defined && !defined->elements().empty(); // custom effect, last of the suggested ones
  json named = diagnosis.at("suggested").texts();
  if (own && !named.empty()) {
    named.erase(named.size() - 1);
  }
  json data{{"verdict", std::string{verdicts()[diagnosis.at("verdict").wordIndex(verdicts())]}},
            {"level", verdictLevel(diagnosis)},
            {"headline", verdictHeadline(diagnosis)},
            {"sentence", diagnosis.at("sentence").text()},
            {"unit", errors.name},
            {"floorName", noiseFloorName(diagnosis)},
            {"suggested", diagnosis.at("suggested").texts()},
            {"tentative", isTentative(diagnosis)},
            {"own", own},
            {"aliases", aliasesData(diagnosis)},
            {"curves", curvesData(diagnosis, named)},
            {"map", mapData(diagnosis)},
            {"kinds", kindErrorsData(diagnosis, named)},
            {"steps", json::array()},
            {"findings", findingsData(diagnosis)},
            {"leaveOut", leaveOutData(diagnosis)},
            {"facts", json::array()}};
  addTaken(diagnosis, data);
  addResidualViewsData(diagnosis, data);
  data["candidates"] = candidatesData(diagnosis, data, errors);
  for (const JsonCursor& step : diagnosis.at("steps").elements()) {
    data["steps"].push_back(stepJson(step, errors));
  }
  const auto next = diagnosis.find("next");
  if (next && !next->value().is_null() && next->at("why").value() != "") { // otherwise nothing is open
    data["next"] = {{"poses", next->at("poses").elements().size()}, {"why", next->at("why").text()}};
  }
  for (const auto& [figure, sentence] : diagnosisFacts(diagnosis, errors)) {
    data["facts"].push_back({{"figure", figure}, {"sentence", sentence}});
  }
  return data;
}

} // namespace naocal

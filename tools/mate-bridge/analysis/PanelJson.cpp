#include "analysis/PanelJson.hpp"

#include "calibration/EffectiveOffsets.hpp"
#include "calibration/result/Verdict.hpp"
#include "diagnosis/DiagnosisFile.hpp"
#include "effects/Catalogue.hpp"
#include "inference/DriverBasis.hpp"
#include "io/Units.hpp"
#include "math/Angles.hpp"
#include "math/LinearAlgebra.hpp"
#include "report/DiagnosisData.hpp"
#include "report/FindingsData.hpp"
#include "report/PageValues.hpp"
#include "report/ReadingsData.hpp"
#include "report/ResultData.hpp"
#include "report/ResultFacts.hpp"

#include <map>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

using Json = nlohmann::json;

Json driversJson(const std::vector<DriverSeries>& drivers, const Robot& robot) {
  Json list = Json::array();
  for (const DriverSeries& driver : drivers) {
    const auto [unit, scale] = displayUnit(driver.unit);
    Json values = Json::array();
    for (const double value : driver.atPicture) {
      values.push_back(roundToDecimals(scale * value, 4));
    }
    list.push_back({{"name", driver.name},
                    {"what", describeDriver(driver, robot)},
                    {"unit", unit},
                    {"values", std::move(values)}});
  }
  return list;
}

/// Index of each capture in the drivers' values, by set and id.
using CaptureIndices = std::map<std::pair<std::string, int>, std::size_t>;

CaptureIndices indicesOf(const Dataset& opened, const Measurements& measurements) {
  CaptureIndices indices;
  for (std::size_t i = 0; i < measurements.pictures.size(); ++i) {
    const CaptureSet& set = opened.sets[measurements.pictures[i].set];
    indices[{set.name, set.captures[measurements.pictures[i].capture].id}] = i;
  }
  return indices;
}

/// The captures of the readings that are no corners, in the order of those.
Json readCapturesJson(const CaptureIndices& indices, const Json& document) {
  Json list = Json::array();
  for (const Json& reading : document.value("readings", Json::array())) {
    Json capture{{"camera", ""}};
    for (const char* key : {"set", "capture", "pose", "repeat", "time"}) {
      capture[key] = reading[key];
    }
    capture["index"] = indices.at({reading["set"].get<std::string>(), reading["capture"].get<int>()});
    list.push_back(std::move(capture));
  }
  return list;
}

/// The images, worst first; `index` is their index in the drivers' values.
Json picturesJson(const CaptureIndices& indices, const JsonCursor& result) {
  Json list = Json::array();
  for (const PictureRecord& seen : readPictures(result)) {
    list.push_back(pictureJson(seen));
    list.back()["index"] = indices.at({seen.set, seen.capture});
    list.back()["kept"] = !seen.image.empty();
  }
  return list;
}

/// Settings of a robot's calibration equivalent to this fit: learned offsets that constant angles can compensate, and
/// camera mounts.
Json compensationJson(const FittedModel& fitted) {
  Json offsets = Json::array(), untold = Json::array(), mounts = Json::array();
  for (const EffectiveOffset& offset : effectiveOffsets(fitted)) {
    isLearned(offset) ? offsets.push_back({{"joint", offset.joint}, {"value", degrees(offset.value)}})
                      : untold.push_back(offset.joint);
  }
  for (const Term& term : fitted.model.terms()) {
    if (term.effect.name == effectName::cameraRotation) {
      const Eigen::Vector3d rotation = fitted.fit.unknowns.segment<3>(eigenIndex(term.first));
      mounts.push_back({{"camera", term.placeName}, {"rotation", {rotation.x(), rotation.y(), rotation.z()}}});
    }
  }
  return {{"offsets", std::move(offsets)}, {"untold", std::move(untold)}, {"mounts", std::move(mounts)}};
}

} // namespace

Json fitJson(const Json& document, const Dataset& opened, const FittedModel& fitted) {
  const JsonCursor place{document, "the fit"};
  const VerdictWords words = verdictWords(place);
  const std::vector<DriverSeries> drivers = collectDrivers(fitted.measurements, fitted.model, fitted.fit.unknowns);
  const CaptureIndices indices = indicesOf(opened, fitted.measurements);
  const ErrorUnit errors = errorUnitOf(fitted.measurements, fitted.fit.noise);
  Json fit{{"usable", fitted.fit.usable},
           {"verdict", toString(fitted.fit.verdict)},
           {"headline", words.headline},
           {"sentence", words.sentence},
           {"findings", findingsData(place)},
           {"rms", errors.perPx * fitted.fit.rmsPx},
           {"median", errors.perPx * fitted.fit.medianPx},
           {"pValue", fitted.fit.pValue},
           {"pixelNoise", fitted.fit.noise.pixel},
           {"corners", fitted.measurements.cornerCount},
           {"seconds", fitted.fit.seconds},
           {"groups", estimatesData(place.at("effects"))},
           {"terms", document["model"]["terms"]},
           {"compensation", compensationJson(fitted)}, // [deg], mounts [rad]
           {"facts", Json::array()},
           {"pictures", picturesJson(indices, place)},
           {"readings", readingsOfResult(place)},
           {"captures", readCapturesJson(indices, document)},
           {"drivers", driversJson(drivers, fitted.measurements.robot)}};
  for (const auto& [figure, sentence] : facts(place, fit["pictures"].size(), std::nullopt)) {
    fit["facts"].push_back({{"figure", figure}, {"sentence", sentence}});
  }
  return fit;
}

Json effectsJson(const std::vector<Effect>& effects) {
  Json list = Json::array();
  for (const Effect& effect : effects) {
    Json unknowns = Json::array();
    for (const Unknown& unknown : effect.unknowns) {
      const auto [unit, scale] = displayUnit(unknown.unit);
      unknowns.push_back({{"name", unknown.name}, {"unit", unit}, {"sigma", scale * unknown.sigma}});
    }
    list.push_back({{"name", effect.name},
                    {"what", effect.description},
                    {"formula", effect.formula},
                    {"own", !effect.definition.empty()},
                    {"unknowns", std::move(unknowns)}});
  }
  return list;
}

Json diagnosisPanelJson(const Diagnosis& diagnosis) {
  const Json document = diagnosisJson(diagnosis);
  return diagnosisData(JsonCursor{document, "the diagnosis"});
}

Json anglesPanelJson(const Eigen::VectorXd& angles, const Robot& robot) {
  Json list = Json::array();
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const Joint& joint = robot.joints[i];
    if (joint.motor == i) { // others follow it
      const auto [unit, scale] = displayUnit(joint.isPrismatic ? "m" : "rad");
      list.push_back(
          {{"joint", joint.name}, {"value", roundToDecimals(scale * angles[eigenIndex(i)], 3)}, {"unit", unit}});
    }
  }
  return list;
}

Json revisionPanelJson(const ModelRevision& rung, const ErrorUnit& errors) {
  Json json{{"with", rung.with}, {"without", rung.without}, {"step", rung.step}, {"rms", errors.perPx * rung.rmsPx}};
  json["from"] = rung.from ? Json(*rung.from) : Json(nullptr);
  if (rung.questioned) {
    if (rung.questioned->heldOutPx) {
      json["heldOut"] = errors.perPx * *rung.questioned->heldOutPx;
    }
    json["floor"] = errors.perPx * rung.questioned->noiseFloorPx;
    json["alarm"] = rung.questioned->alarm;
  }
  return json;
}

} // namespace naocal

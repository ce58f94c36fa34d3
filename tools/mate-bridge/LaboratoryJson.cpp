#include "LaboratoryJson.hpp"

#include "calibrate/ShownOffsets.hpp"
#include "calibrate/Verdict.hpp"
#include "diagnose/DiagnosisFile.hpp"
#include "diagnose/Drivers.hpp"
#include "geometry/Angles.hpp"
#include "geometry/Index.hpp"
#include "geometry/ShownUnit.hpp"
#include "report/DiagnosisData.hpp"
#include "report/EstimatesData.hpp"
#include "report/PictureData.hpp"
#include "report/Sentences.hpp"

#include <map>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

using Json = nlohmann::json;

Json driversJson(const std::vector<DriverValues>& drivers) {
  Json list = Json::array();
  for (const DriverValues& driver : drivers) {
    const auto [unit, scale] = shownUnit(driver.unit);
    Json values = Json::array();
    for (const double value : driver.atPicture) {
      values.push_back(withDecimals(scale * value, 4));
    }
    list.push_back({{"name", driver.name}, {"what", driver.what}, {"unit", unit}, {"values", std::move(values)}});
  }
  return list;
}

/// The pictures, worst first; `index` says where a driver has its value.
Json picturesJson(const OpenedSets& opened, const Measurements& measurements, const JsonPlace& result) {
  std::map<std::pair<std::string, int>, std::size_t> indices;
  for (std::size_t i = 0; i < measurements.pictures.size(); ++i) {
    const CaptureSet& set = opened.sets[measurements.pictures[i].set];
    indices[{set.name, set.captures[measurements.pictures[i].capture].id}] = i;
  }
  Json list = Json::array();
  for (const SeenPicture& seen : seenPictures(result)) {
    list.push_back(pictureJson(seen));
    list.back()["index"] = indices.at({seen.set, seen.capture});
    list.back()["kept"] = !seen.image.empty();
  }
  return list;
}

/// What a robot's own calibration would set of this fit: offsets that a constant angle can compensate and that the
/// captures tell, and cameras' mounts.
Json compensationJson(const Measurements& measurements, const Model& model, const CalibrationResult& result) {
  Json offsets = Json::array(), untold = Json::array(), mounts = Json::array();
  for (const ShownOffset& offset : shownOffsets(measurements, model, result)) {
    isLearned(offset) ? offsets.push_back({{"joint", offset.joint}, {"value", degrees(offset.value)}})
                      : untold.push_back(offset.joint);
  }
  for (const Term& term : model.terms()) {
    if (term.effect.name == "cameraRotation") {
      const Eigen::Vector3d rotation = result.unknowns.segment<3>(at(term.first));
      mounts.push_back({{"camera", term.place}, {"rotation", {rotation.x(), rotation.y(), rotation.z()}}});
    }
  }
  return {{"offsets", std::move(offsets)}, {"untold", std::move(untold)}, {"mounts", std::move(mounts)}};
}

} // namespace

Json fitJson(const Json& document, const OpenedSets& opened, const Measurements& measurements, const Model& model,
             const CalibrationResult& result) {
  const JsonPlace place{document, "the fit"};
  Json fit{{"usable", result.usable},
           {"headline", headline(place)},
           {"warnings", sentences(result.warnings)},
           {"rms", result.rmsPx},
           {"median", result.medianPx},
           {"pValue", result.pValue},
           {"pixelNoise", result.noise.pixel},
           {"corners", measurements.cornerCount},
           {"seconds", result.seconds},
           {"groups", estimatesData(place.at("effects"))},
           {"terms", document["model"]["terms"]},
           {"compensation", compensationJson(measurements, model, result)}, // [deg], mounts [rad]
           {"facts", Json::array()},
           {"pictures", picturesJson(opened, measurements, place)},
           {"drivers", driversJson(driversOf(measurements, model, result.unknowns))}};
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
      const auto [unit, scale] = shownUnit(unknown.unit);
      unknowns.push_back({{"name", unknown.name}, {"unit", unit}, {"sigma", scale * unknown.sigma}});
    }
    list.push_back({{"name", effect.name},
                    {"what", effect.what},
                    {"formula", effect.formula},
                    {"own", !effect.definition.empty()},
                    {"unknowns", std::move(unknowns)}});
  }
  return list;
}

Json questionsJson(const Diagnosis& diagnosis) {
  const Json document = diagnosisJson(diagnosis);
  return diagnosisData(JsonPlace{document, "the diagnosis"});
}

} // namespace naocal

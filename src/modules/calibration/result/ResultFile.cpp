#include "calibration/result/ResultFile.hpp"

#include "calibration/BoardMoves.hpp"
#include "calibration/Calibration.hpp"
#include "calibration/KnownEffects.hpp"
#include "calibration/ReadingRecords.hpp"
#include "calibration/result/PlacementFile.hpp"
#include "calibration/result/Verdict.hpp"
#include "data/SetSearch.hpp"
#include "estimation/DriverState.hpp"
#include "io/FileVersion.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "io/JsonReader.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace naocal {

using nlohmann::json;

namespace {

json pointsJson(const Eigen::Matrix2Xd& points) {
  json list = json::array();
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    list.push_back({points(0, i), points(1, i)});
  }
  return list;
}

/// Distance [m], and each number of the displacement with its sigma.
json boardMoveJson(const BoardMove& move) {
  json numbers = json::object();
  const std::vector<Unknown> unknowns = boardMoveUnknowns(move.values.size() == 3);
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    numbers[unknowns[i].name] = {{"value", move.values[at]}, {"sigma", move.sigmas[at]}, {"unit", unknowns[i].unit}};
  }
  return {{"metres", move.distance()}, {"unknowns", std::move(numbers)}};
}

/// Outliers: set, capture, board, corners and distance [px]; set, capture and what was measured of other readings.
json outliersJson(const Measurements& measurements, const CalibrationResult& result) {
  json list = json::array();
  for (const Outlier& outlier : result.outliers) {
    const ImageObservation& picture = measurements.pictures[outlier.picture];
    const CaptureSet& set = measurements.setOf(picture);
    list.push_back({{"set", set.name},
                    {"capture", set.captures[picture.capture].id},
                    {"board", measurements.targets[picture.observations[outlier.observation].view.board()].name},
                    {"corners", outlier.corners},
                    {"whole", outlier.whole},
                    {"distancePx", outlier.distance}});
    if (outlier.move) {
      list.back()["move"] = boardMoveJson(*outlier.move);
    }
  }
  for (const DoubtfulReading& reading : result.doubtfulReadings) {
    const ImageObservation& picture = measurements.pictures[reading.picture];
    list.push_back({{"set", measurements.setOf(picture).name},
                    {"capture", measurements.captureOf(picture).id},
                    {"reading", picture.witnesses[reading.witness].witness->target()}});
  }
  return list;
}

/// What lost its weight, displaced boards aside: counts, of how many, and what it shares.
json rejectedJson(const CalibrationResult& result) {
  json share = json::array();
  for (const SharedCause& cause : result.sharedCauses) {
    share.push_back({{"driver", cause.driver}, {"p", cause.p}});
  }
  return {{"corners", result.rejected.corners},
          {"readings", result.rejected.readings},
          {"of", {{"corners", result.rejected.ofCorners}, {"readings", result.rejected.ofReadings}}},
          {"share", std::move(share)}};
}

/// Every corner: measured; predicted at the joint angles as read; fitted, with the joints' deflections; and its weight.
json residualsJson(const Measurements& measurements, const CalibrationResult& result) {
  json list = json::array();
  for (std::size_t i = 0; i < result.residuals.size(); ++i) {
    const BoardResidual& seen = result.residuals[i];
    const ImageObservation& picture = measurements.pictures[seen.picture];
    const BoardObservation& observation = picture.observations[seen.observation];
    const Capture& capture = measurements.captureOf(picture);
    list.push_back({{"set", measurements.setOf(picture).name},
                    {"capture", capture.id},
                    {"pose", capture.pose},
                    {"repeat", capture.repeat},
                    {"time", capture.time.count()},
                    {"camera", capture.camera},
                    {"image", capture.image},
                    {"board", measurements.targets[observation.view.board()].name},
                    {"ids", observation.ids},
                    {"measured", pointsJson(seen.predicted + seen.residual)},
                    {"predicted", pointsJson(result.withReportedAngles[i].predicted)},
                    {"fitted", pointsJson(seen.predicted)},
                    {"weight", std::vector<double>(seen.weight.begin(), seen.weight.end())}});
  }
  return list;
}

/// Image sizes of the cameras, by set and name.
json camerasJson(const std::vector<CaptureSet>& sets) {
  json cameras;
  for (const CaptureSet& set : sets) {
    for (const auto& [name, camera] : set.cameras) {
      cameras[set.name][name] = {{"width", camera.width}, {"height", camera.height}};
    }
  }
  return cameras;
}

Noise noiseFrom(const json& entry, const std::string& file) {
  const Noise usual;
  const Noise noise{.pixel = entry.value("pixel", usual.pixel),
                    .encoder = entry.value("encoder", usual.encoder),
                    .pose = entry.value("pose", usual.pose),
                    .stance = entry.value("stance", usual.stance),
                    .reapproach = entry.value("reapproach", usual.reapproach),
                    .pixelAlike = entry.value("pixelAlike", usual.pixelAlike)};
  if (!(noise.pixel > 0 && noise.encoder >= 0 && noise.pose >= 0 && noise.stance >= 0 && noise.reapproach >= 0 &&
        noise.pixelAlike >= 0)) {
    throw InputError{
        fmt::format("{}: noise: expected a positive pixel and no negative numbers, found {}", file, entry.dump())};
  }
  return noise;
}

/// "LKneePitch" for jointOffset@LKneePitch.o; other unknowns keep their full name.
std::string shortName(const std::string& unknown) {
  constexpr std::string_view offset = "jointOffset@";
  return unknown.starts_with(offset) ? unknown.substr(offset.size(), unknown.rfind('.') - offset.size()) : unknown;
}

json anomalyJson(const DataAnomaly& anomaly) {
  json entry{{"why", anomaly.why}};
  if (anomaly.capture) {
    entry["capture"] = *anomaly.capture;
  }
  if (!anomaly.setUp.empty()) {
    entry["setUp"] = anomaly.setUp;
  }
  if (!anomaly.moved.empty()) {
    entry["moved"] = anomaly.moved;
  }
  if (anomaly.from) {
    entry["from"] = *anomaly.from;
  }
  if (anomaly.odds) {
    entry["odds"] = *anomaly.odds;
  }
  for (const EventValue& value : anomaly.values) {
    entry["values"].push_back({{"unknown", value.unknown},
                               {"value", value.value},
                               {"sigma", value.sigma > 0 ? json(value.sigma) : json(nullptr)},
                               {"interval", value.sigma > 0 ? json({value.low, value.high}) : json(nullptr)},
                               {"unit", value.unit}});
  }
  if (anomaly.when) {
    entry["time"] = anomaly.when->time;
    entry["between"] = {anomaly.when->since, anomaly.when->until};
  }
  return entry;
}

} // namespace

json averagedJson(const Averaged& averaged) {
  json result{{"value", averaged.value},
              {"sigma", averaged.sigma},
              {"interval", averaged.interval},
              {"bound", averaged.bound},
              {"shoulder", nullptr}};
  if (const auto& shoulder = averaged.shoulder) {
    result["shoulder"] = {{"effects", shoulder->effects},
                          {"without", shoulder->without},
                          {"weight", shoulder->weight},
                          {"value", shoulder->value}};
  }
  return result;
}

json taskJson(const CalibrationResult& result) {
  if (!result.task) {
    return nullptr;
  }
  return {{"what", result.task->what},
          {"unit", "m"},
          {"sigma", result.task->sigma},
          {"bound", result.task->bound},
          {"tolerance", result.task->tolerance}};
}

json suspiciousJson(const std::vector<DataAnomaly>& anomalies) {
  json list = json::array();
  std::transform(anomalies.begin(), anomalies.end(), std::back_inserter(list), anomalyJson);
  return list;
}

json undetectableJson(const CalibrationResult& result) {
  if (!result.undetectable) {
    return nullptr;
  }
  const Undetectable& worst = *result.undetectable;
  return {{"effect", worst.effect}, {"bias", {{worst.of, worst.bias}}}, {"pose", nullptr}};
}

namespace {

json effectsJson(const Model& model, const CalibrationResult& result) {
  json effects = json::array();
  for (const Term& term : model.terms()) {
    if (term.isPlacement) {
      continue;
    }
    json unknowns;
    for (std::size_t i = 0; i < term.effect.unknowns.size(); ++i) {
      const Estimate& estimate = result.estimates[term.first + i];
      unknowns[term.effect.unknowns[i].name] = {
          {"value", estimate.value},
          {"sigma", estimate.sigma},
          {"unit", term.effect.unknowns[i].unit},
          {"learned", estimate.learned},
          {"interval95", {estimate.value - estimate.halfWidth, estimate.value + estimate.halfWidth}},
          {"degreesOfFreedom", estimate.freedom}};
      if (const auto& averaged = estimate.averaged) {
        unknowns[term.effect.unknowns[i].name]["averaged"] = averagedJson(*averaged);
      }
    }
    effects.push_back({{"effect", term.effect.name}, {"at", term.placeName}, {"unknowns", std::move(unknowns)}});
  }
  return effects;
}

/// Every reading of an instrument, with its capture.
json readingsJson(const FittedModel& fitted) {
  json list = json::array();
  for (const ReadingRecord& record : recordReadings(fitted)) {
    const ImageObservation& picture = fitted.measurements.pictures[record.picture];
    const Capture& capture = fitted.measurements.captureOf(picture);
    list.push_back(toJson(record));
    list.back().update({{"set", fitted.measurements.setOf(picture).name},
                        {"capture", capture.id},
                        {"pose", capture.pose},
                        {"repeat", capture.repeat},
                        {"time", capture.time.count()}});
  }
  return list;
}

/// Standard errors of the estimated placements, keyed by "boardPlacement@A".
json placementSigmasJson(const Model& model, const CalibrationResult& result) {
  json sigmas = json::object();
  for (const Term& term : model.terms()) {
    for (std::size_t i = 0; i < term.effect.unknowns.size() && term.isPlacement; ++i) {
      sigmas[term.label()][term.effect.unknowns[i].name] = result.estimates[term.first + i].sigma;
    }
  }
  return sigmas;
}

json weakJson(const CalibrationResult& result) {
  json weak = json::array();
  for (const WeakDirection& direction : result.weak) {
    json parts;
    for (const auto& [name, share] : direction.parts) {
      parts[shortName(name)] = share;
    }
    weak.push_back({{"direction", std::move(parts)},
                    {"sigma", direction.sigma},
                    {"unit", direction.unit},
                    {"sentence", direction.sentence}});
  }
  return weak;
}

/// Possible explanations and their weights.
json explanationsJson(const CalibrationResult& result) {
  json list = json::array();
  for (const Explanation& explanation : result.explanations) {
    list.push_back({{"effects", explanation.effects}, {"weight", explanation.weight}});
    if (!explanation.without.empty()) {
      list.back()["without"] = explanation.without;
    }
  }
  return list;
}

/// Root mean square of the encoder jitter over the joints in use [rad].
double jitterOf(const Measurements& measurements) {
  double squares = 0;
  for (const std::size_t joint : measurements.joints) {
    squares += measurements.jitter[joint] * measurements.jitter[joint];
  }
  return std::sqrt(squares / std::max<double>(1, static_cast<double>(measurements.joints.size())));
}

/// The user-defined effects of the model, without duplicates, so that readers of the result can predict with it.
json definitions(const Model& model) {
  json list = json::array();
  for (const Term& term : model.terms()) {
    if (!term.effect.definition.empty()) {
      json definition = json::parse(term.effect.definition);
      if (std::find(list.begin(), list.end(), definition) == list.end()) {
        list.push_back(std::move(definition));
      }
    }
  }
  return list;
}

} // namespace

json setUpsJson(const std::vector<WrongSetUp>& setUps) {
  json list = json::array();
  for (const WrongSetUp& setUp : setUps) {
    list.push_back({{"setUp", setUp.label},
                    {"why", setUp.why},
                    {"question", setUp.question},
                    {"odds", setUp.odds > 0 ? json(setUp.odds) : json(nullptr)}});
  }
  return list;
}

void ResultSources::add(const std::filesystem::path& folder) {
  sets.push_back(std::filesystem::weakly_canonical(folder).string());
  sha256.push_back(naocal::sha256(readFile(folder / "captures.json")));
  names.push_back(std::filesystem::canonical(folder).filename().string());
}

ResultSources ResultSources::placedBeside(const std::filesystem::path& file) const {
  ResultSources placed = *this;
  for (std::string& set : placed.sets) {
    set = file.empty() || file == "-" ? set : placeFrom(set, file.parent_path());
  }
  return placed;
}

json toJson(const ResultSources& sources) {
  json inputs{{"sets", sources.sets}, {"sha256", sources.sha256}};
  if (!sources.names.empty()) {
    inputs["names"] = sources.names;
  }
  if (!sources.setUps.empty()) {
    inputs["setUps"] = sources.setUps;
  }
  return inputs;
}

void requireEstimates(const json& all, const std::string& name) {
  const bool isResult = all.is_object() && all.value("format", json{}) == "naocal-result";
  if (isResult && !all.contains("model") && all.contains("setUps")) {
    throw InputError{fmt::format("{}: expected a result with estimates, found one of captures that could not be fitted "
                                 "as they are: {} Mend that first",
                                 name, all.value("sentence", ""))};
  }
}

StoredResult parseResult(const json& all, const std::string& name) {
  requireEstimates(all, name);
  try {
    if (all.value("format", "") != "naocal-result") {
      throw InputError{fmt::format("{}: format: expected \"naocal-result\", as 'naocal solve' writes it, found {}",
                                   name, all.value("format", "none"))};
    }
    requireVersion(JsonCursor{all, name});
    StoredResult result;
    result.usable = all.at("usable").get<bool>();
    result.robot = all.contains("model") ? all["model"].value("robot", result.robot) : result.robot;
    result.sentence = all.value("sentence", "");
    result.reasons = all.value("reasons", std::vector<std::string>{});
    result.hasReasons = all.contains("reasons");
    if (all.contains("inputs")) {
      result.inputs = {all["inputs"].value("sets", std::vector<std::string>{}),
                       all["inputs"].value("sha256", std::vector<std::string>{}),
                       all["inputs"].value("names", std::vector<std::string>{}),
                       all["inputs"].value("setUps", std::vector<std::string>{})};
    }
    if (all.contains("model") && all["model"].contains("define")) {
      result.definitions = all["model"]["define"].dump();
    }
    result.noise = noiseFrom(all.value("noise", json::object()), name);
    requireKnownEffects(all, name);
    for (const json& effect : all.at("effects")) {
      const std::string label = effect.at("effect").get<std::string>() + "@" + effect.at("at").get<std::string>();
      result.terms.push_back(label);
      for (const auto& [key, unknown] : effect.at("unknowns").items()) {
        result.values[label + "." + key] = unknown.at("value").get<double>();
        result.learned[label + "." + key] = unknown.value("learned", 1.0);
      }
    }
    result.placements = parsePlacements(all.at("placements"));
    return result;
  } catch (const json::exception& error) {
    throw InputError{fmt::format("{}: not a result file as 'naocal solve' writes it: {}", name, error.what())};
  }
}

StoredResult readResult(const std::filesystem::path& file) {
  return parseResult(parseJson(readFile(file), file.string()), file.string());
}

json resultJson(const FittedModel& fitted, const ResultSources& inputs) {
  std::vector<std::string> terms;
  for (const Term& term : fitted.model.terms()) {
    if (!term.isPlacement) {
      terms.push_back(term.label());
    }
  }
  const bool hasCorners = fitted.measurements.cornerCount > 0;
  json result =
      withFormat("naocal-result",
                 {{"converged", fitted.fit.converged},
                  {"verdict", toString(fitted.fit.verdict)},
                  {"usable", fitted.fit.usable},
                  {"sentence", fitted.fit.sentence},
                  {"setUps", setUpsJson(fitted.fit.setUps)},
                  {"findings", toJson(fitted.fit.findings)},
                  {"warnings", sentencesOf(furtherFindings(fitted.fit.findings))},
                  {"rmsPx", hasCorners ? fitted.fit.rmsPx : 0},
                  {"medianPx", hasCorners ? fitted.fit.medianPx : 0},
                  {"noiseFloorPx", fitted.fit.noiseFloorPx},
                  {"chi2", fitted.fit.chi2},
                  {"dof", fitted.fit.dof},
                  {"pValue", fitted.fit.pValue},
                  {"sigmaScale", fitted.fit.sigmaScale},
                  {"misfit", fitted.fit.misfit},
                  {"misfitLeft", fitted.fit.misfitLeft},
                  {"explanations", explanationsJson(fitted.fit)},
                  {"corners", fitted.measurements.cornerCount},
                  {"captures", fitted.measurements.pictures.size()},
                  {"noise",
                   {{"pixel", fitted.fit.noise.pixel},
                    {"encoder", fitted.fit.noise.encoder},
                    {"pose", fitted.fit.noise.pose},
                    {"stance", fitted.fit.noise.stance},
                    {"reapproach", fitted.fit.noise.reapproach},
                    {"pixelAlike", fitted.fit.noise.pixelAlike},
                    {"jitter", jitterOf(fitted.measurements)},
                    {"source", fitted.fit.noiseSource}}},
                  {"effects", effectsJson(fitted.model, fitted.fit)},
                  {"placements", placementsJson(fitted)},
                  {"placementSigmas", placementSigmasJson(fitted.model, fitted.fit)},
                  {"weak", weakJson(fitted.fit)},
                  {"doubtful", outliersJson(fitted.measurements, fitted.fit)},
                  {"task", taskJson(fitted.fit)},
                  {"undetectable", undetectableJson(fitted.fit)},
                  {"iterations", fitted.fit.iterations},
                  {"restarts", {{"tried", fitted.fit.restartsTried}, {"changedTheAnswer", fitted.fit.restartsChanged}}},
                  {"seconds", fitted.fit.seconds},
                  {"inputs", toJson(inputs)},
                  {"model",
                   {{"robot", fitted.measurements.robot.model},
                    {"terms", std::move(terms)},
                    {"define", definitions(fitted.model)}}},
                  {"cameras", camerasJson(*fitted.measurements.sets)},
                  {"sightings", residualsJson(fitted.measurements, fitted.fit)}});
  result["reasons"] = reasonsAgainstUse(fitted.fit.findings);
  result["suspicious"] = suspiciousJson(fitted.fit.suspicious);
  result["rejected"] = rejectedJson(fitted.fit);
  if (fitted.fit.negligible) {
    result["negligible"] = {{"label", fitted.fit.negligible->label},
                            {"sizes", fitted.fit.negligible->sizes},
                            {"movedPx", fitted.fit.negligible->movedPx}};
  }
  if (fitted.measurements.hasUnknownSteps()) {
    result["noise"]["unknownSteps"] = true;
  }
  if (const ErrorUnit unit = errorUnitOf(fitted.measurements, fitted.fit.noise); unit.perPx != 1) {
    result["errorUnit"] = toJson(unit);
  }
  if (fitted.measurements.witnessCount > 0) {
    result.update(toJson(fitted.fit.readings));
    result["noise"]["readings"] = toJson(readingLevels(fitted.measurements, fitted.fit.noise));
    result["readings"] = readingsJson(fitted);
  }
  return result;
}

} // namespace naocal

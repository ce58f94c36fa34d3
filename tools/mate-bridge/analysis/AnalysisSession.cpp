#include "analysis/AnalysisSession.hpp"

#include "analysis/PanelJson.hpp"
#include "calibration/Prediction.hpp"
#include "calibration/result/ResultFile.hpp"
#include "diagnosis/CheckedCalibration.hpp"
#include "diagnosis/DiagnosisFile.hpp"
#include "diagnosis/DiagnosisWording.hpp"
#include "diagnosis/Session.hpp"
#include "effects/UserEffect.hpp"
#include "estimation/CandidateTerms.hpp"
#include "estimation/ModelBuilder.hpp"
#include "estimation/ModelFile.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "poses/PoseFile.hpp"
#include "report/ReadingsData.hpp"
#include "report/ReportPage.hpp"
#include "robot/LegKinematics.hpp"
#include "scenes/SceneNextPoses.hpp"
#include "setups/Mending.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace naocal {

namespace {

using Json = nlohmann::json;

std::vector<std::string> without(const std::vector<std::string>& labels, const std::vector<std::string>& others) {
  std::vector<std::string> rest;
  std::copy_if(labels.begin(), labels.end(), std::back_inserter(rest), [&](const std::string& label) {
    return std::find(others.begin(), others.end(), label) == others.end();
  });
  return rest;
}

/// The initial revision: the base model, or the model of the opened result.
ModelRevision initialRevision(const Dataset& opened, const Measurements& measurements) {
  if (opened.terms.empty()) {
    return {.with = opened.with, .without = opened.without, .definitions = opened.definitions};
  }
  const std::vector<std::string> base = termLabels(buildModel(measurements));
  std::vector<std::string> with = without(opened.terms, base);
  // the base model has every selectable offset; the others are included because torques depend on them
  std::erase_if(with, [](const std::string& label) { return label.starts_with("jointOffset@"); });
  with.insert(with.end(), opened.inputs.setUps.begin(), opened.inputs.setUps.end());
  return {.with = std::move(with), .without = without(base, opened.terms), .definitions = opened.definitions};
}

/// Calibrates. Where no fit is possible, throws InputError with the set-up error that a diagnosis suspects, if any.
CalibrationResult calibrateOrSuspect(const Measurements& measurements, const Model& model,
                                     const CalibrationOptions& options) {
  try {
    return calibrateChecked(measurements, model, options);
  } catch (const WrongSetUpError& error) {
    throw InputError{fmt::format("{} These captures cannot be fitted as they are: mend them with 'naocal solve SET "
                                 "--with {} -o result.json'. Then open that result here.",
                                 error.what(), fmt::join(labelsOf(error.setUps), ","))};
  }
}

} // namespace

AnalysisSession::AnalysisSession(Dataset opened, MessageSink tell)
    : opened_{std::move(opened)}, measurements_{std::make_shared<const Measurements>(
                                      buildMeasurements(opened_.sets, opened_.robot))},
      mended_{measurements_, {}, {}}, tell_{std::move(tell)},
      session_{opened_.ladder.empty() ? std::vector{initialRevision(opened_, *measurements_)} : opened_.ladder,
               opened_.at, opened_.inputs} {
  tellSet(session_.current());
}

std::vector<Effect> AnalysisSession::effects(const ModelRevision& rung) const {
  return parseEffects(Json::parse(rung.definitions), definitionsName, opened_.robot);
}

void AnalysisSession::tellSet(const ModelRevision& rung) {
  if (toldDefinitions_ == rung.definitions) {
    return;
  }
  toldDefinitions_ = rung.definitions;
  Json joints = Json::array();
  for (const Joint& joint : opened_.robot.joints) {
    joints.push_back(joint.name);
  }
  tell_("set", {{"names", opened_.inputs.sets},
                {"result", opened_.result},
                {"robot", measurements_->robot.model},
                {"headId", opened_.sets.front().headId},
                {"bodyId", opened_.sets.front().bodyId},
                {"pictures", measurements_->pictures.size()},
                {"poses", measurements_->poses.size()},
                {"corners", measurements_->cornerCount},
                {"readings", measurements_->witnessCount},
                {"isNao", hasPlannableLegs(opened_.robot)},
                {"joints", std::move(joints)},
                {"own", Json::parse(rung.definitions)},
                {"effects", effectsJson(effects(rung))}});
}

void AnalysisSession::tellLadder() const {
  Json rungs = Json::array();
  for (const ModelRevision& rung : session_.ladder) {
    rungs.push_back(revisionPanelJson(rung, errors_));
  }
  tell_("ladder", {{"at", session_.at}, {"unit", errors_.name}, {"rungs", std::move(rungs)}});
}

void AnalysisSession::keepSession() const {
  if (!opened_.sessionFile.empty()) {
    Session kept = session_;
    kept.inputs = session_.inputs.placedBeside(opened_.sessionFile);
    writeAtomically(opened_.sessionFile, sessionJson(kept).dump(2) + "\n");
  }
}

void AnalysisSession::fit() {
  enter(session_);
}

/// Fits the session's current model, then makes the session current; strong exception guarantee.
void AnalysisSession::enter(Session session) {
  ModelRevision& rung = session.current();
  MendedMeasurements mended = mendMeasurements(measurements_, rung.with);
  const Measurements& measurements = *mended.measurements;
  const Model model = buildModel(measurements, mended.effects, rung.without, effects(rung));
  const CalibrationResult result = calibrateOrSuspect(measurements, model, {.effects = effects(rung)});
  rung.rmsPx = result.rmsPx;
  errors_ = errorUnitOf(measurements, result.noise);
  ResultSources inputs = opened_.inputs;
  inputs.setUps = mended.setUps;
  const Json document = resultJson({measurements, model, result}, inputs);
  Json told = fitJson(document, opened_, {measurements, model, result});
  told["with"] = rung.with;
  told["without"] = rung.without;
  told["candidates"] = testableTerms(measurements, model, effects(rung)).size();
  result_ = document;
  session_ = std::move(session);
  mended_ = std::move(mended);
  told["labels"] = terms();
  diagnosis_.reset();
  next_.reset();
  tellSet(session_.current());
  tellLadder();
  tell_("fit", told);
  keepSession();
}

std::vector<std::string> AnalysisSession::terms() const {
  const ModelRevision& rung = session_.current();
  return termLabels(mended_, rung.without, effects(rung));
}

void AnalysisSession::add(const std::vector<std::string>& labels) {
  Session session = session_;
  session.add(labels, [this] { return terms(); });
  enter(std::move(session));
}

void AnalysisSession::drop(const std::string& label) {
  Session session = session_;
  session.drop(label, [this] { return terms(); });
  enter(std::move(session));
}

void AnalysisSession::goTo(std::size_t number) {
  Session session = session_;
  session.goTo(number);
  enter(std::move(session));
}

DiagnosisOptions AnalysisSession::options(const ModelRevision& rung) const {
  DiagnosisOptions result;
  result.with = mended_.effects;
  result.without = rung.without;
  result.calibration.effects = effects(rung);
  return result;
}

void AnalysisSession::search(const GoesOn& goesOn) {
  if (!diagnosis_) {
    DiagnosisOptions asked = options(session_.current());
    asked.shouldContinue = [&](std::size_t found) { return goesOn(found) ? true : throw SearchEnded{}; };
    diagnosis_ = diagnose(*mended_.measurements, asked);
  }
  if (!diagnosis_->steps.empty()) {
    session_.current().questioned = diagnosis_->given;
    tellLadder();
  }
  tell_("diagnosis", diagnosisPanelJson(*diagnosis_));
  keepSession();
}

const Diagnosis& AnalysisSession::diagnosis(const GoesOn& goesOn) {
  if (!diagnosis_) {
    search(goesOn);
  }
  return *diagnosis_;
}

void AnalysisSession::defineEffect(const Json& effect) {
  const Effect made = parseUserEffect(JsonCursor{effect, definitionsName}, opened_.robot);
  ModelRevision rung = session_.current();
  Json kept = Json::array();
  for (Json& other : Json::parse(rung.definitions)) {
    if (other["name"] != made.name) {
      kept.push_back(std::move(other));
    }
  }
  kept.push_back(effect);
  rung.definitions = kept.dump();
  const std::string at = effect["at"].get<std::string>(), label = made.name + "@" + at;
  const auto isIt = [&](const std::string& other) { return other.starts_with(made.name + "@"); };
  const bool isIn = std::any_of(rung.with.begin(), rung.with.end(), isIt);
  const std::string step = isIn        ? "changed " + made.name
                           : at == "*" ? made.name + " offered at every joint"
                                       : "+ " + label;
  if (at != "*") { // replaces the previous place
    std::erase_if(rung.with, isIt);
    rung.with.push_back(label);
  }
  Session session = session_;
  session.revise(std::move(rung), step);
  enter(std::move(session));
}

Json AnalysisSession::checkEffect(const Json& effect) const {
  try {
    const Effect made = parseUserEffect(JsonCursor{effect, definitionsName}, opened_.robot);
    const std::vector<Effect> all = parseEffects(Json::array({effect}), definitionsName, opened_.robot);
    if (effect["at"] != "*") {
      buildModel(*measurements_, {fmt::format("{}@{}", made.name, effect["at"].get<std::string>())}, {}, all);
    }
    return {{"ok", true}};
  } catch (const CorrectionError& error) {
    return {{"ok", false}, {"sentence", error.what()}, {"letter", error.letter}};
  } catch (const InputError& error) {
    return {{"ok", false}, {"sentence", error.what()}};
  }
}

void AnalysisSession::proposePoses(std::size_t count, const GoesOn& goesOn) {
  NextPosesOptions wanted;
  wanted.count = count;
  next_ = proposeSceneNextPoses(*mended_.measurements, diagnosis(goesOn), options(session_.current()), wanted);
  Json told = nextPosesJson(*next_, opened_.robot);
  for (std::size_t i = 0; i < next_->poses.size(); ++i) {
    told["poses"][i]["angles"] = anglesPanelJson(next_->poses[i].pose.angles, opened_.robot);
  }
  told["whyNone"] = next_->whyNone;
  told["whatTheyTell"] = whatTheyTell(*next_);
  told["howToTake"] = howToTake(*next_);
  tell_("next", told);
}

void AnalysisSession::compareWith(const Dataset& others) {
  const StoredResult stored = parseResult(result_, "result.json");
  std::vector<CaptureSet> sets = others.sets;
  std::vector<std::string> setUps = mended_.setUps;
  Robot robot = opened_.robot;
  mendSetUps(setUps, robot, sets);
  Json told = comparisonJson(compare(stored, sets, robot, false));
  told["kinds"] = comparedKindsData(JsonCursor{told, "the comparison"});
  told["names"] = others.inputs.sets;
  tell_("compared", told);
}

std::string AnalysisSession::generateFile(const std::string& name, const GoesOn& goesOn) {
  if (name == "result.json") {
    return result_.dump(2) + "\n";
  }
  if (name == "session.json") {
    return sessionJson(session_).dump(2) + "\n";
  }
  if (name == "report.html") {
    return renderReport(result_, name);
  }
  if (name == "model.json") {
    const ModelRevision& rung = session_.current();
    return modelFileJson(rung.with, rung.without, Json::parse(rung.definitions)).dump(2) + "\n";
  }
  if (name == "poses.json") {
    if (!next_ || next_->poses.empty()) {
      throw InputError{"no poses were proposed for this model yet; ask for them first"};
    }
    return posesJson(*next_, opened_.robot).dump(2) + "\n";
  }
  if (name != "diagnosis.json" && name != "diagnosis.html") {
    throw InputError{fmt::format("there is no file {} to be made", name)};
  }
  Json document = diagnosisJson(diagnosis(goesOn));
  if (next_) {
    document["next"] = nextPosesJson(*next_, opened_.robot);
  }
  document["inputs"] = toJson(opened_.inputs);
  return name == "diagnosis.json" ? document.dump(2) + "\n" : renderReport(document, name);
}

} // namespace naocal

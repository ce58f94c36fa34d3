#include "commands/explore/ExploreLoop.hpp"

#include "console/OutputFiles.hpp"
#include "console/print/PrintComparison.hpp"
#include "console/print/PrintDiagnosis.hpp"
#include "console/print/PrintFindings.hpp"
#include "console/print/PrintText.hpp"

#include "calibration/Prediction.hpp"
#include "diagnosis/CheckedCalibration.hpp"
#include "diagnosis/DiagnosisWording.hpp"
#include "estimation/ModelBuilder.hpp"
#include "estimation/ModelFile.hpp"
#include "io/InputError.hpp"
#include "poses/PoseFile.hpp"
#include "scenes/SceneNextPoses.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <utility>

namespace naocal {

namespace {

using Json = nlohmann::json;

/// Merges two lists of definitions; `definitions` takes precedence for equal names.
std::string joined(const std::string& definitions, const std::string& others) {
  Json all = Json::parse(definitions);
  const Json further = Json::parse(others);
  for (const Json& one : further) {
    if (std::none_of(all.begin(), all.end(), [&](const Json& has) { return has["name"] == one["name"]; })) {
      all.push_back(one);
    }
  }
  return all.dump();
}

std::string modelWords(const ModelRevision& rung) {
  std::string words = rung.with.empty() ? "base model" : fmt::format("+ {}", fmt::join(rung.with, " + "));
  return rung.without.empty() ? words : fmt::format("{}, without {}", words, fmt::join(rung.without, ", "));
}

} // namespace

ExploreLoop::ExploreLoop(const LoadedSets& given, ModelRevision first, Files files)
    : given_{given}, measurements_{std::make_shared<const Measurements>(buildMeasurements(given.sets, given.robot))},
      files_{std::move(files)}, withInFile_{first.with} {
  if (!files_.session.empty() && std::filesystem::exists(files_.session)) {
    session_ = readSession(files_.session);
    requireSameCaptures(session_, given_.inputs, files_.session);
    for (ModelRevision& rung : session_.ladder) {
      parseEffects(Json::parse(rung.definitions), files_.session, given_.robot); // throws for invalid definitions
      rung.definitions = joined(rung.definitions, first.definitions);
    }
    session_.current() = questioned(session_.current());
  } else {
    session_.inputs = given_.inputs;
    session_.ladder.push_back(questioned(std::move(first)));
  }
  save();
}

std::vector<Effect> ExploreLoop::effects(const ModelRevision& rung) const {
  return parseEffects(Json::parse(rung.definitions), "the person's own effects", given_.robot);
}

ModelRevision ExploreLoop::questioned(ModelRevision rung) {
  MendedMeasurements mended = mendMeasurements(measurements_, rung.with);
  Diagnosis diagnosis = diagnose(*mended.measurements, options(rung, mended));
  if (diagnosis.steps.empty()) {
    throw InputError{summarizeUnfitted(diagnosis)};
  }
  latest_ = std::move(diagnosis);
  mended_ = std::move(mended);
  rung.rmsPx = latest_.given.rmsPx;
  rung.questioned = latest_.given;
  return rung;
}

DiagnosisOptions ExploreLoop::options(const ModelRevision& rung, const MendedMeasurements& mended) const {
  DiagnosisOptions options{.with = mended.effects, .without = rung.without};
  options.calibration.effects = effects(rung);
  return options;
}

/// Labels of the current model's terms and of the set-ups that it mends.
std::vector<std::string> ExploreLoop::terms() const {
  const ModelRevision& rung = session_.current();
  return termLabels(mended_, rung.without, effects(rung));
}

/// Changes a copy of the session, fits its current model and keeps it; strong exception guarantee.
void ExploreLoop::change(const std::function<void(Session&)>& change) {
  Session session = session_;
  change(session);
  session.current() = questioned(session.current());
  session_ = std::move(session);
  save();
}

void ExploreLoop::add(const std::string& label) {
  change([&](Session& session) { session.add({label}, [this] { return terms(); }); });
}

void ExploreLoop::drop(const std::string& label) {
  change([&](Session& session) { session.drop(label, [this] { return terms(); }); });
}

void ExploreLoop::undo() {
  change([](Session& session) { session.undo(); });
}

void ExploreLoop::redo() {
  change([](Session& session) { session.redo(); });
}

void ExploreLoop::goTo(std::size_t revision) {
  change([&](Session& session) { session.goTo(revision); });
}

std::vector<std::string> ExploreLoop::candidates() const {
  std::vector<std::string> labels;
  for (const DataAnomaly& anomaly : latest_.anomalies) {
    if (!anomaly.setUp.empty()) {
      labels.push_back(anomaly.setUp);
    }
  }
  for (const CandidateFinding& finding : latest_.ranking) {
    labels.push_back(finding.term.label());
  }
  return labels;
}

std::string ExploreLoop::labelOf(const std::string& word) const {
  if (word.empty() || word.find_first_not_of("0123456789") != std::string::npos) {
    return word;
  }
  const std::size_t row = word.size() > 6 ? 0 : std::stoul(word);
  if (row < 1 || row > latest_.ranking.size()) {
    throw InputError{fmt::format("expected a row from 1 to {}, found {}", latest_.ranking.size(), word)};
  }
  return latest_.ranking[row - 1].term.label();
}

void ExploreLoop::printLadder() const {
  const auto words = [&](double error) {
    return fmt::format("{:6.3f} {}", latest_.unit.perPx * error, latest_.unit.name);
  };
  printText("  {:>3}  {:>9}  {:>9}  {:>9}  {:>7}  model (*: current)\n", "", "rms", "held-out", "floor", "chance");
  for (std::size_t i = 0; i < session_.ladder.size(); ++i) {
    const ModelRevision& rung = session_.ladder[i];
    const auto& step = rung.questioned;
    const std::string heldOut = step && step->heldOutPx ? words(*step->heldOutPx) : "-";
    printText("{} {:>3}  {}  {:>9}  {:>9}  {:>7}  {}\n", i == session_.at ? '*' : ' ', i, words(rung.rmsPx), heldOut,
              step ? words(step->noiseFloorPx) : "-", step ? fmt::format("{:7.3f}", step->alarm) : "-",
              modelWords(rung));
  }
  if (!latest_.fit.readings.empty()) {
    printText("  readings, rms with the current model: {}\n", formatSizes(latest_.fit.readings));
  }
}

void ExploreLoop::printCandidates(std::size_t rows) const {
  printFindings(latest_.findings);
  for (const std::string& setUp : mendableSetUps(latest_)) {
    printText("mend it: add {}\n", setUp);
  }
  naocal::printCandidates(latest_, rows, true);
}

void ExploreLoop::printCandidate(const std::string& label) const {
  const auto found = std::find_if(latest_.ranking.begin(), latest_.ranking.end(),
                                  [&](const CandidateFinding& finding) { return finding.term.label() == label; });
  if (found == latest_.ranking.end()) {
    throw InputError{fmt::format("expected a candidate, found \"{}\"; near it are {}", label,
                                 fmt::join(closestNames(label, candidates()), ", "))};
  }
  naocal::printCandidate(*found, latest_);
}

GivenOptions ExploreLoop::asked() const {
  std::vector<std::string> with = session_.current().with;
  std::erase_if(with, [&](const std::string& label) {
    return std::find(withInFile_.begin(), withInFile_.end(), label) != withInFile_.end();
  });
  return {session_.inputs.sets, std::move(with), session_.current().without, files_.model, false, false};
}

Json ExploreLoop::solvedJson(const ResultSources& inputs) const {
  const ModelRevision& rung = session_.current();
  const Measurements& measurements = *mended_.measurements;
  const Model model = buildModel(measurements, mended_.effects, rung.without, effects(rung));
  const CalibrationResult result = calibrateChecked(measurements, model, {.effects = effects(rung)});
  return resultJson({measurements, model, result}, inputs);
}

void ExploreLoop::printWhere() const {
  const Comparison comparison =
      compare(parseResult(solvedJson({}), "the current model"), *mended_.measurements->sets, given_.robot, true);
  printText("the current model, joint angles as read:\n");
  printComparison(comparison);
  printWorstPoses(comparison);
}

void ExploreLoop::saveResult(const std::string& file) const {
  ResultSources inputs = session_.inputs;
  inputs.setUps = mended_.setUps;
  writeJson(solvedJson(inputs.placedBeside(file)), file);
  printText("  written to {}; look at it:  naocal report {}\n", file, file);
}

void ExploreLoop::proposePoses(const std::string& file) const {
  NextPosesOptions options;
  options.count = file.empty() ? 0 : options.count;
  const NextPoses next =
      proposeSceneNextPoses(*mended_.measurements, latest_, this->options(session_.current(), mended_), options);
  if (!file.empty() && !next.poses.empty()) {
    writeJson(posesJson(next, given_.robot), file);
  }
  if (!next.whyNone.empty()) {
    printText("  no poses are proposed: {}\n", next.whyNone);
  } else if (next.why.empty()) {
    printText("  nothing is open that poses could answer\n");
  } else {
    printNextPoses(next, asked(), file);
  }
}

void ExploreLoop::save() const {
  if (!files_.session.empty()) {
    Session kept = session_;
    kept.inputs = session_.inputs.placedBeside(files_.session);
    writeJson(sessionJson(kept), files_.session);
  }
}

} // namespace naocal

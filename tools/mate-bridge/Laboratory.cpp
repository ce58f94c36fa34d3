#include "Laboratory.hpp"

#include "LaboratoryJson.hpp"

#include "calibration/ResultFile.hpp"
#include "estimation/ModelBuilder.hpp"
#include "estimation/ModelFile.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

using Json = nlohmann::json;

} // namespace

Laboratory::Laboratory(OpenedSets opened, Tell tell)
    : opened_{std::move(opened)}, measurements_{measurementsOf(opened_.sets, opened_.robot)}, tell_{std::move(tell)},
      rungs_{opened_.ladder.empty() ? std::vector{firstRung(opened_, measurements_)} : opened_.ladder},
      at_{opened_.at} {
  tellSet(rungs_[at_]);
}

std::vector<Effect> Laboratory::effects(const Rung& rung) const {
  return effectsWith(Json::parse(rung.definitions), definitionsName, opened_.robot);
}

void Laboratory::tellSet(const Rung& rung) {
  if (toldDefinitions_ == rung.definitions) {
    return;
  }
  toldDefinitions_ = rung.definitions;
  Json joints = Json::array();
  for (const Joint& joint : opened_.robot.joints) {
    joints.push_back(joint.name);
  }
  tell_("set", {{"names", opened_.inputs.sets},
                {"robot", measurements_.robot.model},
                {"headId", opened_.sets.front().headId},
                {"bodyId", opened_.sets.front().bodyId},
                {"pictures", measurements_.pictures.size()},
                {"poses", measurements_.poses.size()},
                {"corners", measurements_.cornerCount},
                {"joints", std::move(joints)},
                {"own", Json::parse(rung.definitions)},
                {"effects", effectsJson(effects(rung))}});
}

void Laboratory::tellLadder() const {
  Json rungs = Json::array();
  for (const Rung& rung : rungs_) {
    rungs.push_back(rungForPanel(rung));
  }
  tell_("ladder", {{"at", at_}, {"rungs", std::move(rungs)}});
}

Session Laboratory::session() const {
  return {rungs_, at_, opened_.inputs};
}

void Laboratory::keepSession() const {
  if (!opened_.sessionFile.empty()) {
    writeAtomically(opened_.sessionFile, sessionJson(session()).dump(2) + "\n");
  }
}

void Laboratory::fit() {
  stand(rungs_, at_);
}

/// Stands on one of these rungs once its fit has come out well; whatever is thrown before leaves everything as it was.
void Laboratory::stand(std::vector<Rung> rungs, std::size_t at) {
  Rung& rung = rungs.at(at);
  const Model model = makeModel(measurements_, rung.with, rung.without, effects(rung));
  const CalibrationResult result = calibrate(measurements_, model);
  rung.rmsPx = result.rmsPx;
  const Json document = resultJson(opened_.sets, measurements_, model, result, opened_.inputs);
  Json told = fitJson(document, opened_, measurements_, model, result);
  told["with"] = rung.with;
  told["without"] = rung.without;
  told["labels"] = labelsOf(model);
  told["candidates"] = testableTerms(measurements_, model, effects(rung)).size();
  result_ = document;
  rungs_ = std::move(rungs);
  at_ = at;
  diagnosis_.reset();
  next_.reset();
  tellSet(rungs_[at_]);
  tellLadder();
  tell_("fit", told);
  keepSession();
}

/// What was undone is forgotten.
void Laboratory::go(Rung rung) {
  std::vector<Rung> rungs{rungs_.begin(), rungs_.begin() + static_cast<std::ptrdiff_t>(at_) + 1};
  rung.questioned.reset();
  rung.from = at_;
  rungs.push_back(std::move(rung));
  stand(std::move(rungs), at_ + 1);
}

void Laboratory::add(const std::string& label) {
  Rung rung = rungs_[at_];
  rung.step = "+ " + label;
  if (contains(rung.with, label)) {
    throw InputError{fmt::format("{} is in the model already", label)};
  }
  if (std::erase(rung.without, label) == 0) {
    rung.with.push_back(label);
  }
  go(std::move(rung));
}

void Laboratory::drop(const std::string& label) {
  Rung rung = rungs_[at_];
  rung.step = "− " + label;
  if (std::erase(rung.with, label) == 0) {
    if (!contains(labelsOf(makeModel(measurements_, rung.with, rung.without, effects(rung))), label)) {
      throw InputError{fmt::format("{} is not in the model", label)};
    }
    rung.without.push_back(label);
  }
  go(std::move(rung));
}

void Laboratory::goTo(std::size_t rung) {
  if (rung >= rungs_.size()) {
    throw InputError{"there is no such step in the history"};
  }
  stand(rungs_, rung);
}

DiagnosisOptions Laboratory::options(const Rung& rung) const {
  DiagnosisOptions result;
  result.with = rung.with;
  result.without = rung.without;
  result.effects = effects(rung);
  return result;
}

const Diagnosis& Laboratory::diagnosis() {
  if (!diagnosis_) {
    DiagnosisOptions asked = options(rungs_[at_]);
    asked.grow = false;
    diagnosis_ = diagnose(opened_.sets, measurements_, asked);
  }
  return *diagnosis_;
}

void Laboratory::question() {
  const Diagnosis& here = diagnosis();
  if (!here.steps.empty()) {
    rungs_[at_].questioned = here.steps.front();
    tellLadder();
  }
  tell_("questions", questionsJson(here));
  keepSession();
}

void Laboratory::search(const std::function<bool()>& goesOn) {
  DiagnosisOptions asked = options(rungs_[at_]);
  asked.goesOn = goesOn;
  Json found = questionsJson(diagnose(opened_.sets, measurements_, asked));
  found["stopped"] = !goesOn();
  found["with"] = rungs_[at_].with; // of the model that it began with
  tell_("found", found);
}

} // namespace naocal

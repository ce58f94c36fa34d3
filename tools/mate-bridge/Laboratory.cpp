#include "Laboratory.hpp"

#include "LaboratoryJson.hpp"

#include "calibrate/ResultFile.hpp"
#include "captures/InputError.hpp"
#include "effects/UserEffect.hpp"
#include "residuals/ModelFile.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

using Json = nlohmann::json;

constexpr const char* definitionsName = "your own effects";

} // namespace

Laboratory::Laboratory(OpenedSets opened, Tell tell)
    : opened_{std::move(opened)}, measurements_{measurementsOf(opened_.sets, opened_.robot)}, tell_{std::move(tell)},
      rungs_{firstRung(opened_, measurements_)} {
  tellSet();
}

std::vector<Effect> Laboratory::effects() const {
  return effectsWith(Json::parse(opened_.definitions), definitionsName, opened_.robot);
}

void Laboratory::tellSet() const {
  Json joints = Json::array();
  for (const Joint& joint : opened_.robot.joints) {
    joints.push_back(joint.name);
  }
  tell_("set", {{"names", opened_.inputs.sets},
                {"robot", measurements_.robot.model},
                {"pictures", measurements_.pictures.size()},
                {"poses", measurements_.poses.size()},
                {"corners", measurements_.cornerCount},
                {"joints", std::move(joints)},
                {"own", Json::parse(opened_.definitions)},
                {"effects", effectsJson(effects())}});
}

void Laboratory::tellLadder() const {
  Json rungs = Json::array();
  for (const Rung& rung : rungs_) {
    rungs.push_back(rungJson(rung));
  }
  tell_("ladder", {{"at", at_}, {"rungs", std::move(rungs)}});
}

void Laboratory::fit() {
  Rung& rung = rungs_[at_];
  const Model model = makeModel(measurements_, rung.with, rung.without, effects());
  const CalibrationResult result = calibrate(measurements_, model);
  rung.rmsPx = result.rmsPx;
  result_ = resultJson(opened_.sets, measurements_, model, result, opened_.inputs);
  diagnosis_.reset();
  next_.reset();
  Json told = fitJson(result_, opened_, measurements_, model, result);
  told["with"] = rung.with;
  told["without"] = rung.without;
  told["labels"] = labelsOf(model);
  tellLadder();
  tell_("fit", told);
}

void Laboratory::go(Rung rung) {
  makeModel(measurements_, rung.with, rung.without, effects()); // refuses what these captures cannot drive
  rungs_.resize(at_ + 1);                                       // what was undone is forgotten
  rungs_.push_back(std::move(rung));
  ++at_;
  fit();
}

void Laboratory::add(const std::string& label) {
  Rung rung{rungs_[at_].with, rungs_[at_].without, "+ " + label, 0, {}};
  if (contains(rung.with, label)) {
    throw InputError{fmt::format("{} is in the model already", label)};
  }
  if (std::erase(rung.without, label) == 0) {
    rung.with.push_back(label);
  }
  go(std::move(rung));
}

void Laboratory::drop(const std::string& label) {
  Rung rung{rungs_[at_].with, rungs_[at_].without, "− " + label, 0, {}};
  if (std::erase(rung.with, label) == 0) {
    if (!contains(labelsOf(makeModel(measurements_, rung.with, rung.without, effects())), label)) {
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
  at_ = rung;
  fit();
}

DiagnosisOptions Laboratory::options(const Rung& rung) const {
  DiagnosisOptions result;
  result.with = rung.with;
  result.without = rung.without;
  result.effects = effects();
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
}

void Laboratory::search(const std::function<bool()>& goesOn) {
  DiagnosisOptions asked = options(rungs_[at_]);
  asked.goesOn = goesOn;
  Json found = questionsJson(diagnose(opened_.sets, measurements_, asked));
  found["stopped"] = !goesOn();
  tell_("found", found);
}

void Laboratory::define(const Json& effect) {
  const Effect made = userEffect(JsonPlace{effect, definitionsName}, opened_.robot);
  Json definitions = Json::parse(opened_.definitions), kept = Json::array();
  for (Json& other : definitions) {
    if (other["name"] != made.name) {
      kept.push_back(std::move(other));
    }
  }
  kept.push_back(effect);
  effectsWith(kept, definitionsName, opened_.robot);
  opened_.definitions = kept.dump();
  tellSet();
  const std::string at = effect["at"].get<std::string>(), label = made.name + "@" + at;
  if (contains(rungs_[at_].with, label)) {
    go({rungs_[at_].with, rungs_[at_].without, "changed " + made.name, 0, {}});
  } else if (at != "*") {
    add(label);
  }
}

Json checkedEffect(const Json& effect, const Robot& robot) {
  try {
    userEffect(JsonPlace{effect, definitionsName}, robot);
    return {{"ok", true}};
  } catch (const CorrectionError& error) {
    return {{"ok", false}, {"sentence", error.what()}, {"letter", error.letter}};
  } catch (const InputError& error) {
    return {{"ok", false}, {"sentence", error.what()}};
  }
}

} // namespace naocal

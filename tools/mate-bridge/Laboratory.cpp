#include "Laboratory.hpp"

#include "LaboratoryJson.hpp"

#include "captures/InputError.hpp"
#include "effects/UserEffect.hpp"
#include "residuals/ModelFile.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

using Json = nlohmann::json;

constexpr const char* definitionsName = "your own effects";

bool contains(const std::vector<std::string>& labels, const std::string& label) {
  return std::find(labels.begin(), labels.end(), label) != labels.end();
}

std::vector<std::string> labelsOf(const Model& model) {
  std::vector<std::string> labels;
  for (const Term& term : model.terms()) {
    if (!term.isPlacement && term.asked) {
      labels.push_back(term.label());
    }
  }
  return labels;
}

std::vector<std::string> without(const std::vector<std::string>& labels, const std::vector<std::string>& others) {
  std::vector<std::string> rest;
  std::copy_if(labels.begin(), labels.end(), std::back_inserter(rest),
               [&](const std::string& label) { return !contains(others, label); });
  return rest;
}

/// Where to begin: the base model, or that of the result that was opened.
Rung firstRung(const OpenedSets& opened, const Measurements& measurements) {
  if (opened.terms.empty()) {
    return {};
  }
  const std::vector<std::string> base = labelsOf(makeModel(measurements));
  std::vector<std::string> with = without(opened.terms, base);
  // the base has every offset that can be asked for; others are along because torques depend on them
  std::erase_if(with, [](const std::string& label) { return label.starts_with("jointOffset@"); });
  return {std::move(with), without(base, opened.terms), "", 0, {}};
}

Json rungJson(const Rung& rung) {
  Json json{{"with", rung.with}, {"without", rung.without}, {"step", rung.step}, {"rms", rung.rmsPx}};
  if (rung.questioned) {
    json["heldOut"] = rung.questioned->heldOutPx;
    json["floor"] = rung.questioned->noiseFloorPx;
    json["alarm"] = rung.questioned->alarm;
  }
  return json;
}

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
  Json told = fitJson(opened_, measurements_, model, result);
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

void Laboratory::question() {
  Rung& rung = rungs_[at_];
  DiagnosisOptions asked = options(rung);
  asked.grow = false;
  const Diagnosis diagnosis = diagnose(opened_.sets, measurements_, asked);
  if (!diagnosis.steps.empty()) {
    rung.questioned = diagnosis.steps.front();
    tellLadder();
  }
  tell_("questions", questionsJson(diagnosis));
}

void Laboratory::search() {
  tell_("found", questionsJson(diagnose(opened_.sets, measurements_, options(rungs_[at_]))));
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

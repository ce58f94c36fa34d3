#include "Exploration.hpp"

#include "DiagnosisStory.hpp"

#include "estimation/ModelFile.hpp"
#include "io/InputError.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

using Json = nlohmann::json;

/// These definitions, and the others whose names they have not.
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

std::string modelWords(const Rung& rung) {
  std::string words = rung.with.empty() ? "base" : fmt::format("+ {}", fmt::join(rung.with, " + "));
  return rung.without.empty() ? words : fmt::format("{}, without {}", words, fmt::join(rung.without, ", "));
}

} // namespace

Exploration::Exploration(const GivenSets& given, Rung first, std::string file)
    : given_{given}, measurements_{measurementsOf(given.sets, given.robot)}, file_{std::move(file)} {
  if (!file_.empty() && std::filesystem::exists(file_)) {
    session_ = readSession(file_);
    requireSameCaptures(session_, given_.inputs, file_);
    for (Rung& rung : session_.ladder) {
      effectsWith(Json::parse(rung.definitions), file_, given_.robot); // refuses what is none
      rung.definitions = joined(rung.definitions, first.definitions);
    }
    here() = questioned(here());
  } else {
    session_.inputs = given_.inputs;
    session_.ladder.push_back(questioned(std::move(first)));
  }
  save();
}

Rung Exploration::questioned(Rung rung) {
  DiagnosisOptions options{.with = rung.with, .without = rung.without};
  options.effects = effectsWith(Json::parse(rung.definitions), "the person's own effects", given_.robot);
  options.grow = false;
  Diagnosis diagnosis = diagnose(given_.sets, measurements_, options);
  if (diagnosis.steps.empty()) {
    throw InputError{diagnosis.sentence};
  }
  latest_ = std::move(diagnosis);
  rung.rmsPx = latest_.steps.front().rmsPx;
  rung.questioned = latest_.steps.front();
  return rung;
}

void Exploration::tryOut(Rung rung, const std::string& step) {
  rung.step = step;
  rung.from = session_.at;
  rung = questioned(std::move(rung));
  session_.at = session_.ladder.size();
  session_.ladder.push_back(std::move(rung));
  save();
}

void Exploration::add(const std::string& label) {
  Rung rung = here();
  if (std::erase(rung.without, label) == 0) {
    rung.with.push_back(label);
  }
  tryOut(std::move(rung), "+ " + label);
}

void Exploration::drop(const std::string& label) {
  Rung rung = here();
  if (std::erase(rung.with, label) == 0) {
    throw InputError{
        fmt::format("{} is not in the model; it has {}", label,
                    rung.with.empty() ? "no more than the base" : fmt::format("{}", fmt::join(rung.with, ", ")))};
  }
  tryOut(std::move(rung), "− " + label);
}

void Exploration::undo() {
  const std::optional<std::size_t> before = here().from;
  if (!before) {
    throw InputError{"there is nothing to undo"};
  }
  session_.ladder[*before] = questioned(session_.ladder[*before]);
  session_.at = *before;
  save();
}

void Exploration::printLadder() const {
  fmt::print("  {:>3}  {:>9}  {:>9}  {:>9}  {:>7}  model (*: the one you are at)\n", "", "rms", "unseen", "noise",
             "alarm p");
  for (std::size_t i = 0; i < session_.ladder.size(); ++i) {
    const Rung& rung = session_.ladder[i];
    const auto& step = rung.questioned;
    const std::string unseen = step && step->heldOutPx ? fmt::format("{:6.3f} px", *step->heldOutPx) : "-";
    fmt::print("{} {:>3}  {:6.3f} px  {:>9}  {:>9}  {:>7}  {}\n", i == session_.at ? '*' : ' ', i, rung.rmsPx, unseen,
               step ? fmt::format("{:6.3f} px", step->noiseFloorPx) : "-",
               step ? fmt::format("{:7.3f}", step->alarm) : "-", modelWords(rung));
  }
}

void Exploration::printCandidates() const {
  naocal::printCandidates(latest_);
}

void Exploration::save() const {
  if (!file_.empty()) {
    writeJson(sessionJson(session_), file_);
  }
}

} // namespace naocal

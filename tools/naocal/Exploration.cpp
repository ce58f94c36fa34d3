#include "Exploration.hpp"

#include "DiagnosisStory.hpp"

#include "captures/Files.hpp"
#include "captures/InputError.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

using Json = nlohmann::json;

Json orNull(const auto& value) {
  return value ? Json(*value) : Json(nullptr);
}

} // namespace

Exploration::Exploration(const GivenSets& given, DiagnosisOptions asked, std::string file)
    : given_{given}, asked_{std::move(asked)}, measurements_{measurementsOf(given.sets, given.robot)}, file_{std::move(
                                                                                                           file)} {
  asked_.grow = false;
  if (!file_.empty() && std::filesystem::exists(file_)) {
    load();
    rungs_[here_].step = questioned(rungs_[here_].with);
  } else {
    tryOut(asked_.with, std::nullopt);
  }
}

Step Exploration::questioned(const std::vector<std::string>& with) {
  DiagnosisOptions options = asked_;
  options.with = with;
  Diagnosis diagnosis = diagnose(given_.sets, measurements_, options);
  if (diagnosis.steps.empty()) {
    throw InputError{diagnosis.sentence};
  }
  latest_ = std::move(diagnosis);
  return latest_.steps.front();
}

void Exploration::tryOut(std::vector<std::string> with, std::optional<std::size_t> from) {
  Step step = questioned(with);
  here_ = rungs_.size();
  rungs_.push_back({std::move(with), from, std::move(step)});
  save();
}

void Exploration::add(const std::string& label) {
  std::vector<std::string> with = rungs_[here_].with;
  with.push_back(label);
  tryOut(std::move(with), here_);
}

void Exploration::drop(const std::string& label) {
  std::vector<std::string> with = rungs_[here_].with;
  if (std::erase(with, label) == 0) {
    throw InputError{fmt::format("{} is not in the model; it has {}", label,
                                 with.empty() ? "no more than the base" : fmt::format("{}", fmt::join(with, ", ")))};
  }
  tryOut(std::move(with), here_);
}

void Exploration::undo() {
  const std::optional<std::size_t> before = rungs_[here_].from;
  if (!before) {
    throw InputError{"there is nothing to undo"};
  }
  questioned(rungs_[*before].with);
  here_ = *before;
  save();
}

void Exploration::printLadder() const {
  fmt::print("  {:>3}  {:>9}  {:>9}  {:>9}  {:>7}  model (*: the one you are at)\n", "", "rms", "unseen", "noise",
             "alarm p");
  for (std::size_t i = 0; i < rungs_.size(); ++i) {
    const Step& step = rungs_[i].step;
    const std::string unseen = step.heldOutPx ? fmt::format("{:6.3f} px", *step.heldOutPx) : "-";
    fmt::print("{} {:>3}  {:6.3f} px  {:>9}  {:6.3f} px  {:7.3f}  {}\n", i == here_ ? '*' : ' ', i, step.rmsPx, unseen,
               step.noiseFloorPx, step.alarm,
               rungs_[i].with.empty() ? "base" : fmt::format("+ {}", fmt::join(rungs_[i].with, " + ")));
  }
}

void Exploration::printCandidates() const {
  naocal::printCandidates(latest_);
}

void Exploration::load() {
  try {
    const Json session = Json::parse(fileContent(file_));
    if (session.at("format") == "naocal-session" && !session.at("ladder").empty()) {
      if (session.at("sets") != Json(given_.inputs.sets) ||
          session.value("sha256", given_.inputs.sha256) != given_.inputs.sha256) {
        throw InputError{fmt::format("{}: expected a session of these captures, found one of {}; name another file",
                                     file_, session.at("sets").dump())};
      }
      for (const Json& rung : session.at("ladder")) {
        Step step{.rmsPx = rung.at("rmsPx"), .noiseFloorPx = rung.at("noiseFloorPx")};
        step.alarm = rung.at("alarm");
        if (rung.at("heldOutPx").is_number()) {
          step.heldOutPx = rung.at("heldOutPx").get<double>();
        }
        std::optional<std::size_t> from;
        if (rung.contains("from") ? rung.at("from").is_number_unsigned() : !rungs_.empty()) {
          from = rung.value("from", rungs_.size() - 1);
        }
        if (from && *from >= rungs_.size()) {
          break; // told below
        }
        rungs_.push_back({rung.at("with").get<std::vector<std::string>>(), from, std::move(step)});
      }
      here_ = session.value("at", rungs_.size() - 1);
      if (rungs_.size() == session.at("ladder").size() && here_ < rungs_.size()) {
        return;
      }
    }
  } catch (const Json::exception&) { // told below
  }
  throw InputError{fmt::format("{}: expected a session that 'naocal explore' wrote; name another file", file_)};
}

void Exploration::save() const {
  if (file_.empty()) {
    return;
  }
  Json ladder = Json::array();
  for (const Rung& rung : rungs_) {
    ladder.push_back({{"with", rung.with},
                      {"from", orNull(rung.from)},
                      {"rmsPx", rung.step.rmsPx},
                      {"heldOutPx", orNull(rung.step.heldOutPx)},
                      {"noiseFloorPx", rung.step.noiseFloorPx},
                      {"alarm", rung.step.alarm}});
  }
  writeJson({{"format", "naocal-session"},
             {"version", 1},
             {"sets", given_.inputs.sets},
             {"sha256", given_.inputs.sha256},
             {"ladder", ladder},
             {"at", here_}},
            file_);
}

} // namespace naocal

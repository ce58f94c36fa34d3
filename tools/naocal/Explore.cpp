#include "Commands.hpp"
#include "DiagnosisStory.hpp"
#include "Sets.hpp"

#include "captures/Files.hpp"
#include "captures/InputError.hpp"
#include "diagnose/Diagnosis.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

namespace naocal {

namespace {

/// A model that was tried: what it had beyond the base, and how well it did.
struct Rung {
  std::vector<std::string> with;
  Step step;
};

/// The loop of a person with a set: add, drop, look, undo. Every rung is kept, and written to the session's file.
class Exploration {
public:
  Exploration(const GivenSets& given, const std::string& file)
      : given_{given}, measurements_{measurementsOf(given.sets, given.robot)}, file_{file} {
    std::vector<std::string> with;
    if (!file.empty() && std::filesystem::exists(file)) {
      with = lastOf(file);
    }
    go(with);
  }

  void go(const std::vector<std::string>& with) {
    DiagnosisOptions options;
    options.with = with;
    options.grow = false;
    latest_ = diagnose(given_.sets, measurements_, options);
    Rung rung{with, latest_.steps.empty() ? Step{} : latest_.steps.front()};
    rungs_.push_back(std::move(rung));
    save();
  }

  void add(const std::string& label) {
    std::vector<std::string> with = rungs_.back().with;
    with.push_back(label);
    go(with);
  }
  void drop(const std::string& label) {
    std::vector<std::string> with = rungs_.back().with;
    if (std::erase(with, label) == 0) {
      throw InputError{fmt::format("{} is not in the model; it has {}", label,
                                   with.empty() ? "no more than the base" : fmt::format("{}", fmt::join(with, ", ")))};
    }
    go(with);
  }
  void undo() {
    if (rungs_.size() < 2) {
      throw InputError{"there is nothing to undo"};
    }
    go(std::vector<std::string>{rungs_[rungs_.size() - 2].with});
  }

  void printLadder() const {
    fmt::print("  {:>3}  {:>9}  {:>9}  {:>9}  {:>7}  model\n", "", "rms", "unseen", "noise", "alarm p");
    for (std::size_t i = 0; i < rungs_.size(); ++i) {
      const Step& step = rungs_[i].step;
      fmt::print("  {:>3}  {:6.3f} px  {:6.3f} px  {:6.3f} px  {:7.3f}  {}\n", i, step.rmsPx, step.heldOutPx,
                 step.noiseFloorPx, step.alarm,
                 rungs_[i].with.empty() ? "base" : fmt::format("+ {}", fmt::join(rungs_[i].with, " + ")));
    }
  }
  void printCandidates() const { naocal::printCandidates(latest_); }

private:
  static std::vector<std::string> lastOf(const std::string& file) {
    try {
      const auto session = nlohmann::json::parse(fileContent(file));
      if (session.at("format") == "naocal-session" && !session.at("ladder").empty()) {
        return session.at("ladder").back().at("with").get<std::vector<std::string>>();
      }
    } catch (const nlohmann::json::exception&) { // told below
    }
    throw InputError{fmt::format("{}: expected a session that 'naocal explore' wrote; name another file", file)};
  }

  void save() const {
    if (file_.empty()) {
      return;
    }
    nlohmann::json ladder = nlohmann::json::array();
    for (const Rung& rung : rungs_) {
      ladder.push_back({{"with", rung.with},
                        {"rmsPx", rung.step.rmsPx},
                        {"heldOutPx", rung.step.heldOutPx},
                        {"noiseFloorPx", rung.step.noiseFloorPx},
                        {"alarm", rung.step.alarm}});
    }
    writeJson({{"format", "naocal-session"}, {"version", 1}, {"sets", given_.inputs.sets}, {"ladder", ladder}}, file_);
  }

  const GivenSets& given_;
  Measurements measurements_;
  std::string file_;
  std::vector<Rung> rungs_;
  Diagnosis latest_;
};

void printHelp() {
  fmt::print("  add EFFECT@PLACE    put an effect into the model and fit\n"
             "  drop EFFECT@PLACE   take it out again\n"
             "  undo                back to the model before\n"
             "  what                the candidates that would help most now\n"
             "  ladder              all models tried, and their errors\n"
             "  quit\n");
}

/// One line of what a person typed; false: leave.
bool obey(Exploration& exploration, const std::string& line) {
  std::istringstream words{line};
  std::string verb, label;
  words >> verb >> label;
  if (verb.empty()) {
    return true;
  }
  if (verb == "quit" || verb == "exit") {
    return false;
  }
  if (verb == "add" || verb == "drop" || verb == "undo") {
    if (verb == "undo") {
      exploration.undo();
    } else {
      verb == "add" ? exploration.add(label) : exploration.drop(label);
    }
    exploration.printLadder();
  } else if (verb == "ladder") {
    exploration.printLadder();
  } else if (verb == "what") {
    exploration.printCandidates();
  } else {
    printHelp();
  }
  return true;
}

void explore(const std::vector<std::string>& sets, const std::string& session) {
  const GivenSets given = readSets(sets, false);
  Exploration exploration{given, session};
  exploration.printLadder();
  exploration.printCandidates();
  fmt::print("type 'help' for what you can do\n> ");
  std::fflush(stdout);
  for (std::string line; std::getline(std::cin, line);) {
    try {
      if (!obey(exploration, line)) {
        return;
      }
    } catch (const InputError& error) {
      fmt::print("  {}\n", error.what());
    }
    fmt::print("> ");
    std::fflush(stdout);
  }
  fmt::print("\n");
}

} // namespace

void addExplore(CLI::App& app) {
  auto sets = std::make_shared<std::vector<std::string>>();
  auto session = std::make_shared<std::string>();
  CLI::App* explorer =
      app.add_subcommand("explore", "add and remove effects by hand and watch the error fall, with history");
  explorer->footer("Example: naocal explore captures/ --session captures.session.json");
  explorer->add_option("SET", *sets, "folders with captures.json")->required();
  explorer->add_option("--session", *session, "keeps the ladder in this file, and goes on from it");
  explorer->callback([sets, session] { explore(*sets, *session); });
}

} // namespace naocal

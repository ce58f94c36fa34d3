#include "commands/Commands.hpp"
#include "console/CommandLine.hpp"
#include "console/OutputFiles.hpp"
#include "console/print/PrintDiagnosis.hpp"
#include "console/print/PrintText.hpp"
#include "diagnosis/Diagnosis.hpp"
#include "diagnosis/Session.hpp"
#include "diagnosis/anomalies/MendedMeasurements.hpp"
#include "estimation/ModelBuilder.hpp"
#include "estimation/ModelFile.hpp"
#include "io/InputError.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace naocal {

namespace {

/// Interactive exploration of a set: add, drop, inspect, undo. Keeps every model revision and writes them to the
/// session file, from which a later run continues.
class ExploreLoop {
public:
  /// `first`: initial model; a continued session takes only its custom effects. `file`: session file; may be empty.
  ExploreLoop(const LoadedSets& given, ModelRevision first, std::string file);

  void add(const std::string& label);
  void drop(const std::string& label);
  /// Returns to the revision that the current model was derived from.
  void undo();

  void printLadder() const;
  void printCandidates() const;

private:
  /// Tests the candidates of a model. Throws InputError if no fit is possible.
  ModelRevision questioned(ModelRevision rung);
  std::vector<Effect> effects(const ModelRevision& rung) const;
  std::vector<std::string> terms() const;
  void enter(Session session);
  void save() const;

  const LoadedSets& given_;
  std::shared_ptr<const Measurements> measurements_; // as given
  MendedMeasurements mended_;                        // as the current model takes them
  std::string file_;
  Session session_;
  Diagnosis latest_;
};

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

ExploreLoop::ExploreLoop(const LoadedSets& given, ModelRevision first, std::string file)
    : given_{given}, measurements_{std::make_shared<const Measurements>(buildMeasurements(given.sets, given.robot))},
      file_{std::move(file)} {
  if (!file_.empty() && std::filesystem::exists(file_)) {
    session_ = readSession(file_);
    requireSameCaptures(session_, given_.inputs, file_);
    for (ModelRevision& rung : session_.ladder) {
      parseEffects(Json::parse(rung.definitions), file_, given_.robot); // throws for invalid definitions
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
  DiagnosisOptions options{.with = mended.effects, .without = rung.without};
  options.effects = effects(rung);
  options.extend = false;
  Diagnosis diagnosis = diagnose(*mended.measurements, options);
  if (diagnosis.steps.empty()) {
    const bool mendable = !diagnosis.anomalies.empty() && !diagnosis.anomalies.front().setUp.empty();
    throw InputError{mendable ? fmt::format("{} Mend it in a model file: \"with\": [\"{}\"].", diagnosis.sentence,
                                            diagnosis.anomalies.front().setUp)
                              : diagnosis.sentence};
  }
  latest_ = std::move(diagnosis);
  mended_ = std::move(mended);
  rung.rmsPx = latest_.steps.front().rmsPx;
  rung.questioned = latest_.steps.front();
  return rung;
}

/// Labels of the current model's terms and of the set-ups that it mends.
std::vector<std::string> ExploreLoop::terms() const {
  const ModelRevision& rung = session_.current();
  return termLabels(mended_, rung.without, effects(rung));
}

/// Fits the session's current model, then makes the session current; strong exception guarantee.
void ExploreLoop::enter(Session session) {
  session.current() = questioned(session.current());
  session_ = std::move(session);
  save();
}

void ExploreLoop::add(const std::string& label) {
  Session session = session_;
  session.add(label, [this] { return terms(); });
  enter(std::move(session));
}

void ExploreLoop::drop(const std::string& label) {
  Session session = session_;
  session.drop(label, [this] { return terms(); });
  enter(std::move(session));
}

void ExploreLoop::undo() {
  Session session = session_;
  session.undo();
  enter(std::move(session));
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

void ExploreLoop::printCandidates() const {
  for (const DataAnomaly& anomaly : latest_.anomalies) {
    printText("suspected: {}{}\n", anomaly.why, anomaly.setUp.empty() ? "" : "  (mend it: add " + anomaly.setUp + ")");
  }
  naocal::printCandidates(latest_);
}

void ExploreLoop::save() const {
  if (!file_.empty()) {
    Session kept = session_;
    kept.inputs = session_.inputs.placedBeside(file_);
    writeJson(sessionJson(kept), file_);
  }
}

void printHelp() {
  printText("  add EFFECT@PLACE    put an effect into the model and fit; a suspected set-up is mended\n"
            "  drop EFFECT@PLACE   take it out again\n"
            "  undo                back to the model that this one was made from\n"
            "  what                the candidates, best first\n"
            "  ladder              all models tried, and their errors\n"
            "  quit\n");
}

/// Executes one input line; false to quit.
bool obey(ExploreLoop& exploration, const std::string& line) {
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
    if (verb != "help" && !verb.empty()) {
      printText("  '{}' is no command here\n", verb);
    }
    printHelp();
  }
  return true;
}

struct ExploreCommand {
  std::vector<std::string> sets;
  std::string session, model;
};

void explore(const ExploreCommand& command) {
  const LoadedSets given = loadSets(command.sets, false);
  ModelRevision first;
  if (!command.model.empty()) {
    ModelFile file = readModelFile(command.model, given.robot);
    first = {.with = std::move(file.with), .without = std::move(file.without), .definitions = file.definitions};
  }
  ExploreLoop exploration{given, std::move(first), command.session};
  exploration.printLadder();
  exploration.printCandidates();
  printText("type 'help' for the commands\n> ");
  std::fflush(stdout);
  for (std::string line; std::getline(std::cin, line);) {
    try {
      if (!obey(exploration, line)) {
        return;
      }
    } catch (const InputError& error) {
      printText("  {}\n", error.what());
    }
    printText("> ");
    std::fflush(stdout);
  }
  printText("\n");
}

} // namespace

void addExplore(CLI::App& app) {
  auto command = std::make_shared<ExploreCommand>();
  CLI::App* explorer = app.get_subcommand("explore");
  explorer->footer("Example: naocal explore captures/ --session captures.session.json");
  explorer->add_option("SET", command->sets, "folders with captures.json")->type_name("FOLDER")->required();
  explorer
      ->add_option("--session", command->session,
                   "keeps the ladder in this file, and goes on from it; so does mate-bridge")
      ->type_name("FILE");
  explorer->add_option("--model", command->model, "a model file: terms to begin with, and effects of your own")
      ->type_name("FILE");
  explorer->callback([command] { explore(*command); });
}

} // namespace naocal

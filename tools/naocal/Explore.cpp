#include "Commands.hpp"
#include "Exploration.hpp"

#include "estimation/ModelFile.hpp"
#include "io/InputError.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <iostream>
#include <memory>
#include <sstream>

namespace naocal {

namespace {

void printHelp() {
  fmt::print("  add EFFECT@PLACE    put an effect into the model and fit\n"
             "  drop EFFECT@PLACE   take it out again\n"
             "  undo                back to the model that this one was made from\n"
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

struct ExploreCommand {
  std::vector<std::string> sets;
  std::string session, model;
};

void explore(const ExploreCommand& command) {
  const GivenSets given = readSets(command.sets, false);
  Rung first;
  if (!command.model.empty()) {
    ModelFile file = readModelFile(command.model, given.robot);
    first = {.with = std::move(file.with), .without = std::move(file.without), .definitions = file.definitions};
  }
  Exploration exploration{given, std::move(first), command.session};
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
  auto command = std::make_shared<ExploreCommand>();
  CLI::App* explorer =
      app.add_subcommand("explore", "add and remove effects by hand and watch the error fall, with history");
  explorer->footer("Example: naocal explore captures/ --session captures.session.json");
  explorer->add_option("SET", command->sets, "folders with captures.json")->required();
  explorer->add_option("--session", command->session,
                       "keeps the ladder in this file, and goes on from it; so does mate-bridge");
  explorer->add_option("--model", command->model, "a model file: terms to begin with, and effects of your own");
  explorer->callback([command] { explore(*command); });
}

} // namespace naocal

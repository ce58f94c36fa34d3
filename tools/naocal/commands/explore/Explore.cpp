#include "commands/Commands.hpp"
#include "commands/explore/ExploreLoop.hpp"
#include "commands/explore/LineEditor.hpp"
#include "console/CommandLine.hpp"
#include "console/print/PrintText.hpp"

#include "estimation/ModelFile.hpp"
#include "io/InputError.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

namespace {

/// What a command's word after its name is.
enum class Argument { none, candidate, term, revision, file, optionalFile, optionalRows };

/// A command of the prompt. `run` gets the word after its name.
struct Verb {
  std::string_view name;
  Argument argument;
  std::string_view usage, words; // of the help
  void (*run)(ExploreLoop& exploration, const std::string& word);
};

std::size_t numberIn(const std::string& word, std::string_view expected) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc{} || end != word.data() + word.size()) {
    throw InputError{fmt::format("expected {}, found \"{}\"", expected, word)};
  }
  return number;
}

constexpr std::array verbs{
    Verb{"add", Argument::candidate, "add EFFECT@PLACE",
         "put an effect into the model and fit; mends a suspected set-up",
         [](ExploreLoop& exploration, const std::string& word) {
           exploration.add(exploration.labelOf(word));
           exploration.printLadder();
         }},
    Verb{"drop", Argument::term, "drop EFFECT@PLACE", "take it out again",
         [](ExploreLoop& exploration, const std::string& word) {
           exploration.drop(exploration.labelOf(word));
           exploration.printLadder();
         }},
    Verb{"what", Argument::optionalRows, "what [ROWS]", "the candidates, best first; 8 of them without a number",
         [](ExploreLoop& exploration, const std::string& word) {
           word.empty() ? exploration.printCandidates()
                        : exploration.printCandidates(numberIn(word, "a number of rows"));
         }},
    Verb{"why", Argument::candidate, "why EFFECT@PLACE", "all that is known about a candidate",
         [](ExploreLoop& exploration, const std::string& word) {
           exploration.printCandidate(exploration.labelOf(word));
         }},
    Verb{"where", Argument::none, "where", "errors of the current model by board, camera and worst pose",
         [](ExploreLoop& exploration, const std::string&) { exploration.printWhere(); }},
    Verb{"next", Argument::optionalFile, "next [FILE]", "poses that would answer what is open, into a file",
         [](ExploreLoop& exploration, const std::string& word) { exploration.proposePoses(word); }},
    Verb{"ladder", Argument::none, "ladder", "all models tried, and their errors",
         [](ExploreLoop& exploration, const std::string&) { exploration.printLadder(); }},
    Verb{"undo", Argument::none, "undo", "back to the model that this one was made from",
         [](ExploreLoop& exploration, const std::string&) {
           exploration.undo();
           exploration.printLadder();
         }},
    Verb{"redo", Argument::none, "redo", "to the newest model that was made from this one",
         [](ExploreLoop& exploration, const std::string&) {
           exploration.redo();
           exploration.printLadder();
         }},
    Verb{"goto", Argument::revision, "goto N", "to model N of the ladder",
         [](ExploreLoop& exploration, const std::string& word) {
           exploration.goTo(numberIn(word, "a number of the ladder"));
           exploration.printLadder();
         }},
    Verb{"save", Argument::file, "save FILE", "the current model's result, as 'naocal solve' writes it",
         [](ExploreLoop& exploration, const std::string& word) { exploration.saveResult(word); }},
};

std::vector<std::string> verbNames() {
  std::vector<std::string> names{"help", "quit"};
  for (const Verb& verb : verbs) {
    names.emplace_back(verb.name);
  }
  return names;
}

void printHelp() {
  for (const Verb& verb : verbs) {
    printText("  {:19} {}\n", verb.usage, verb.words);
  }
  printText("  {:19} {}\n", "quit", "a row's number of 'what' stands for its effect; Tab completes words");
}

/// Words that may stand where the last one is being typed.
std::vector<std::string> choicesFor(const std::vector<std::string>& words, const ExploreLoop& exploration) {
  if (words.size() < 2) {
    return verbNames();
  }
  const auto verb = std::find_if(verbs.begin(), verbs.end(), [&](const Verb& one) { return one.name == words[0]; });
  if (verb == verbs.end() || words.size() > 2) {
    return {};
  }
  return verb->argument == Argument::candidate ? exploration.candidates()
         : verb->argument == Argument::term    ? exploration.terms()
                                               : std::vector<std::string>{};
}

/// Executes one input line; false to quit. Throws InputError.
bool obey(ExploreLoop& exploration, const std::string& line) {
  std::istringstream words{line};
  std::string name, word, further;
  words >> name >> word >> further;
  if (name == "quit" || name == "exit") {
    return false;
  }
  if (name == "help") {
    printHelp();
  }
  if (name.empty() || name == "help") {
    return true;
  }
  const auto verb = std::find_if(verbs.begin(), verbs.end(), [&](const Verb& one) { return one.name == name; });
  if (verb == verbs.end()) {
    throw InputError{fmt::format("expected a command, found \"{}\"; near it are {}; 'help' lists all", name,
                                 fmt::join(closestNames(name, verbNames(), 2), ", "))};
  }
  const bool isOptional = verb->argument == Argument::optionalFile || verb->argument == Argument::optionalRows;
  const bool needsWord = verb->argument != Argument::none && !isOptional;
  if ((needsWord && word.empty()) || (verb->argument == Argument::none && !word.empty()) || !further.empty()) {
    throw InputError{fmt::format("expected \"{}\", found \"{}\"", verb->usage, line)};
  }
  verb->run(exploration, word);
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
  ExploreLoop exploration{given, std::move(first), {command.session, command.model}};
  exploration.printLadder();
  exploration.printCandidates();
  printText("type 'help' for the commands\n");
  LineEditor editor{"> ", [&](const std::vector<std::string>& words) { return choicesFor(words, exploration); }};
  while (const std::optional<std::string> line = editor.read()) {
    try {
      if (!obey(exploration, *line)) {
        return;
      }
    } catch (const InputError& error) {
      printText("  {}\n", error.what());
    }
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

#include "command-line/Parsing.hpp"

#include "command-line/CommandLineJson.hpp"
#include "command-line/HelpFormatter.hpp"
#include "command-line/OptionChecks.hpp"
#include "command-line/OptionText.hpp"
#include "command-line/TextLayout.hpp"
#include "io/InputError.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

namespace {

constexpr std::size_t suggestions = 3;

/// The command that was given, and the words that call it.
struct GivenCommand {
  const CLI::App* app;
  std::string words;
};

GivenCommand givenCommand(const CLI::App& app) {
  GivenCommand given{&app, app.get_name()};
  while (!given.app->get_subcommands().empty()) {
    given.app = given.app->get_subcommands().front();
    given.words += " " + given.app->get_name();
  }
  return given;
}

std::vector<std::string> commandNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
  }
  return names;
}

std::vector<std::string> optionNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      names.push_back("--" + name);
    }
  }
  return names;
}

std::string near(const std::string& word, const std::vector<std::string>& names) {
  const std::vector<std::string> closest = closestNames(word, names, suggestions);
  return fmt::format("near it {} {}", closest.size() == 1 ? "is" : "are", joinWords(closest, "and"));
}

/// The sentence for an option or word that the command does not have; empty if it has all.
std::string unknownWord(const GivenCommand& given) {
  const std::vector<std::string> names = commandNames(*given.app);
  for (const std::string& word : given.app->remaining()) {
    const std::string name = word.substr(0, word.find('='));
    if (word.size() > 1 && word.front() == '-' && word != "--") {
      return fmt::format("'{}' is no option of {}; {}", name, given.words, near(name, optionNames(*given.app)));
    }
    return names.empty() ? fmt::format("expected no further word after those of {}, found '{}'", given.words, word)
                         : fmt::format("'{}' is no command of {}; {}", word, given.words, near(word, names));
  }
  return "";
}

/// What is missing of the required options and arguments; empty if none is.
std::string missing(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_required() && option->count() == 0) {
      const OptionText text = describeOption(*option);
      return fmt::format("expected {}: {}; found none",
                         text.isArgument ? text.heading() : fmt::format("{} {}", text.name(), text.value),
                         text.description);
    }
  }
  return "";
}

/// The option that an error of CLI11 is about; nullptr if there is none.
const CLI::Option* optionIn(const CLI::App& app, const std::string& message) {
  const CLI::Option* found = nullptr;
  std::size_t longest = 0; // of the names in the message
  for (const CLI::Option* option : app.get_options()) {
    const std::string name = option->get_name();
    if (name.size() > longest && message.find(name) != std::string::npos) {
      found = option;
      longest = name.size();
    }
  }
  return found;
}

/// The sentence for a wrong number of values.
std::string wrongCount(const CLI::Option& option, const std::string& message) {
  const OptionText text = describeOption(option);
  const int least = option.get_items_expected_min(), most = option.get_items_expected_max();
  if (most == 0) {
    return fmt::format("{}: expected no value, found one", text.name());
  }
  if (option.count() == 0 || message.ends_with("missing")) {
    return fmt::format("{}: expected {}{}, found {}", text.name(), least > 1 ? fmt::format("{} times ", least) : "",
                       text.value, option.count() == 0 ? "nothing" : "fewer");
  }
  return fmt::format("{}: expected {} value{}, found {}", text.name(),
                     least == most ? std::to_string(most) : fmt::format("{} to {}", least, most), most == 1 ? "" : "s",
                     option.count());
}

std::string sentenceOf(const CLI::ParseError& error, const GivenCommand& given) {
  if (std::string unknown = unknownWord(given); !unknown.empty()) {
    return unknown;
  }
  const std::string message = error.what();
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
    const std::string what = missing(*given.app);
    return what.empty() ? fmt::format("expected a command: {}; found none", joinWords(commandNames(*given.app), "or"))
                        : what;
  }
  if (dynamic_cast<const CLI::RequiresError*>(&error) != nullptr) {
    const auto [first, second] = std::pair{message.find(" requires "), message.find(" requires ") + 10};
    return fmt::format("{}: expected {} beside it, found none", message.substr(0, first), message.substr(second));
  }
  if (dynamic_cast<const CLI::ExcludesError*>(&error) != nullptr) {
    const auto [first, second] = std::pair{message.find(" excludes "), message.find(" excludes ") + 10};
    return fmt::format("{}: expected it without {}, found both", message.substr(0, first), message.substr(second));
  }
  const CLI::Option* option = optionIn(*given.app, message);
  return option != nullptr && dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr
             ? wrongCount(*option, message)
             : message;
}

} // namespace

void useHelp(CLI::App& app) {
  app.formatter(std::make_shared<HelpFormatter>());
  app.set_help_flag("-h,--help", "print this help");
}

std::optional<int> parseCommandLine(CLI::App& app, int argc, char** argv) {
  checkNumbers(app);
  if (argc == 2 && std::string_view{argv[1]} == "--describe") {
    fmt::print("{}\n", commandLineJson(app).dump(1));
    return 0;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      return app.exit(error); // --help, --version
    }
    const GivenCommand given = givenCommand(app);
    throw InputError{fmt::format("{} (see '{} --help')", sentenceOf(error, given), given.words)};
  }
  return std::nullopt;
}

} // namespace naocal

#include "CommandText.hpp"

#include "io/Files.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace naocal::manual {

namespace {

using nlohmann::json;

Option readOption(const json& document) {
  return {document.at("names"),    document.at("words"),       document.at("value"),
          document.at("heading"),  document.at("description"), document.at("group"),
          document.at("argument"), document.at("required"),    document.at("list")};
}

Command readCommand(const json& document) {
  Command command{document.at("name"),
                  document.at("words"),
                  document.at("usage"),
                  document.at("description"),
                  document.at("group"),
                  document.at("footer"),
                  {},
                  {}};
  for (const json& option : document.at("options")) {
    command.options.push_back(readOption(option));
  }
  for (const json& each : document.at("commands")) {
    command.commands.push_back(readCommand(each));
  }
  return command;
}

/// Takes over the commands that another description has in full.
void merge(const Command& from, Command& into) {
  for (Command& command : into.commands) {
    for (const Command& other : from.commands) {
      if (other.name == command.name &&
          other.options.size() + other.commands.size() > command.options.size() + command.commands.size()) {
        command = other;
      }
    }
  }
}

} // namespace

std::vector<Command> readPrograms(const std::vector<std::filesystem::path>& files) {
  std::vector<Command> programs;
  for (const std::filesystem::path& file : files) {
    Command command = readCommand(json::parse(readFile(file)));
    const auto same = std::find_if(programs.begin(), programs.end(),
                                   [&](const Command& program) { return program.name == command.name; });
    if (same == programs.end()) {
      programs.push_back(std::move(command));
    } else {
      merge(command, *same);
    }
  }
  return programs;
}

std::vector<EffectPlaces> readEffects(const std::filesystem::path& file) {
  std::vector<EffectPlaces> effects;
  const json document = json::parse(readFile(file));
  for (const json& effect : document.at("effects")) {
    effects.push_back({effect.at("effect"), effect.at("places")});
  }
  return effects;
}

Completion completionOf(const Option& option) {
  if (!option.words.empty()) {
    return Completion::words;
  }
  if (option.value == "FILE" || option.value == "N|FILE") {
    return Completion::file;
  }
  return option.value == "FOLDER"         ? Completion::folder
         : option.value == "EFFECT@PLACE" ? Completion::effect
                                          : Completion::none;
}

std::vector<const Option*> optionsOf(const Command& command) {
  std::vector<const Option*> options;
  for (const Option& option : command.options) {
    if (!option.isArgument) {
      options.push_back(&option);
    }
  }
  return options;
}

const Option* lastArgument(const Command& command) {
  const Option* last = nullptr;
  for (const Option& option : command.options) {
    last = option.isArgument ? &option : last;
  }
  return last;
}

} // namespace naocal::manual

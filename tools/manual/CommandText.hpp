#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace naocal::manual {

/// An option or argument, as `--describe` writes it.
struct Option {
  std::vector<std::string> names; // "-o", "--output"; of an argument "SET"
  std::vector<std::string> words; // values that are accepted, if these are words
  std::string value, heading, description, group;
  bool isArgument = false, isRequired = false, isList = false;
};

/// A program or a command.
struct Command {
  std::string name, words, usage, description, group, footer; // words: "naocal solve"
  std::vector<Option> options;
  std::vector<Command> commands;
};

/// An effect and the places on a robot where it can act.
struct EffectPlaces {
  std::string effect;
  std::vector<std::string> places;
};

/// All command lines, and the words that they take.
struct Manual {
  std::vector<Command> programs;
  std::vector<EffectPlaces> effects;
  std::string version;
};

/// Reads what programs print for `--describe`. Descriptions of one program that list different options of its commands
/// are merged.
std::vector<Command> readPrograms(const std::vector<std::filesystem::path>& files);

/// Reads what `naocal effects --json` writes.
std::vector<EffectPlaces> readEffects(const std::filesystem::path& file);

/// What completes the value of an option, or an argument.
enum class Completion { none, file, folder, effect, words };
Completion completionOf(const Option& option);

/// The options with a dash, and the last of the arguments (nullptr: none), which all further words are.
std::vector<const Option*> optionsOf(const Command& command);
const Option* lastArgument(const Command& command);

} // namespace naocal::manual

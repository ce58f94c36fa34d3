#include "FishCompletion.hpp"

#include <fmt/format.h>

namespace naocal::manual {

namespace {

std::string fishQuoted(const std::string& text) {
  std::string result = "'";
  for (const char letter : text) {
    result += letter == '\'' || letter == '\\' ? "\\" : "";
    result += letter;
  }
  return result + "'";
}

/// What follows an option: nothing, files, or words.
std::string valueOf(const Option& option) {
  switch (completionOf(option)) {
  case Completion::file:
    return " -r -F";
  case Completion::folder:
    return " -x -a '(__fish_complete_directories)'";
  case Completion::effect:
    return " -x -a '(__naocal_effects)'";
  case Completion::words:
    return fmt::format(" -x -a {}", fishQuoted(fmt::format("{}", fmt::join(option.words, " "))));
  case Completion::none:
    break;
  }
  return option.value.empty() ? "" : " -x";
}

/// The lines for a command's options where `condition` holds; empty: always.
std::string optionLines(const Command& command, const std::string& program, const std::string& condition) {
  const std::string start =
      fmt::format("complete -c {}{}", program, condition.empty() ? "" : fmt::format(" -n {}", fishQuoted(condition)));
  std::string lines;
  for (const Option& option : command.options) {
    if (option.isArgument) {
      if (completionOf(option) != Completion::file) {
        lines += fmt::format("{} -f{}\n", start,
                             completionOf(option) == Completion::folder ? " -a '(__fish_complete_directories)'" : "");
      }
      continue;
    }
    lines += start;
    for (const std::string& name : option.names) {
      lines += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    }
    lines += fmt::format("{} -d {}\n", valueOf(option), fishQuoted(option.description));
  }
  return lines;
}

std::string fishEffects(const std::vector<EffectPlaces>& effects) {
  std::string text = "function __naocal_effects\n  set -l part (commandline -ct | string replace -r '.*,' '')\n"
                     "  set -l front (commandline -ct | string match -r '.*,')\n  switch \"$part\"\n",
              names;
  for (const EffectPlaces& effect : effects) {
    names += " " + effect.effect + "@";
    text += fmt::format("    case '{}@*'\n      printf '%s\\n' \"$front\"{}@{{{}}}\n", effect.effect, effect.effect,
                        fmt::join(effect.places, ","));
  }
  return text + fmt::format(
                    "    case '*'\n      printf '%s\\n' \"$front\"{{{}}}\n  end\nend\n\n", names.empty() ? "" : [&] {
                      std::string list = names.substr(1);
                      for (char& letter : list) {
                        letter = letter == ' ' ? ',' : letter;
                      }
                      return list;
                    }());
}

} // namespace

std::string fishCompletion(const Command& program, const std::vector<EffectPlaces>& effects) {
  std::string text =
      fmt::format("# Completion of {} for fish; made from its own description of its options.\n\n", program.name);
  if (program.commands.empty()) {
    return text + optionLines(program, program.name, "");
  }
  text += fishEffects(effects) + optionLines(program, program.name, "__fish_use_subcommand");
  for (const Command& command : program.commands) {
    text += fmt::format("complete -c {} -n __fish_use_subcommand -f -a {} -d {}\n", program.name, command.name,
                        fishQuoted(command.description));
    const std::string given = "__fish_seen_subcommand_from " + command.name;
    std::string parts;
    for (const Command& part : command.commands) {
      parts += " " + part.name;
    }
    for (const Command& part : command.commands) {
      text += fmt::format("complete -c {} -n '{}; and not __fish_seen_subcommand_from{}' -f -a {} -d {}\n",
                          program.name, given, parts, part.name, fishQuoted(part.description));
      text += optionLines(part, program.name, given + "; and __fish_seen_subcommand_from " + part.name);
    }
    text += optionLines(command, program.name,
                        given + (parts.empty() ? "" : "; and not __fish_seen_subcommand_from" + parts));
  }
  return text;
}

} // namespace naocal::manual

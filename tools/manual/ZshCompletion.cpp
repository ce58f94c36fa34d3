#include "ZshCompletion.hpp"

#include <fmt/format.h>

namespace naocal::manual {

namespace {

/// Text inside single quotes of zsh, with what _arguments would take for its own escaped.
std::string zshQuoted(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    if (letter == '\'') {
      result += "'\\''";
    } else {
      result += (letter == '[' || letter == ']' || letter == ':' || letter == '\\') ? "\\" : "";
      result += letter;
    }
  }
  return result;
}

std::string action(const Option& option, const std::string& function) {
  switch (completionOf(option)) {
  case Completion::file:
    return "_files";
  case Completion::folder:
    return "_files -/";
  case Completion::effect:
    return function + "_effects";
  case Completion::words:
    return fmt::format("({})", fmt::join(option.words, " "));
  case Completion::none:
    break;
  }
  return " ";
}

/// The words of _arguments for an option.
std::string specification(const Option& option, const std::string& function) {
  const std::string value =
      option.value.empty() ? "" : fmt::format(":{}:{}", zshQuoted(option.value), action(option, function));
  if (option.isArgument) {
    return fmt::format("'{}{}:{}'", option.isList ? "*:" : ":", zshQuoted(option.names.front()), action(option, function));
  }
  const std::string text = fmt::format("[{}]{}", zshQuoted(option.description), value);
  if (option.names.size() == 1) {
    return fmt::format("'{}{}{}'", option.isList ? "*" : "", option.names.front(), text);
  }
  return fmt::format("'({})'{{{}}}'{}'", fmt::join(option.names, " "), fmt::join(option.names, ","), text);
}

std::string arguments(const Command& command, const std::string& function) {
  std::string text = "_arguments -s";
  for (const Option& option : command.options) {
    text += " \\\n      " + specification(option, function);
  }
  return text;
}

/// A function for a command with commands below it: the first word selects.
std::string selection(const Command& command, const std::string& function) {
  std::string text = fmt::format("{}() {{\n  local -a commands\n  commands=(\n", function);
  for (const Command& each : command.commands) {
    text += fmt::format("    '{}:{}'\n", each.name, zshQuoted(each.description));
  }
  text += "  )\n  if (( CURRENT == 2 )); then\n    _describe command commands\n    " + arguments(command, function) +
          "\n    return\n  fi\n  shift words\n  (( CURRENT-- ))\n  case \"$words[1]\" in\n";
  for (const Command& each : command.commands) {
    text += each.commands.empty() ? fmt::format("  {})\n    {}\n    ;;\n", each.name, arguments(each, "_naocal"))
                                  : fmt::format("  {}) {}_{} ;;\n", each.name, function, each.name);
  }
  return text + "  esac\n}\n\n";
}

std::string zshEffects(const std::vector<EffectPlaces>& effects) {
  std::string text = "_naocal_effects() {\n  compset -P '*,'\n  case \"$PREFIX\" in\n", names;
  for (const EffectPlaces& effect : effects) {
    names += " " + effect.effect + "@";
    text += fmt::format("  {}@*) compset -P '*@' && compadd -- {} ;;\n", effect.effect, fmt::join(effect.places, " "));
  }
  return text + fmt::format("  *) compadd -S '' --{} ;;\n  esac\n}}\n\n", names);
}

} // namespace

std::string zshCompletion(const Command& program, const std::vector<EffectPlaces>& effects) {
  std::string text =
      fmt::format("#compdef {}\n# Made from the program's own description of its options.\n\n", program.name);
  if (program.commands.empty()) {
    return text + arguments(program, "_naocal") + "\n";
  }
  text += zshEffects(effects);
  for (const Command& command : program.commands) {
    text += command.commands.empty() ? "" : selection(command, "_naocal_" + command.name);
  }
  return text + selection(program, "_naocal") + "_naocal \"$@\"\n";
}

} // namespace naocal::manual

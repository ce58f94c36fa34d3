#include "BashCompletion.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace naocal::manual {

namespace {

std::string functionName(const Command& program) {
  std::string name = "_" + program.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

/// `kind` and `list` for what completes a value.
std::string assignment(const Option& option) {
  switch (completionOf(option)) {
  case Completion::file:
    return "kind=file";
  case Completion::folder:
    return "kind=folder";
  case Completion::effect:
    return "kind=effect";
  case Completion::words:
    return fmt::format("kind=words list='{}'", fmt::join(option.words, " "));
  case Completion::none:
    break;
  }
  return "kind=value";
}

/// The branch of a command: its options, and what the word before and its arguments ask for.
std::string branch(const Command& command, const std::string& pattern) {
  std::vector<std::string> names;
  std::string cases;
  for (const Option* option : optionsOf(command)) {
    names.insert(names.end(), option->names.begin(), option->names.end());
    if (!option->value.empty()) {
      cases += fmt::format("    {}) {} ;;\n", fmt::join(option->names, " | "), assignment(*option));
    }
  }
  const Option* const argument = lastArgument(command);
  std::string text = fmt::format("  {})\n    options='{}'\n", pattern, fmt::join(names, " "));
  if (argument != nullptr) {
    text += fmt::format("    {}\n", assignment(*argument));
  } else if (!command.commands.empty()) {
    std::vector<std::string> commands;
    for (const Command& each : command.commands) {
      commands.push_back(each.name);
    }
    text += fmt::format("    kind=words list='{}'\n", fmt::join(commands, " "));
  }
  text += cases.empty() ? "" : "    case \"$before\" in\n" + cases + "    esac\n";
  return text + "    ;;\n";
}

std::string branches(const Command& program) {
  std::string text;
  for (const Command& command : program.commands) {
    for (const Command& part : command.commands) {
      text += branch(part, fmt::format("'{} {}'", command.name, part.name));
    }
    text += branch(command, fmt::format("'{}' | '{} '*", command.name, command.name));
  }
  return text + branch(program, "*");
}

/// The function that lists effects, or the places of one.
std::string bashEffects(const std::string& name, const std::vector<EffectPlaces>& effects) {
  std::string text = name + "_effects() {\n  case \"$1\" in\n";
  std::vector<std::string> names;
  for (const EffectPlaces& effect : effects) {
    names.push_back(effect.effect + "@");
    if (!effect.places.empty()) {
      std::vector<std::string> labels;
      for (const std::string& place : effect.places) {
        labels.push_back(effect.effect + "@" + place);
      }
      text += fmt::format("  {}@*) list='{}' ;;\n", effect.effect, fmt::join(labels, " "));
    }
  }
  return text + fmt::format("  *) list='{}' ;;\n  esac\n}}\n\n", fmt::join(names, " "));
}

// $line: the words up to the cursor; $word: the one under it, which bash itself splits at @, = and :.
constexpr const char* body =
    R"(  local line="${COMP_LINE:0:COMP_POINT}" word before='' command='' options='' kind='' list='' part front reply
  local -a words=()
  read -ra words <<< "$line"
  word=''
  [[ "$line" == *[[:space:]] ]] || {
    word="${words[-1]}"
    unset 'words[-1]'
  }
  [[ ${#words[@]} -gt 1 ]] && {
    before="${words[-1]}"
    command="${words[1]}"
  }
  [[ ${#words[@]} -gt 2 && "${words[2]}" != -* ]] && command+=" ${words[2]}"
  [[ "$word" == --*=* ]] && before="${word%%=*}"
)";

constexpr const char* end = R"(  COMPREPLY=()
  if [[ "$word" == --*=* ]]; then
    front="${word%%=*}="
  elif [[ "$word" == -* ]]; then
    kind=words list="$options" front=''
  else
    front=''
  fi
  part="${word#"$front"}"
  if [[ "$kind" == effect ]]; then
    [[ "$part" == *,* ]] && front+="${part%,*}," && part="${part##*,}"
    FUNCTION_effects "$part"
    [[ "$part" == *@* ]] || compopt -o nospace 2> /dev/null
    kind=words
  fi
  case "$kind" in
  file) mapfile -t COMPREPLY < <(compgen -f -- "$part") && compopt -o filenames 2> /dev/null ;;
  folder) mapfile -t COMPREPLY < <(compgen -d -- "$part") && compopt -o filenames 2> /dev/null ;;
  words) mapfile -t COMPREPLY < <(compgen -W "$list" -- "$part") ;;
  esac
  # Bash replaces the word only from the last of these letters on.
  local kept=''
  [[ "$word" == *[@=:]* ]] && kept="${word%"${word##*[@=:]}"}"
  for reply in "${!COMPREPLY[@]}"; do
    COMPREPLY[reply]="$front${COMPREPLY[reply]}"
    COMPREPLY[reply]="${COMPREPLY[reply]#"$kept"}"
  done
}
)";

} // namespace

std::string bashCompletion(const Command& program, const std::vector<EffectPlaces>& effects) {
  const std::string name = functionName(program);
  std::string closing = end;
  closing.replace(closing.find("FUNCTION"), 8, name);
  return fmt::format("# Completion of {} for bash; made from its own description of its options.\n\n", program.name) +
         bashEffects(name, effects) + name + "() {\n" + body + "  case \"$command\" in\n" + branches(program) +
         "  esac\n" + closing + fmt::format("complete -F {} {}\n", name, program.name);
}

} // namespace naocal::manual

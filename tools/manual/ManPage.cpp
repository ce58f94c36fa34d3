#include "ManPage.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace naocal::manual {

namespace {

constexpr const char* experts = "Expert options";

/// The text with what troff would take for its own escaped.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char letter : text) {
    const bool startsLine = result.empty() || result.back() == '\n';
    if (startsLine && (letter == '.' || letter == '\'')) {
      result += "\\&";
    }
    result += letter == '\\' ? "\\e" : letter == '-' ? "\\-" : std::string{letter};
  }
  return result;
}

std::string upperCase(std::string text) {
  for (char& letter : text) {
    letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  }
  return text;
}

std::string section(const std::string& title, const std::string& text) {
  return text.empty() ? "" : fmt::format(".SH {}\n{}", title, text);
}

std::string row(const std::string& heading, const std::string& text) {
  return fmt::format(".TP\n.B {}\n{}\n", escaped(heading), escaped(text));
}

/// Rows of the options in a group; arguments first.
std::string optionRows(const Command& command, bool isExpert) {
  std::string arguments, options;
  for (const Option& option : command.options) {
    if ((option.group == experts) == isExpert) {
      (option.isArgument ? arguments : options) += row(option.heading, option.description);
    }
  }
  return arguments + options;
}

std::string commandRows(const Command& command) {
  std::string rows, group;
  for (const Command& each : command.commands) {
    if (each.group != group && each.group != "Subcommands" && each.group != command.group) {
      rows += fmt::format(".SS {}\n", escaped(each.group));
      group = each.group;
    }
    rows += row(each.name, each.description);
  }
  return rows;
}

/// Text as it is, line by line.
std::string asWritten(const std::string& text) {
  return text.empty() ? "" : fmt::format(".nf\n{}\n.fi\n", escaped(text));
}

/// The commands below a command, each with its usage, options and footer.
std::string partsOf(const Command& command) {
  std::string parts;
  for (const Command& each : command.commands) {
    parts += fmt::format(".SH {}\n{}\n.PP\n.B {}\n", escaped(upperCase(each.words)), escaped(each.description),
                         escaped(each.usage));
    parts += optionRows(each, false) + optionRows(each, true) + ".PP\n" + asWritten(each.footer);
  }
  return parts;
}

std::string seeAlso(const Command& command, const Command& program) {
  std::vector<std::string> pages;
  const bool isProgram = &command == &program;
  for (const Command& each : program.commands) {
    if (isProgram || (each.group == command.group && each.name != command.name)) {
      pages.push_back(pageName(each.words));
    }
  }
  if (!isProgram) {
    pages.insert(pages.begin(), program.name);
  }
  for (const char* other : {"naocal", "naocal-robot", "mate-bridge"}) {
    if (isProgram && program.name != other) {
      pages.emplace_back(other);
    }
  }
  std::string text;
  for (const std::string& page : pages) {
    text += fmt::format(".BR {} (1){}\n", escaped(page), &page == &pages.back() ? "" : ",");
  }
  return text;
}

} // namespace

std::string pageName(const std::string& words) {
  std::string name = words;
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

std::string manPage(const Command& command, const Command& program, const std::string& version) {
  const bool hasParts = &command != &program && !command.commands.empty();
  std::string page = fmt::format(".TH {} 1 \"\" \"naocal {}\" \"naocal manual\"\n",
                                 escaped(upperCase(pageName(command.words))), version);
  std::string what = command.description;
  if (what.starts_with(command.name + ": ")) {
    what = what.substr(command.name.size() + 2);
  }
  page += section("NAME", fmt::format("{} \\- {}\n", escaped(pageName(command.words)), escaped(what)));
  page += section("SYNOPSIS", fmt::format(".B {}\n", escaped(command.usage)));
  page += section(hasParts ? "PARTS" : "COMMANDS", commandRows(command));
  page += section("OPTIONS", optionRows(command, false));
  page += section("EXPERT OPTIONS", optionRows(command, true));
  page += section("EXAMPLES", asWritten(command.footer));
  page += hasParts ? partsOf(command) : "";
  page += section("EXIT STATUS", row("0", "Done.") + row("1", "An internal error.") +
                                     row("2", "Wrong usage or input; one sentence says what is wrong.") +
                                     row("3", "Done, but the result should not be used, or a set has problems."));
  if (program.name == "naocal") {
    page += section("ENVIRONMENT", row("NAOCAL_CONFIGURATION", "A folder to take instead of the configuration that is "
                                                               "installed: robots, drawings, poses."));
  }
  return page + section("SEE ALSO", seeAlso(command, program));
}

} // namespace naocal::manual

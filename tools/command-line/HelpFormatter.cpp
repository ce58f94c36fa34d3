#include "command-line/HelpFormatter.hpp"

#include "command-line/OptionChecks.hpp"
#include "command-line/OptionText.hpp"
#include "command-line/TextLayout.hpp"

#include <fmt/format.h>
#include <utility>
#include <vector>

namespace naocal {

namespace {

constexpr std::size_t widestHead = 27; // columns of a name and its value that have their text beside them

/// Rows of a heading's table: head and text.
struct Section {
  std::string title;
  std::vector<std::pair<std::string, std::string>> rows;
};

std::vector<const CLI::App*> commandsOf(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

Section& section(std::vector<Section>& sections, const std::string& title) {
  for (Section& each : sections) {
    if (each.title == title) {
      return each;
    }
  }
  return sections.emplace_back(Section{title, {}});
}

/// Groups in order of their first member; experts' options last.
std::vector<Section> sectionsOf(const CLI::App& app) {
  std::vector<Section> sections;
  for (const CLI::App* command : commandsOf(app)) {
    const bool isInherited = command->get_group() == "Subcommands" || command->get_group() == app.get_group();
    const std::string group = isInherited ? "Commands" : command->get_group();
    section(sections, group).rows.emplace_back(command->get_name(), command->get_description());
  }
  Section experts{expertOptions, {}}, help;
  std::vector<Section> ofOptions;
  for (const CLI::Option* option : app.get_options()) {
    const OptionText text = describeOption(*option);
    if (text.group.empty()) {
      continue;
    }
    const std::pair row{text.heading(), text.description};
    if (text.isArgument) {
      section(ofOptions, "").rows.push_back(row);
    } else if (option == app.get_help_ptr() || text.name() == "--version") {
      help.rows.push_back(row);
    } else {
      (text.group == expertOptions ? experts : section(ofOptions, text.group)).rows.push_back(row);
    }
  }
  Section& usual = section(ofOptions, "Options"); // help is the last of the usual options
  usual.rows.insert(usual.rows.end(), help.rows.begin(), help.rows.end());
  const auto arguments =
      std::find_if(ofOptions.begin(), ofOptions.end(), [](const Section& each) { return each.title.empty(); });
  std::rotate(ofOptions.begin(), arguments, arguments == ofOptions.end() ? arguments : arguments + 1);
  sections.insert(sections.end(), ofOptions.begin(), ofOptions.end());
  if (!experts.rows.empty()) {
    sections.push_back(std::move(experts));
  }
  return sections;
}

/// Column where the texts of a help begin.
std::size_t textColumn(const std::vector<Section>& sections) {
  std::size_t widest = 0;
  for (const Section& each : sections) {
    for (const auto& [head, text] : each.rows) {
      if (columnsOf(head) <= widestHead) {
        widest = std::max(widest, columnsOf(head));
      }
    }
  }
  return widest + 4;
}

} // namespace

std::string usageLine(const CLI::App& app, const std::string& name) {
  std::string line = name + " [OPTIONS]";
  for (const CLI::Option* option : app.get_options()) {
    const OptionText text = describeOption(*option);
    if (text.isArgument) {
      line += " " + (text.isRequired ? text.heading() : fmt::format("[{}]", text.heading()));
    } else if (text.isRequired) {
      line += fmt::format(" {} {}", text.names.front(), text.value);
    }
  }
  return line + (commandsOf(app).empty() ? "" : " COMMAND ...");
}

std::string HelpFormatter::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode /*mode*/) const {
  const std::size_t width = terminalWidth();
  const std::string words = name.empty() ? app->get_name() : name;
  std::string help = wrapText(app->get_description(), width) + "\n";
  help += wrapText("Usage: " + usageLine(*app, words), width, 7);
  const std::vector<Section> sections = sectionsOf(*app);
  const std::size_t start = textColumn(sections);
  for (const auto& [title, rows] : sections) {
    help += title.empty() ? "\n" : "\n" + title + ":\n";
    for (const auto& [head, text] : rows) {
      help += layOutRow(head, text, start, width);
    }
  }
  if (!app->get_footer().empty()) {
    help += "\n" + wrapText(app->get_footer(), width, 2);
  }
  return help;
}

} // namespace naocal

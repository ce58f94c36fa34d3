#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace naocal {

/// Help of all programs: commands and options in groups, wrapped at the terminal's width.
class HelpFormatter : public CLI::FormatterBase {
public:
  /// `name`: the words that call the command, "naocal solve".
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
};

/// The line that shows how a command is called: "naocal solve [OPTIONS] SET...".
std::string usageLine(const CLI::App& app, const std::string& name);

} // namespace naocal

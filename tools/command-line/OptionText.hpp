#pragma once

#include <string>
#include <vector>

namespace CLI {
class Option;
}

namespace naocal {

/// An option or argument of a command line in words, for help, manual pages and completion.
struct OptionText {
  std::vector<std::string> names; // "-o", "--output"; of an argument its one name, "SET"
  std::string value;              // "FILE", "N", "left|right|both"; of a flag empty
  std::vector<std::string> words; // the values that are accepted, where these are few words
  std::string description;        // with default and range: "poses to plan (default 8, 1 to 1000)"
  std::string group;              // heading in help
  bool isArgument = false, isRequired = false, isList = false;

  /// "-o, --output FILE", "SET...".
  std::string heading() const;
  /// The name in sentences: the long one, "--output".
  const std::string& name() const { return names.back(); }
};

OptionText describeOption(const CLI::Option& option);

} // namespace naocal

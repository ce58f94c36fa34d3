#include "command-line/OptionText.hpp"

#include "command-line/TextLayout.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace naocal {

namespace {

constexpr std::size_t longestValue = 24; // letters of the words that stand in the place of a value

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(separator, at), text.size());
    parts.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return parts;
}

/// What stands for a value of CLI11's types.
std::string placeholder(const std::string& type) {
  if (type == "INT" || type == "UINT") {
    return "N";
  }
  return type == "FLOAT" ? "NUMBER" : type == "ENUM" ? "NAME" : type;
}

/// The default value; of lists without brackets.
std::string defaultText(const CLI::Option& option) {
  std::string text = option.get_default_str();
  if (text.size() > 1 && text.front() == '[' && text.back() == ']') {
    text = text.substr(1, text.size() - 2);
  }
  return text;
}

} // namespace

std::string OptionText::heading() const {
  std::string text = isArgument ? names.front() : fmt::format("{}", fmt::join(names, ", "));
  if (isArgument) {
    return text + (isList ? "..." : "");
  }
  return value.empty() ? text : text + " " + value;
}

OptionText describeOption(const CLI::Option& option) {
  OptionText text;
  text.isArgument = option.get_positional();
  text.isRequired = option.get_required();
  text.isList = option.get_items_expected_max() > 2;
  text.group = option.get_group();
  if (text.isArgument) {
    text.names.push_back(option.get_name(true));
  }
  for (const std::string& name : option.get_snames()) {
    text.names.push_back("-" + name);
  }
  for (const std::string& name : option.get_lnames()) {
    text.names.push_back("--" + name);
  }
  std::vector<std::string> limits;
  if (const std::string standard = defaultText(option); !standard.empty() && option.get_items_expected_max() > 0) {
    limits.push_back("default " + standard);
  }
  if (option.get_items_expected_max() > 0) {
    std::vector<std::string> parts = split(option.get_type_name(), ':'); // type, then what each check accepts
    text.value = placeholder(parts.front());
    for (auto part = parts.begin() + 1; part != parts.end(); ++part) {
      if (part->find('|') != std::string::npos) {
        text.words = split(*part, '|');
        if (part->size() <= longestValue) {
          text.value = *part;
        } else {
          limits.push_back(joinWords(text.words, "or"));
        }
      } else {
        limits.push_back(*part);
      }
    }
  }
  text.description = option.get_description();
  if (!limits.empty()) {
    text.description += fmt::format(" ({})", fmt::join(limits, "; "));
  }
  return text;
}

} // namespace naocal

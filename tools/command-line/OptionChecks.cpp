#include "command-line/OptionChecks.hpp"

#include "command-line/TextLayout.hpp"

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <optional>

namespace naocal {

namespace {

constexpr std::int64_t unlimited = std::numeric_limits<std::int64_t>::max();

/// The range as in "expected a whole number from 1 to 1000" and, without `from`, as in help.
std::string rangeText(std::int64_t low, std::int64_t high) {
  return high == unlimited ? fmt::format("{} or more", low) : fmt::format("{} to {}", low, high);
}

bool isWhole(const std::string& text, std::int64_t low, std::int64_t high) {
  const char* const end = text.data() + text.size();
  std::int64_t value = 0;
  if (const auto [rest, error] = std::from_chars(text.data(), end, value); error == std::errc{} && rest == end) {
    return low <= value && value <= high;
  }
  std::uint64_t large = 0; // such as a seed beyond the signed range
  const auto [rest, error] = std::from_chars(text.data(), end, large);
  return error == std::errc{} && rest == end && high == unlimited;
}

/// The finite number that the whole text is.
std::optional<double> finite(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool isNumber = !text.empty() && *end == '\0' && std::isfinite(value) && std::isspace(text.front()) == 0;
  return isNumber ? std::optional{value} : std::nullopt;
}

std::string lowerCase(std::string text) {
  for (char& letter : text) {
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return text;
}

CLI::Validator existing(bool isFolder) {
  return CLI::Validator{[isFolder](const std::string& name) {
                          std::error_code unreadable;
                          const auto status = std::filesystem::status(name, unreadable);
                          const bool isThere = std::filesystem::exists(status);
                          if (isThere && std::filesystem::is_directory(status) == isFolder) {
                            return std::string{};
                          }
                          return fmt::format("expected {} that exists, found {}", isFolder ? "a folder" : "a file",
                                             !isThere   ? fmt::format("nothing at \"{}\"", name)
                                             : isFolder ? fmt::format("the file \"{}\"", name)
                                                        : fmt::format("the folder \"{}\"", name));
                        },
                        ""};
}

/// CLI11's names of types without a check.
bool isUncheckedNumber(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  return type == "INT" || type == "UINT" || type == "FLOAT";
}

} // namespace

CLI::Validator wholeNumber(std::int64_t low, std::int64_t high) {
  return CLI::Validator{[low, high](const std::string& text) {
                          return isWhole(text, low, high) ? std::string{}
                                                          : fmt::format("expected a whole number, {}, found \"{}\"",
                                                                        rangeText(low, high), text);
                        },
                        rangeText(low, high)};
}

CLI::Validator number(double low, double high) {
  return CLI::Validator{[low, high](const std::string& text) {
                          const auto value = finite(text);
                          return value && low <= *value && *value <= high
                                     ? std::string{}
                                     : fmt::format("expected a number from {:g} to {:g}, found \"{}\"", low, high,
                                                   text);
                        },
                        fmt::format("{:g} to {:g}", low, high)};
}

CLI::Validator positiveNumber() {
  return CLI::Validator{[](const std::string& text) {
                          const auto value = finite(text);
                          return value && *value > 0 ? std::string{}
                                                     : fmt::format("expected a number above 0, found \"{}\"", text);
                        },
                        "above 0"};
}

CLI::Validator oneOf(std::vector<std::string> words) {
  const std::string shown = fmt::format("{}", fmt::join(words, "|"));
  return CLI::Validator{[words = std::move(words)](const std::string& text) {
                          return std::find(words.begin(), words.end(), text) != words.end()
                                     ? std::string{}
                                     : fmt::format("expected {}, found \"{}\"", joinWords(words, "or"), text);
                        },
                        shown};
}

CLI::Validator oneOfNames(std::map<std::string, int> numbers, std::vector<std::string> order) {
  const std::string shown = fmt::format("{}", fmt::join(order, "|"));
  return CLI::Validator{[numbers = std::move(numbers), order = std::move(order)](std::string& text) {
                          for (const auto& [name, value] : numbers) {
                            if (lowerCase(name) == lowerCase(text)) {
                              text = std::to_string(value);
                              return std::string{};
                            }
                          }
                          return fmt::format("expected {}, found \"{}\"", joinWords(order, "or"), text);
                        },
                        shown};
}

CLI::Validator existingFile() {
  return existing(false);
}

CLI::Validator existingFolder() {
  return existing(true);
}

void checkNumbers(CLI::App& app) {
  for (CLI::Option* const option : app.get_options()) {
    if (!isUncheckedNumber(*option)) {
      continue;
    }
    const std::string type = option->get_type_name();
    const double most = std::numeric_limits<double>::max();
    constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();
    option->check((type == "FLOAT" ? number(-most, most) : wholeNumber(type == "UINT" ? 0 : least)).description(""));
  }
  for (CLI::App* const command : app.get_subcommands([](CLI::App*) { return true; })) {
    checkNumbers(*command);
  }
}

} // namespace naocal

#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace naocal {

/// Group of options that a first calibration does not need; help lists them last.
inline constexpr const char* expertOptions = "Expert options";

/// Accepts whole numbers from `low` to `high`. Help shows the range.
CLI::Validator wholeNumber(std::int64_t low, std::int64_t high = std::numeric_limits<std::int64_t>::max());

/// Accepts finite numbers from `low` to `high`. Help shows the range.
CLI::Validator number(double low, double high);

/// Accepts finite numbers above 0.
CLI::Validator positiveNumber();

/// Accepts one of the words. Help shows them; an error names them.
CLI::Validator oneOf(std::vector<std::string> words);

/// Accepts one of the names, in any case, and replaces it by its number; for CLI::Option::transform.
CLI::Validator oneOfNames(std::map<std::string, int> numbers, std::vector<std::string> order = {});

/// The same for an enumeration.
template <class Enumeration> CLI::Validator oneOf(const std::map<std::string, Enumeration>& values) {
  std::map<std::string, int> numbers;
  std::vector<std::pair<int, std::string>> order;
  for (const auto& [name, value] : values) {
    numbers[name] = static_cast<int>(value);
    order.emplace_back(static_cast<int>(value), name);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::string> names;
  for (const auto& [value, name] : order) {
    names.push_back(name);
  }
  return oneOfNames(std::move(numbers), std::move(names));
}

/// Accepts the name of a file, or of a folder, that exists.
CLI::Validator existingFile();
CLI::Validator existingFolder();

/// Adds checks to the number options of an application and its commands that have none: unsigned numbers refuse a
/// sign, all refuse words.
void checkNumbers(CLI::App& app);

} // namespace naocal

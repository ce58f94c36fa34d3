#include "captures/JsonPlace.hpp"

#include "captures/InputError.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

using nlohmann::json;

std::string description(const json& value) {
  switch (value.type()) {
  case json::value_t::array:
    return fmt::format("a list of {}", value.size());
  case json::value_t::object:
    return "an object";
  default:
    const std::string text = value.dump(-1, ' ', true); // ASCII: it may be cut anywhere
    return text.size() <= 60 ? text : text.substr(0, 60) + "...";
  }
}

/// The number, or NaN when there is none within the range.
double numberWithin(const Range& range, const json& value) {
  const double number = value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
  return number >= range.lowest && number <= range.highest ? number : std::numeric_limits<double>::quiet_NaN();
}

} // namespace

JsonPlace::JsonPlace(const json& value, std::string file)
    : JsonPlace{value, "", std::make_shared<Surroundings>(Surroundings{std::move(file), "", ""})} {}

JsonPlace::JsonPlace(const json& value, std::string path, std::shared_ptr<const Surroundings> surroundings)
    : value_{&value}, path_{std::move(path)}, surroundings_{std::move(surroundings)} {}

JsonPlace JsonPlace::about(std::string name, std::string remedy) const {
  return {*value_, path_,
          std::make_shared<Surroundings>(Surroundings{surroundings_->file, std::move(name), std::move(remedy)})};
}

JsonPlace JsonPlace::member(const std::string& key, const json& value) const {
  return {value, path_.empty() ? key : path_ + "." + key, surroundings_};
}

void JsonPlace::refuse(std::string_view expected, std::string_view found) const {
  const auto& [file, name, remedy] = *surroundings_;
  throw InputError{fmt::format("{}: {}{}: expected {}, found {}{}{}", file, path_.empty() ? "top level" : path_,
                               name.empty() ? "" : " (" + name + ")", expected,
                               found.empty() ? description(*value_) : found, remedy.empty() ? "" : "; ", remedy)};
}

void JsonPlace::requireObject() const {
  if (!value_->is_object()) {
    refuse("an object");
  }
}

std::optional<JsonPlace> JsonPlace::find(const std::string& key) const {
  requireObject();
  const auto entry = value_->find(key);
  if (entry == value_->end()) {
    return std::nullopt;
  }
  return member(key, *entry);
}

JsonPlace JsonPlace::at(const std::string& key) const {
  const auto place = find(key);
  if (!place) {
    refuse(fmt::format("the key \"{}\"", key), "none");
  }
  return *place;
}

std::vector<JsonPlace> JsonPlace::elements() const {
  if (!value_->is_array()) {
    refuse("a list");
  }
  std::vector<JsonPlace> elements;
  elements.reserve(value_->size());
  for (const json& element : *value_) {
    elements.push_back({element, fmt::format("{}[{}]", path_, elements.size()), surroundings_});
  }
  return elements;
}

std::vector<std::pair<std::string, JsonPlace>> JsonPlace::members() const {
  requireObject();
  std::vector<std::pair<std::string, JsonPlace>> members;
  for (const auto& [key, value] : value_->items()) {
    members.emplace_back(key, member(key, value));
  }
  return members;
}

std::string JsonPlace::text() const {
  if (!value_->is_string() || value_->get_ref<const std::string&>().empty()) {
    refuse("a text that is not empty");
  }
  return value_->get<std::string>();
}

bool JsonPlace::boolean() const {
  if (!value_->is_boolean()) {
    refuse("true or false");
  }
  return value_->get<bool>();
}

int JsonPlace::integer(int lowest, int highest) const {
  const double number = numberWithin({static_cast<double>(lowest), static_cast<double>(highest), ""}, *value_);
  if (std::isnan(number) || number != std::floor(number)) {
    refuse(fmt::format("a whole number from {} to {}", lowest, highest));
  }
  return static_cast<int>(number);
}

double JsonPlace::number(const Range& range) const {
  const double number = numberWithin(range, *value_);
  if (std::isnan(number)) {
    refuse(fmt::format("a number from {:g} to {:g}{}{}", range.lowest, range.highest, range.unit.empty() ? "" : " ",
                       range.unit));
  }
  return number;
}

std::vector<double> JsonPlace::numbers(std::size_t count, const Range& range, std::string_view why,
                                       bool nullable) const {
  if (!value_->is_array() || value_->size() != count) {
    refuse(fmt::format("a list of {} numbers ({})", count, why));
  }
  std::vector<double> numbers;
  numbers.reserve(count);
  for (const json& element : *value_) {
    const double number = numberWithin(range, element);
    if (std::isnan(number) && !(nullable && element.is_null())) {
      elements()[numbers.size()].number(range);
    }
    numbers.push_back(number);
  }
  return numbers;
}

std::size_t JsonPlace::oneOf(const std::vector<std::string_view>& words) const {
  const auto word = std::find_if(words.begin(), words.end(), [&](std::string_view candidate) {
    return value_->is_string() && value_->get_ref<const std::string&>() == candidate;
  });
  if (word == words.end()) {
    refuse(fmt::format("one of {}", fmt::join(words, ", ")));
  }
  return static_cast<std::size_t>(word - words.begin());
}

} // namespace naocal

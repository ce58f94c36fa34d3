#include "io/JsonReader.hpp"

#include "io/InputError.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <vector>

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
    const std::string text = value.dump(-1, ' ', true); // ASCII: may be cut at any byte
    return text.size() <= 60 ? text : text.substr(0, 60) + "...";
  }
}

/// The number, or NaN if it is missing or out of range.
double numberWithin(const Range& range, const json& value) {
  const double number = value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
  return number >= range.lowest && number <= range.highest ? number : std::numeric_limits<double>::quiet_NaN();
}

using nlohmann::json;

constexpr std::size_t deepest = 100; // nesting limit: far above any valid file, stops endless open brackets

/// Parser callback: refuses duplicate keys and excessive nesting.
class Watch {
public:
  explicit Watch(const std::string& file) : file_{file} {}

  bool operator()(json::parse_event_t event, const json& parsed) {
    using Event = json::parse_event_t;
    if (event == Event::object_end || event == Event::array_end) {
      open_.pop_back();
      return true;
    }
    if (event == Event::key) {
      enter(parsed.get_ref<const std::string&>());
      return true;
    }
    if (!open_.empty() && !open_.back().isObject) {
      ++open_.back().elements;
    }
    if (event == Event::object_start || event == Event::array_start) {
      if (open_.size() == deepest) {
        throw InputError{
            fmt::format("{}: {}: expected at most {} levels of brackets, found more", file_, path(), deepest)};
      }
      open_.push_back({event == Event::object_start, 0, {}, {}});
    }
    return true;
  }

private:
  struct Level {
    bool isObject;
    std::size_t elements;
    std::string key;
    std::set<std::string> keys;
  };

  void enter(const std::string& key) {
    Level& level = open_.back();
    if (!level.keys.insert(key).second) {
      level.key.clear();
      throw InputError{
          fmt::format("{}: {}: expected every key once, found \"{}\" twice; remove one of them", file_, path(), key)};
    }
    level.key = key;
  }

  std::string path() const {
    std::string path;
    for (const Level& level : open_) {
      if (level.isObject) {
        path += level.key.empty() ? "" : (path.empty() ? "" : ".") + level.key;
      } else if (level.elements > 0) {
        path += fmt::format("[{}]", level.elements - 1);
      }
    }
    return path.empty() ? "top level" : path;
  }

  const std::string& file_;
  std::vector<Level> open_;
};

/// The text with the non-JSON number literals quoted; empty if there are none.
std::string quoteLiterals(std::string_view text) {
  std::string quoted;
  std::size_t copied = 0;
  bool inString = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (inString && text[i] == '\\') {
      ++i;
    } else if (text[i] == '"') {
      inString = !inString;
    } else if (!inString && (text[i] == 'N' || text[i] == 'I')) {
      const std::string_view literal = text[i] == 'N' ? "NaN" : "Infinity";
      if (text.substr(i, literal.size()) == literal) {
        const std::size_t start = i > copied && text[i - 1] == '-' ? i - 1 : i;
        quoted.append(text.substr(copied, start - copied));
        copied = i + literal.size();
        quoted.append("\"").append(text.substr(start, copied - start)).append("\"");
        i = copied - 1;
      }
    }
  }
  return copied == 0 ? std::string{} : quoted.append(text.substr(copied));
}

} // namespace

JsonCursor::JsonCursor(const json& value, std::string file)
    : JsonCursor{value, "", std::make_shared<Surroundings>(Surroundings{std::move(file), "", "", nullptr})} {}

JsonCursor::JsonCursor(const json& value, std::string path, std::shared_ptr<const Surroundings> surroundings)
    : value_{&value}, path_{std::move(path)}, surroundings_{std::move(surroundings)} {}

JsonCursor JsonCursor::describeAs(std::string name, std::string remedy) const {
  return {*value_, path_,
          std::make_shared<Surroundings>(
              Surroundings{surroundings_->file, std::move(name), std::move(remedy), surroundings_->asked})};
}

JsonCursor JsonCursor::recordKeys(AskedKeys& asked) const {
  Surroundings recording = *surroundings_;
  recording.asked = &asked;
  return {*value_, path_, std::make_shared<Surroundings>(std::move(recording))};
}

JsonCursor JsonCursor::member(const std::string& key, const json& value) const {
  return {value, path_.empty() ? key : path_ + "." + key, surroundings_};
}

void JsonCursor::refuse(std::string_view expected, std::string_view found) const {
  const auto& [file, name, remedy, asked] = *surroundings_;
  throw InputError{fmt::format("{}: {}{}: expected {}, found {}{}{}", file, path_.empty() ? "top level" : path_,
                               name.empty() ? "" : " (" + name + ")", expected,
                               found.empty() ? description(*value_) : found, remedy.empty() ? "" : "; ", remedy)};
}

void JsonCursor::requireObject() const {
  if (!value_->is_object()) {
    refuse("an object");
  }
}

std::optional<JsonCursor> JsonCursor::find(const std::string& key) const {
  requireObject();
  if (surroundings_->asked != nullptr) {
    (*surroundings_->asked)[value_].insert(key);
  }
  const auto entry = value_->find(key);
  if (entry == value_->end()) {
    return std::nullopt;
  }
  return member(key, *entry);
}

JsonCursor JsonCursor::at(const std::string& key) const {
  const auto place = find(key);
  if (!place) {
    refuse(fmt::format("the key \"{}\"", key), "none");
  }
  return *place;
}

std::vector<JsonCursor> JsonCursor::elements() const {
  if (!value_->is_array()) {
    refuse("a list");
  }
  std::vector<JsonCursor> elements;
  elements.reserve(value_->size());
  for (const json& element : *value_) {
    elements.push_back({element, fmt::format("{}[{}]", path_, elements.size()), surroundings_});
  }
  return elements;
}

std::vector<std::pair<std::string, JsonCursor>> JsonCursor::members() const {
  requireObject();
  std::vector<std::pair<std::string, JsonCursor>> members;
  for (const auto& [key, value] : value_->items()) {
    if (surroundings_->asked != nullptr) {
      (*surroundings_->asked)[value_].insert(key);
    }
    members.emplace_back(key, member(key, value));
  }
  return members;
}

std::string JsonCursor::text() const {
  if (!value_->is_string() || value_->get_ref<const std::string&>().empty()) {
    refuse("a text that is not empty");
  }
  const auto& text = value_->get_ref<const std::string&>();
  if (text.size() > longestText) {
    refuse(fmt::format("a text of at most {} bytes", longestText), fmt::format("one of {}", text.size()));
  }
  if (text.find('\0') != std::string::npos) { // would end the text for libraries in C
    refuse("a text without zero bytes");
  }
  return text;
}

bool JsonCursor::boolean() const {
  if (!value_->is_boolean()) {
    refuse("true or false");
  }
  return value_->get<bool>();
}

int JsonCursor::integer(int lowest, int highest) const {
  const double number = numberWithin({static_cast<double>(lowest), static_cast<double>(highest), ""}, *value_);
  if (std::isnan(number) || number != std::floor(number)) {
    refuse(fmt::format("a whole number from {} to {}", lowest, highest));
  }
  return static_cast<int>(number);
}

double JsonCursor::number(const Range& range) const {
  const double number = numberWithin(range, *value_);
  if (std::isnan(number)) {
    refuse(fmt::format("a number from {:g} to {:g}{}{}", range.lowest, range.highest, range.unit.empty() ? "" : " ",
                       range.unit));
  }
  return number;
}

std::vector<double> JsonCursor::numbers(std::size_t count, const Range& range, std::string_view why,
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

std::vector<std::string> JsonCursor::texts() const {
  std::vector<std::string> result;
  for (const JsonCursor& element : elements()) {
    result.push_back(element.text());
  }
  return result;
}

std::size_t JsonCursor::wordIndex(const std::vector<std::string_view>& words) const {
  const auto word = std::find_if(words.begin(), words.end(), [&](std::string_view candidate) {
    return value_->is_string() && value_->get_ref<const std::string&>() == candidate;
  });
  if (word == words.end()) {
    refuse(fmt::format("one of {}", fmt::join(words, ", ")));
  }
  return static_cast<std::size_t>(word - words.begin());
}

json parseJson(const std::string& text, const std::string& file) {
  const auto parse = [&](const std::string& document) {
    Watch watch{file};
    return json::parse(document, [&](int, json::parse_event_t event, json& parsed) { return watch(event, parsed); });
  };
  try {
    return parse(text);
  } catch (const json::exception& error) {
    if (const std::string quoted = quoteLiterals(text); !quoted.empty()) {
      try {
        return parse(quoted);
      } catch (const json::exception&) {
        // The text has other errors, too: reports the first one.
      }
    }
    const std::string_view message = error.what(); // "[json.exception.parse_error.101] parse error at line 1, ..."
    const auto reason = message.substr(std::min(message.find("] "), message.size() - 2) + 2);
    throw InputError{fmt::format("{}: expected valid JSON, found a {}", file, reason)};
  }
}

} // namespace naocal

#include "captures/JsonText.hpp"

#include "captures/InputError.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <vector>

namespace naocal {
namespace {

using nlohmann::json;

constexpr std::size_t deepest = 100; // far deeper than any file of ours; an open bracket repeated forever ends here

/// Watches a document while it is parsed: no object holds a key twice, nothing is nested endlessly.
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

/// The text with the number literals that JSON does not know quoted; empty when there are none.
std::string withQuotedLiterals(std::string_view text) {
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

json parseJson(const std::string& text, const std::string& file) {
  const auto parse = [&](const std::string& document) {
    Watch watch{file};
    return json::parse(document, [&](int, json::parse_event_t event, json& parsed) { return watch(event, parsed); });
  };
  try {
    return parse(text);
  } catch (const json::exception& error) {
    if (const std::string quoted = withQuotedLiterals(text); !quoted.empty()) {
      try {
        return parse(quoted);
      } catch (const json::exception&) {
        // The text has other errors, too: its first one is reported.
      }
    }
    const std::string_view message = error.what(); // "[json.exception.parse_error.101] parse error at line 1, ..."
    const auto reason = message.substr(std::min(message.find("] "), message.size() - 2) + 2);
    throw InputError{fmt::format("{}: expected valid JSON, found a {}", file, reason)};
  }
}

} // namespace naocal

#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace naocal {

/// The numbers a quantity can sensibly have; `unit` is said in refusals.
struct Range {
  double lowest, highest;
  std::string_view unit;
};
inline constexpr Range anyNumber{-1e15, 1e15, ""};
inline constexpr int maxInteger = std::numeric_limits<int>::max();

/// One place in a JSON document and what it is called, so that every refusal (InputError) names file, path, what was
/// expected and what was found. The document must outlive it.
class JsonCursor {
public:
  /// The top level of a file's document.
  JsonCursor(const nlohmann::json& value, std::string file);

  /// The same place with what to call it beside its path ("capture 17") and what to do when it is refused.
  JsonCursor describeAs(std::string name, std::string remedy) const;

  /// The value under a key of this object; `find` is empty and `at` refuses when there is none.
  std::optional<JsonCursor> find(const std::string& key) const;
  JsonCursor at(const std::string& key) const;

  /// The entries of this list, or the values of this object with their keys.
  std::vector<JsonCursor> elements() const;
  std::vector<std::pair<std::string, JsonCursor>> members() const;

  std::string text() const; // not empty
  bool boolean() const;
  int integer(int lowest, int highest) const;
  double number(const Range& range) const;

  /// A list of `count` numbers; `why` says in a refusal what the count comes from. With `nullable` null becomes NaN.
  std::vector<double> numbers(std::size_t count, const Range& range, std::string_view why, bool nullable = false) const;

  /// The index among `words` of the text at this place.
  std::size_t wordIndex(const std::vector<std::string_view>& words) const;

  /// Throws InputError: file, path, `expected`, and what is found here unless `found` says it better.
  [[noreturn]] void refuse(std::string_view expected, std::string_view found = {}) const;

  const nlohmann::json& value() const { return *value_; }

private:
  struct Surroundings {
    std::string file, name, remedy;
  };

  JsonCursor(const nlohmann::json& value, std::string path, std::shared_ptr<const Surroundings> surroundings);
  JsonCursor member(const std::string& key, const nlohmann::json& value) const;
  void requireObject() const;

  const nlohmann::json* value_;
  std::string path_;
  std::shared_ptr<const Surroundings> surroundings_;
};

/// The document in a JSON text; `file` stands for it in messages. Throws InputError with line and column for broken
/// syntax, and for a key that occurs twice in one object.
///
/// The literals NaN, Infinity and -Infinity, which JSON does not know but many writers use, become texts: whoever
/// expects a number there refuses them at their place, and not the whole file because of one.
nlohmann::json parseJson(const std::string& text, const std::string& file);

} // namespace naocal

#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace naocal {

/// Valid range of a quantity; `unit` appears in error messages.
struct Range {
  double lowest, highest;
  std::string_view unit;
};
inline constexpr Range anyNumber{-1e15, 1e15, ""};
inline constexpr std::size_t longestText = 10'000; // [bytes] of a name, an expression or a sentence
inline constexpr int maxInteger = std::numeric_limits<int>::max();

/// Keys that a reader asked for, by object of the document: what it never asks for, it ignores.
using AskedKeys = std::map<const nlohmann::json*, std::set<std::string>>;

/// A place in a JSON document with its path, for error messages (InputError) with file, path, expected and found. The
/// document must outlive it.
class JsonCursor {
public:
  /// The top level of a file's document.
  JsonCursor(const nlohmann::json& value, std::string file);

  /// The same place with a description beside its path ("capture 17") and a remedy for error messages.
  JsonCursor describeAs(std::string name, std::string remedy) const;

  /// The same place; from here on, `asked` records the keys that are asked for. It must outlive the cursor.
  JsonCursor recordKeys(AskedKeys& asked) const;

  /// The value under a key of this object. If there is none, `find` returns nothing and `at` throws.
  std::optional<JsonCursor> find(const std::string& key) const;
  JsonCursor at(const std::string& key) const;

  /// Elements of this list, or (key, value) members of this object.
  std::vector<JsonCursor> elements() const;
  std::vector<std::pair<std::string, JsonCursor>> members() const;

  /// The value here. Throws InputError if it has another type or is out of range.
  std::string text() const; // not empty, at most `longestText`, without zero bytes
  bool boolean() const;
  int integer(int lowest, int highest) const;
  double number(const Range& range) const;

  /// A list of `count` numbers; `why` explains the count in error messages. With `nullable`, null becomes NaN.
  std::vector<double> numbers(std::size_t count, const Range& range, std::string_view why, bool nullable = false) const;

  /// A list of texts.
  std::vector<std::string> texts() const;

  /// Index of this text among `words`.
  std::size_t wordIndex(const std::vector<std::string_view>& words) const;

  /// Throws InputError with file, path, `expected`, and `found` or else the value here.
  [[noreturn]] void refuse(std::string_view expected, std::string_view found = {}) const;

  const nlohmann::json& value() const { return *value_; }

private:
  struct Surroundings {
    std::string file, name, remedy;
    AskedKeys* asked = nullptr;
  };

  JsonCursor(const nlohmann::json& value, std::string path, std::shared_ptr<const Surroundings> surroundings);
  JsonCursor member(const std::string& key, const nlohmann::json& value) const;
  void requireObject() const;

  const nlohmann::json* value_;
  std::string path_;
  std::shared_ptr<const Surroundings> surroundings_;
};

/// Parses a JSON text; `file` stands for it in messages. Throws InputError with line and column for invalid syntax, and
/// for a duplicate key within an object.
///
/// Converts the literals NaN, Infinity and -Infinity, invalid in JSON but common, to strings. A reader that expects a
/// number then refuses that place alone instead of the whole file.
nlohmann::json parseJson(const std::string& text, const std::string& file);

} // namespace naocal

#include "dialects/text/MapText.hpp"

#include "io/InputError.hpp"
#include "math/Angles.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace naocal {
namespace {

/// Reads from a text, and knows its line.
class MapReader {
public:
  MapReader(std::string_view text, const std::string& file) : text_{text}, file_{file} {}

  MapText readAll() {
    MapText all;
    readMembers(all, '\0', 0);
    return all;
  }

private:
  static constexpr int deepest = 50; // nested values

  [[noreturn]] void refuse(std::string_view expected) const {
    const std::string found = at_ < text_.size() ? fmt::format("\"{}\"", text_[at_]) : "the end of the file";
    throw InputError{fmt::format("{}: line {}: expected {}, found {}", file_, line_, expected, found)};
  }

  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void advance() { line_ += text_[at_++] == '\n' ? 1 : 0; }

  void skipSpace() {
    while (at_ < text_.size()) {
      if (std::isspace(static_cast<unsigned char>(peek()))) {
        advance();
      } else if (text_.substr(at_, 2) == "//") {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (text_.substr(at_, 2) == "/*") {
        const std::size_t end = text_.find("*/", at_ + 2);
        if (end == std::string_view::npos) {
          refuse("*/ behind the comment that begins here");
        }
        while (at_ < end + 2) {
          advance();
        }
      } else {
        return;
      }
    }
  }

  void require(char sign, std::string_view expected) {
    skipSpace();
    if (at_ >= text_.size() || peek() != sign) {
      refuse(expected);
    }
    ++at_;
  }

  std::string readName() {
    const std::size_t begin = at_;
    while (std::isalnum(static_cast<unsigned char>(peek())) || peek() == '_') {
      ++at_;
    }
    if (at_ == begin) {
      refuse("a name and \"=\"");
    }
    return std::string{text_.substr(begin, at_ - begin)};
  }

  std::string readLiteral() {
    if (peek() == '"') {
      const std::size_t end = text_.find_first_of("\"\n", at_ + 1);
      if (end == std::string_view::npos || text_[end] != '"') {
        refuse("a text in quotes that ends on its line");
      }
      const std::string_view inside = text_.substr(at_ + 1, end - at_ - 1);
      at_ = end + 1;
      return std::string{inside};
    }
    const std::size_t begin = at_;
    while (at_ < text_.size() && !std::isspace(static_cast<unsigned char>(peek())) &&
           std::string_view{";,={}[]\"/"}.find(peek()) == std::string_view::npos) {
      ++at_;
    }
    if (at_ == begin) {
      refuse("a value");
    }
    return std::string{text_.substr(begin, at_ - begin)};
  }

  /// Members up to `close`, or up to the end of the text if that is '\0'.
  void readMembers(MapText& map, char close, int depth) {
    std::map<std::string, int> lines; // of the names so far; a search among the members would take hours of a long file
    for (skipSpace(); at_ < text_.size() && peek() != close; skipSpace()) {
      const int line = line_;
      std::string name = readName();
      if (const auto [before, isNew] = lines.try_emplace(name, line); !isNew) {
        throw InputError{fmt::format("{}: line {}: expected each name once, found {} again (first in line {})", file_,
                                     line, name, before->second)};
      }
      require('=', fmt::format("\"=\" behind {}", name));
      MapText value = readValue(depth);
      value.line = line;
      require(';', fmt::format("\";\" behind the value of {}", name));
      map.members.push_back({std::move(name), std::move(value)});
    }
  }

  void readElements(MapText& list, int depth) {
    for (skipSpace(); peek() != ']' && at_ < text_.size(); skipSpace()) {
      list.members.push_back({"", readValue(depth)});
      skipSpace();
      if (peek() == ',') {
        ++at_;
      } else if (peek() != ']') {
        refuse("\",\" or \"]\" behind an element");
      }
    }
  }

  MapText readValue(int depth) {
    skipSpace();
    MapText value;
    value.line = line_;
    if (peek() == '{' || peek() == '[') {
      if (depth >= deepest) {
        refuse("values that are nested less deeply");
      }
      const bool isMap = peek() == '{';
      ++at_;
      value.kind = isMap ? MapText::Kind::map : MapText::Kind::list;
      if (isMap) {
        readMembers(value, '}', depth + 1);
        require('}', fmt::format("\"}}\" to close the \"{{\" of line {}", value.line));
      } else {
        readElements(value, depth + 1);
        require(']', fmt::format("\"]\" to close the \"[\" of line {}", value.line));
      }
    } else {
      value.kind = MapText::Kind::literal;
      value.literal = readLiteral();
    }
    return value;
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0;
  int line_ = 1;
};

/// A number and the unit behind it; absent if the text does not begin with a finite number.
struct NumberWithUnit {
  double number = 0;
  std::string_view unit;
};

NumberWithUnit splitNumber(const MapText& value, const std::string& name, const std::string& file,
                           std::string_view expected) {
  NumberWithUnit split;
  const char* const end = value.literal.data() + value.literal.size();
  const auto [behind, error] = std::from_chars(value.literal.data(), end, split.number);
  if (value.kind != MapText::Kind::literal || error != std::errc{} || !std::isfinite(split.number)) {
    const std::string found = value.kind == MapText::Kind::literal ? "\"" + value.literal + "\""
                              : value.kind == MapText::Kind::map   ? "{...}"
                                                                   : "[...]";
    throw InputError{fmt::format("{}: line {}: {}: expected {}, found {}", file, value.line, name, expected, found)};
  }
  split.unit = {behind, static_cast<std::size_t>(end - behind)};
  return split;
}

} // namespace

const MapText* MapText::find(std::string_view name) const {
  const auto found =
      std::find_if(members.begin(), members.end(), [&](const auto& member) { return member.name == name; });
  return found == members.end() ? nullptr : &found->value;
}

MapText parseMapText(std::string_view text, const std::string& file) {
  return MapReader{text, file}.readAll();
}

double mapAngle(const MapText& value, const std::string& name, const std::string& file) {
  constexpr std::string_view expected = "an angle such as -1.5deg or 0.02rad";
  const NumberWithUnit split = splitNumber(value, name, file, expected);
  const bool isDegrees = split.unit == "deg";
  if (!isDegrees && split.unit != "rad" && !split.unit.empty()) {
    throw InputError{
        fmt::format("{}: line {}: {}: expected {}, found \"{}\"", file, value.line, name, expected, value.literal)};
  }
  return isDegrees ? radians(split.number) : split.number;
}

double mapNumber(const MapText& value, const std::string& name, const std::string& file) {
  const NumberWithUnit split = splitNumber(value, name, file, "a number");
  if (!split.unit.empty()) {
    throw InputError{fmt::format("{}: line {}: {}: expected a number without a unit, found \"{}\"", file, value.line,
                                 name, value.literal)};
  }
  return split.number;
}

} // namespace naocal

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// A value in B-Human's configuration text: `name = value;` with a value `{...}` of further entries, a list `[...]`, or
/// a literal such as `-1.5deg`. Comments are `// ...` and `/* ... */`. Source: the .cfg files of B-Human's and Nao
/// Devils' code releases.
struct MapText {
  enum class Kind { literal, map, list };

  Kind kind = Kind::map;
  int line = 1;
  std::string literal;
  struct Member;
  std::vector<Member> members; // of a map; of a list with empty names

  /// The value of a member, or null.
  const MapText* find(std::string_view name) const;
};

struct MapText::Member {
  std::string name;
  MapText value;
};

/// Reads such a text; `file` stands for it in messages. Throws InputError with line, expected and found.
MapText parseMapText(std::string_view text, const std::string& file);

/// The angle [rad] of a literal: degrees with the unit `deg`, radians with `rad` or without a unit. Throws InputError
/// with file, line, expected and found; `name` is the value's name there.
double mapAngle(const MapText& value, const std::string& name, const std::string& file);

/// The number of a literal without a unit; throws as above.
double mapNumber(const MapText& value, const std::string& name, const std::string& file);

} // namespace naocal

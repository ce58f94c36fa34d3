#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace naocal {

/// The value at a path such as `a.b[2].c`, and its top-level key. A key may hold dots itself ("network.basePort"): of
/// several readings the one with the longest existing key counts. value = nullptr: there is no such place.
struct JsonPathTarget {
  nlohmann::json* value = nullptr;
  std::string topLevelKey;
};
JsonPathTarget resolvePath(nlohmann::json& object, std::string_view path);

} // namespace naocal

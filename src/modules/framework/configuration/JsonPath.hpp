#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace naocal {

/// The value at a path such as `a.b[2].c`, and its top-level key. Keys may contain dots ("network.basePort"): the
/// longest existing key wins. value = nullptr if the path does not exist.
struct JsonPathTarget {
  nlohmann::json* value = nullptr;
  std::string topLevelKey;
};
JsonPathTarget resolvePath(nlohmann::json& object, std::string_view path);

} // namespace naocal

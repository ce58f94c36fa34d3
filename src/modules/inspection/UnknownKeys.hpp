#pragma once

#include "io/JsonReader.hpp"

#include <string>
#include <vector>

namespace naocal {

/// A key that a reader of the document did not ask for.
struct UnknownKey {
  std::string path; // of its object: "captures[3].joints"; empty: top level
  std::string key;
  std::string closest; // key that is meant, probably: asked for, missing there, and spelt alike; empty: none
};

/// Keys of the objects in `asked` that were not asked for, in the document's order. Objects below an unknown key are
/// passed over.
std::vector<UnknownKey> findUnknownKeys(const nlohmann::json& document, const AskedKeys& asked);

} // namespace naocal

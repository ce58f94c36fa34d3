#pragma once

#include "io/JsonReader.hpp"

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace naocal {

extern const std::string_view thisProgram; // with its version: "naocal 0.1.0"

/// `content` with the keys that begin every file: `format`, `version` and `writtenBy`, such as "naocal 0.1.0", for
/// people: readers ignore it, except to name it where they refuse a newer file.
nlohmann::json withFormat(std::string_view format, nlohmann::json content);
nlohmann::ordered_json withFormatInOrder(std::string_view format, const nlohmann::ordered_json& content,
                                         int version = 1);

/// Throws InputError unless the document's `version` is 1 to `newest`, the versions that its reader knows. A newer one
/// is refused with the program that wrote it and the advice to update this one.
void requireVersion(const JsonCursor& document, int newest = 1);

/// The same, and throws InputError unless its `format` is the given one.
void requireFormat(const JsonCursor& document, std::string_view format, int newest = 1);

} // namespace naocal

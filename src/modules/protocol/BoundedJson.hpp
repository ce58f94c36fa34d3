#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace naocal {

/// The document in a text, with comments where that is said. Throws nlohmann::json::exception; documents that are
/// nested so deeply that writing them could exhaust the stack are refused too.
nlohmann::json parseBoundedJson(std::string_view text, bool withComments = false);

/// What is wrong, without the library's marks: "parse error at line 1, column 7: ...".
std::string parseErrorReason(const std::exception& error);

/// A value on one line, keys sorted. Bytes that are not UTF-8 are replaced; numbers that JSON does not know become
/// null.
std::string jsonText(const nlohmann::json& value);

/// The same with a line break at its end, as HULKs' writer puts it.
std::string jsonLine(const nlohmann::json& value);

} // namespace naocal

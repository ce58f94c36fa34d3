#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace naocal {

/// Parses JSON, with comments if `withComments`. Throws nlohmann::json::exception for invalid text and for more than
/// 100 nesting levels, which could exhaust the stack.
nlohmann::json parseBoundedJson(std::string_view text, bool withComments = false);

/// An exception's message without the library's prefix: "parse error at line 1, column 7: ...".
std::string parseErrorReason(const std::exception& error);

/// A value on one line, keys sorted. Replaces invalid UTF-8; NaN and infinity become null.
std::string jsonText(const nlohmann::json& value);

/// `jsonText` with a newline, as HULKs' writer.
std::string jsonLine(const nlohmann::json& value);

} // namespace naocal

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tinyxml.h>
#include <vector>

namespace naocal {

/// Parses an XML text; `file` stands for it in messages. `kind` says what was expected, as "a URDF".
///
/// Throws InputError with file, line, column, expected and found: a zero byte, broken XML, and more than 100 elements
/// within each other, as TinyXML parses by recursion and more would exhaust the stack.
TiXmlDocument parseXml(const std::string& text, const std::string& file, const std::string& kind);

/// The numbers of a text, separated by white space; absent if a word is no finite number.
std::optional<std::vector<double>> parseXmlNumbers(std::string_view text);

} // namespace naocal

#pragma once

#include <string>
#include <string_view>

namespace naocal {

/// Refuses a URDF that a reader would misread or explain poorly, with file, place, expected and found: text that is no
/// XML, names that are not UTF-8, xacro, links and joints that form no tree, unknown joint types, numbers that are
/// none. Throws InputError. `name`: the file's, for error messages.
void checkUrdf(const std::string& text, const std::string& name);

/// Whether an attribute of a URDF's element holds numbers.
bool holdsNumbers(std::string_view element, std::string_view attribute);

} // namespace naocal

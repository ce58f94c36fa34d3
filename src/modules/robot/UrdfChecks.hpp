#pragma once

#include <string>

namespace naocal {

/// Refuses a URDF that a reader would misread or explain poorly, with file, place, expected and found: text that is no
/// XML, xacro, links and joints that form no tree, unknown joint types, numbers that are none. Throws InputError.
/// `name`: the file's, for error messages.
void checkUrdf(const std::string& text, const std::string& name);

} // namespace naocal

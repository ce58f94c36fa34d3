#pragma once

#include <string>

namespace naocal {

/// The content of a URDF as one text, equal for two documents that say the same: elements in their order with their
/// attributes and text. White space between them, comments, the order of attributes and the way a number is written
/// (0.10, 1e-1) do not count.
///
/// `text`: one that `checkUrdf` accepts.
std::string urdfContent(const std::string& text);

} // namespace naocal

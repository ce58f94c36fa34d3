#pragma once

#include <optional>
#include <string_view>

namespace naocal {

/// How many markers a predefined dictionary of OpenCV 4.6 has (their ids are 0 .. count-1); empty for unknown names.
/// Source: opencv2/aruco/dictionary.hpp, PREDEFINED_DICTIONARY_NAME.
std::optional<int> markerCount(std::string_view dictionary);

} // namespace naocal

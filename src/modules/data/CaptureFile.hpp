#pragma once

#include "data/SetReading.hpp"

#include <string_view>
#include <vector>

namespace naocal {

/// Reads an entry of `captures`, checked against the joints, cameras, boards, stances and instruments of its set.
Capture readCapture(const JsonCursor& place, SetReading& reading);

/// Formats a capture as an entry of `captures`. `isModel`: of a robot with a model's description; `read`: the entry it
/// was read from, or null.
nlohmann::ordered_json captureJson(const Capture& capture, bool isModel, const nlohmann::json& read);

} // namespace naocal

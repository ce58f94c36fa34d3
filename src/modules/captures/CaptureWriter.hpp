#pragma once

#include "captures/Capture.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// A capture as an entry of `captures`; `read` is the entry it came from, null when there was none.
nlohmann::ordered_json captureJson(const Capture& capture, const nlohmann::json& read);

} // namespace naocal

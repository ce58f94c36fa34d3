#pragma once

#include "captures/Capture.hpp"
#include "captures/JsonPlace.hpp"

namespace naocal {

/// An entry of `captures`, against the joints, cameras, boards and stances of its set.
Capture readCapture(const JsonPlace& place, const CaptureSet& set);

} // namespace naocal

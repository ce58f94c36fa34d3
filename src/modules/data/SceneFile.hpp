#pragma once

#include "data/SetReading.hpp"

namespace naocal {

/// Reads `cameras`, and the parts of a scene that only sets of version 2 have: `soles`, `gravity`, `encoderSteps` and
/// `slipSteps`.
void readCameras(const JsonCursor& place, SetReading& reading);
void readScene(const JsonCursor& top, SetReading& reading);

/// Reads an entry of `stances`. `isModel`: a robot that stands on its feet as the model's description says.
Stance readStance(const JsonCursor& place, bool isModel);

/// Their JSON. `read`: what they were read from, or null.
nlohmann::ordered_json camerasJson(const CaptureSet& set, const nlohmann::json& read);
nlohmann::ordered_json sceneJson(const CaptureSet& set, const nlohmann::json& read);
nlohmann::ordered_json stanceJson(const Stance& stance, bool isModel, const nlohmann::json& read);

} // namespace naocal

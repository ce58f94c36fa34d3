#pragma once

#include "estimation/Model.hpp"

#include <string>
#include <vector>

namespace naocal {

/// An unknown in words: "the left hip pitch" for jointOffset@LHipPitch.o, "the top camera's pitch" for
/// cameraRotation@top.ry, "board A's bow" for boardBow@A.h.
std::string describeUnknown(const Term& term, std::size_t unknown);
/// A term that can imitate a joint's offset, an unknown placement or a link geometry: "where tracker vicon stands".
std::string describeImitator(const Term& term);

/// "a", "a and b", "a, b and c".
std::string joinWords(const std::vector<std::string>& words);

} // namespace naocal

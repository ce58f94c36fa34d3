#pragma once

#include "robot/Robot.hpp"

#include <cstddef>
#include <vector>

namespace urdf {
class Link;
}

namespace naocal {

/// The collision shapes of a URDF's link as capsules: a sphere is one, a cylinder one that lacks its rims, a box as
/// many side by side as fit, of the radius of half its shortest edge. Meshes, and shapes without a positive size, have
/// none.
std::vector<Capsule> makeCapsules(const urdf::Link& drawn, std::size_t link);

} // namespace naocal

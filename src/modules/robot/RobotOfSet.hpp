#pragma once

#include "data/Capture.hpp"
#include "robot/Robot.hpp"

#include <filesystem>

namespace naocal {

/// The robot of a capture set: the description of its model, or its URDF with the set's cameras and soles.
///
/// Throws InputError for a description that cannot be read, and for links, joints and cameras of the set that it lacks.
Robot loadRobot(const CaptureSet& set, const std::filesystem::path& configuration = configurationDirectory());

} // namespace naocal

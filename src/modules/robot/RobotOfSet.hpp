#pragma once

#include "data/Capture.hpp"
#include "robot/Robot.hpp"

#include <filesystem>
#include <span>

namespace naocal {

/// The robot of a capture set: the description of its model, or its URDF with the set's cameras and soles.
///
/// Throws InputError for a description that cannot be read, and for links, joints and cameras of the set that it lacks.
Robot loadRobot(const CaptureSet& set, const std::filesystem::path& configuration = configurationDirectory());

/// The robot of sets that are used together, with the cameras and soles of all.
///
/// Throws InputError in these cases and for sets with other bases or URDFs that say something else. Other models are
/// `buildMeasurements`'.
Robot loadRobot(std::span<const CaptureSet> sets,
                const std::filesystem::path& configuration = configurationDirectory());

} // namespace naocal

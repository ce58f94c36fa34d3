#pragma once

#include "console/RobotCalibrationFile.hpp"

#include <filesystem>
#include <string>

namespace naocal {

/// Writes a result of a robot with a URDF into a folder: the URDF with corrected joint origins (`correctUrdf`) and
/// joint_offsets.yaml. Joints that are less than 50 % learned keep their origins. Prints what was corrected, and the
/// effects that a URDF has no place for. Throws RefusedCalibration for a result that should not be used, unless forced,
/// and InputError for one of a robot without a URDF, or whose captures are not found.
void exportUrdf(const std::string& resultFile, const PostureOptions& options, const std::filesystem::path& folder);

} // namespace naocal

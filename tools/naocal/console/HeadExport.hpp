#pragma once

#include "console/RobotCalibrationFile.hpp"
#include "dialects/heads/HeadDialect.hpp"

#include <string>

namespace naocal {

/// Writes the direction of a head's camera from a result (or a file of `naocal import`) into a file of another team's
/// robot, which must exist. What is less than 50 % learned keeps the file's values. `camera`: empty for the only one.
/// Prints what was written, what was not learned and what the file has no place for. Throws RefusedCalibration for a
/// result that should not be used, unless forced, and InputError for one that tells nothing of the direction, captures
/// that are not found, and as the dialect does.
void exportHead(const HeadDialect& dialect, const std::string& resultFile, const PostureOptions& options,
                const std::string& camera, const std::string& file);

/// Reads such a file as the calibration of the robot of a capture set; `unused` as of other dialects.
ParsedCalibration importHead(const HeadDialect& dialect, const std::string& file, const std::string& set,
                             const std::string& camera);

} // namespace naocal

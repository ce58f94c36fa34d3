#pragma once

#include "dialects/text/MapText.hpp"
#include "dialects/RobotCalibration.hpp"
#include "robot/Robot.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// The names that B-Human and its descendants share: joints as HULKs' with a small first letter, in the order of their
/// files; the camera above is `upper`.
std::vector<std::string_view> mapJoints();

/// Reads joint offsets, camera corrections and lenses from any of the .cfg files of this family: the names tell which
/// of them a file has. Conventions are the same in all of them (BHuman.hpp). Throws InputError with file, line,
/// expected and found.
ParsedCalibration parseMapCalibration(std::string_view text, const std::string& file);

/// Text of an entry per joint with offset and limits, indented by `indent`: limits of the drawing, and of a hand 0 to
/// `handMaximum`.
std::string jointsWithLimits(const RobotCalibration& calibration, const Robot& robot, std::string_view indent,
                             std::string_view handMaximum);

/// Text of three angles: "{x = 0.1deg; y = -2deg; z = 0deg;}".
std::string mapCorrection(const RobotCalibration& calibration, const std::string& camera);

/// An offset, or 0 where the calibration has none: "-2.27deg".
std::string mapOffset(const RobotCalibration& calibration, std::string_view joint);

/// Opening angles and optical centre of a camera's lens as text. Distortion has no place in these files.
struct MapLens {
  std::string width, height, centre; // "56.3deg", "43.7deg", "{x = 0.5; y = 0.5;}"
};
MapLens mapLens(const CameraIntrinsics& lens);

} // namespace naocal

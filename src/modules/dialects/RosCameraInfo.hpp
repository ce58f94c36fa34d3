#pragma once

#include "dialects/Dialect.hpp"
#include "dialects/text/YamlText.hpp"

namespace naocal {

/// ROS's camera_info files: top.yaml and bottom.yaml, one lens each, as camera_calibration writes them and
/// camera_calibration_parsers reads them. Model plumb_bob: k1, k2, p1, p2, k3 in OpenCV's order, pixels with (0, 0) in
/// the centre of the top left one, both as here. They have no place for joints, and none for mounts: in ROS these stand
/// in the robot's URDF. `camera_name`, or else the file's name, says which camera it is. Source:
/// sensor_msgs/CameraInfo; wiki of camera_calibration_parsers.
std::vector<DialectFile> writeRosCameraInfo(const RobotCalibration& calibration, const Robot& robot);
ParsedCalibration parseRosCameraInfo(const std::string& text, const std::string& file, const Robot& robot);

/// The lens of such a file.
CameraIntrinsics readRosLens(const YamlCursor& all);

} // namespace naocal

#pragma once

#include "dialects/Dialect.hpp"

namespace naocal {

/// HULKs' files of 2019, as naocal's own robot process has them: JointCalibrationProvider.json, degrees by joint, and
/// Projection.json, rotations in radians, focal length and principal point as shares of the picture. Only what the
/// calibration has is written: other keys keep what a more general layer says.
///
///   angle = measured - offset, sent = angle + offset
///   headFromCamera = nominal * Rx(x) Ry(y) Rz(z)      top_ext, bottom_ext; axes x forward, y left, z up
///
/// Source: code release 2019, SensorDataProvider.cpp, JointCommandSender.cpp, Projection.cpp.
std::vector<DialectFile> writeHulks(const RobotCalibration& calibration, const Robot& robot);
ParsedCalibration parseHulks(const std::string& text, const std::string& file, const Robot& robot);

} // namespace naocal

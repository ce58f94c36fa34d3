#pragma once

#include "dialects/Dialect.hpp"

namespace naocal {

/// B-Human's jointCalibration.cfg, cameraCalibration.cfg and cameraIntrinsics.cfg, degrees with the unit `deg`.
///
///   angle = measured - offset, sent = angle + offset                  the same sign as here
///   headFromCamera = T Ry(tilt + y) Rx(x) Rz(z)                       axes x forward, y left, z up
///   fx = width / (2 tan(openingAngleWidth / 2)), no distortion; the optical centre as a share of the picture
///
/// `writeBHuman`: the form since 2019, `offsets = {...}`. `writeOlderBHuman`: `joints = {...}` with offset and limits
/// of each joint. Both are read. Source: B-Human's code releases, Representations/Configuration/JointCalibration.h,
/// CameraCalibration.h and CameraIntrinsics.h, NaoProvider.cpp (signs), CameraMatrix.cpp (order of rotations). Which
/// year changed the names of the camera files is not known to the month.
std::vector<DialectFile> writeBHuman(const RobotCalibration& calibration, const Robot& robot);
std::vector<DialectFile> writeOlderBHuman(const RobotCalibration& calibration, const Robot& robot);
ParsedCalibration parseBHuman(const std::string& text, const std::string& file, const Robot& robot);

} // namespace naocal

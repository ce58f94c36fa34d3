#pragma once

#include "dialects/heads/HeadDialect.hpp"

namespace naocal {

/// Hamburg Bit-Bots: bitbots_extrinsic_calibration/config/ROBOT.yaml with `offset_x`, `offset_y`, `offset_z` [rad] of
/// the node /bitbots_extrinsic_camera_calibration, which publishes
///
///   uncalibratedFromOptical = Rz(offset_z) Ry(offset_y) Rx(offset_x)
///
/// of the optical frame (x right, y down, z forward) in the URDF's camera_optical_frame_left_uncalibrated (before 2026
/// camera_optical_frame_uncalibrated). The IMU's correction, of the node /bitbots_extrinsic_imu_calibration, stays:
/// what it means for the IMU's readings is not known here. Source: bit-bots/bitbots_main, bitbots_extrinsic_calibration
/// (main.rs, launch), glam's EulerRot::ZYX.
std::string writeBitBots(const std::string& text, const std::string& file, const Robot& robot, const HeadCamera& head);
HeadDirection parseBitBots(const std::string& text, const std::string& file, const Robot& robot,
                           const HeadCamera& head);

} // namespace naocal

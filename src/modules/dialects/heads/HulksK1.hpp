#pragma once

#include "dialects/heads/HeadDialect.hpp"

namespace naocal {

/// HULKs' Booster K1: camera_matrix_calculator.json5 with `camera_to_head_pitch` p [degrees], `correction_in_robot` r
/// and `correction_in_camera` c [rad], at its top or in `camera_matrix_parameters`:
///
///   opticalFromRobot = C(c) * Rx(-p) * opticalFromHead * (Rz(yaw) Ry(pitch))^T * C(r),   C(v) = Rz(v.z) Ry(v.y)
///   Rx(v.x)
///
/// optical axes x right, y down, z forward; opticalFromHead swaps axes alone. p stays; c turns the camera, r = (0, 0,
/// offset of the head's yaw). Source: HULKs/hulk, the node camera_matrix_calculator and nalgebra's from_euler_angles,
/// as of 2026.
std::string writeHulksK1(const std::string& text, const std::string& file, const Robot& robot, const HeadCamera& head);
HeadDirection parseHulksK1(const std::string& text, const std::string& file, const Robot& robot,
                           const HeadCamera& head);

} // namespace naocal

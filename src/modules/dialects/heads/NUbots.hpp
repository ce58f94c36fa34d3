#pragma once

#include "dialects/heads/HeadDialect.hpp"

namespace naocal {

/// NUbots: `roll_offset`, `pitch_offset`, `yaw_offset` as expressions ("1.5 * pi / 180"), of a NUgus at the top of
/// Cameras/Left.yaml or Right.yaml, of a K1 under `Hpc` in K1Sensors.yaml:
///
///   pitchFromCamera = Rx(yaw_offset) Rz(pitch_offset) Ry(roll_offset) * base
///
/// base: of a NUgus the URDF's left_camera (right_camera, where `is_left_camera` is false) in its link head; of a K1
/// Rz(yaw) Ry(pitch) Rx(roll) of `Hpc.rotation_rpy` [rad] in its Head_2. A K1Sensors.yaml without offsets has the
/// direction in `rotation_rpy` alone. Camera axes x forward, y left, z up. The offsets turn the camera's position about
/// the head's pitch joint, too. Source: NUbots/NUbots, NUbots/NUbots_K1: modules Camera, K1Sensors,
/// K1ExtrinsicsCalibration, utility/math/euler.hpp. Not written: `offset` of servos in HardwareIO.yaml, where one
/// number holds the drawing's zero and the correction.
std::string writeNUbots(const std::string& text, const std::string& file, const Robot& robot, const HeadCamera& head);
HeadDirection parseNUbots(const std::string& text, const std::string& file, const Robot& robot, const HeadCamera& head);

} // namespace naocal

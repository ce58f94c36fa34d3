#pragma once

#include "dialects/Dialect.hpp"

namespace naocal {

/// HULKs' parameter tree of 2024 (etc/parameters): body.ID.json with `joint_calibration_offsets` by limb, radians, and
/// head.ID.json with `camera_matrix_parameters.vision_top` and `vision_bottom`: `extrinsic_rotations` in degrees, focal
/// length and optical centre as shares of the picture.
///
///   angle = measured - offset, sent = angle + offset
///   opticalFromHead = Rz(z) Ry(y) Rx(x) * nominal     optical axes x right, y down, z forward
///
/// so that, to first order, x, y, z are our ry, rz and -rx. Not read: offsets in degrees (until May 2023,
/// `joint_calibration_offsets_deg`) and rotations in the older axes x forward (2021 to 2023), which have the same keys;
/// a file does not tell its year, so do not import rotations from files of those years. `calibration.correction_in_*`
/// of 2025 are no part of this. Source: HULKs/hulk, crates/control/src/camera_matrix_calculator.rs,
/// etc/parameters/default.json.
std::vector<DialectFile> writeHulksTree(const RobotCalibration& calibration, const Robot& robot);
ParsedCalibration parseHulksTree(const std::string& text, const std::string& file, const Robot& robot);

} // namespace naocal

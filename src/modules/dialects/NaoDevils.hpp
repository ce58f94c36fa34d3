#pragma once

#include "dialects/Dialect.hpp"

namespace naocal {

/// Nao Devils' jointCalibration.cfg: offset and limits per joint without a list around them; cameraCalibration.cfg and
/// cameraIntrinsics.cfg as B-Human's older form. Signs and rotations as B-Human's (BHuman.hpp), from which they come.
/// Limits are those of the drawing; of a hand 0 to 57.2958deg, as in their own file. Source: Nao Devils' code release,
/// Config/Robots/V5 and V6; no jointCalibration.cfg of a V6 is public.
std::vector<DialectFile> writeNaoDevils(const RobotCalibration& calibration, const Robot& robot);
ParsedCalibration parseNaoDevils(const std::string& text, const std::string& file, const Robot& robot);

} // namespace naocal

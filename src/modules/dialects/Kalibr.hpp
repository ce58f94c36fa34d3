#pragma once

#include "dialects/Dialect.hpp"
#include "dialects/text/YamlText.hpp"

namespace naocal {

/// kalibr's camchain.yaml: cam0 is the top camera, cam1 the bottom one, where both have a lens. Model pinhole with
/// intrinsics [fu, fv, pu, pv] and distortion radtan [k1, k2, p1, p2]; radtan has no k3, and a lens with one is
/// refused. T_cn_cnm1 of cam1 takes points of cam0's optical frame into cam1's (x right, y down, z forward, metres).
///
/// Only the cameras' placement relative to each other is in it, so that reading takes the top mount as drawn and gives
/// the bottom one the whole difference. Without T_cn_cnm1, no mounts. A camera is the one whose name is in its
/// rostopic, else by its number. Where kalibr has pixel (0, 0) is not documented; taken as OpenCV's. Source: kalibr's
/// wiki, yaml-formats.
std::vector<DialectFile> writeKalibr(const RobotCalibration& calibration, const Robot& robot);
ParsedCalibration parseKalibr(const std::string& text, const std::string& file, const Robot& robot);

/// The lens of one camera of such a file.
CameraIntrinsics readKalibrLens(const YamlCursor& at);

/// Reads [width, height], as kalibr and mrcal write a picture's size.
void readPictureSize(const YamlCursor& at, CameraIntrinsics& lens);

} // namespace naocal

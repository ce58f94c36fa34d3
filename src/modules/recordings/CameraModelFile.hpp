#pragma once

#include "data/Capture.hpp"

#include <filesystem>

namespace naocal {

/// Reads a camera's lens from a calibration file of OpenCV (FileStorage in YAML, JSON or XML), ROS (camera_info in
/// YAML), kalibr (camchain of one camera) or mrcal (.cameramodel: LENSMODEL_PINHOLE, LENSMODEL_OPENCV4, 5 and 8). All
/// have the centre of the top-left pixel at (0, 0).
///
/// Throws InputError with file, place, expected and found: other formats, other lens models by name, coefficients
/// beyond k1, k2, p1, p2, k3 that are not 0. Sources: OpenCV's, kalibr's and mrcal's documentation of these files.
CameraIntrinsics readCameraModel(const std::filesystem::path& file);

} // namespace naocal

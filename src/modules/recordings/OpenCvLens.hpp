#pragma once

#include "data/Capture.hpp"

#include <string>
#include <vector>

namespace naocal {

/// Whether a text was written by OpenCV's FileStorage.
bool isOpenCvStorage(const std::string& text);

/// The lens in a file of OpenCV's FileStorage (YAML, JSON or XML), as its calibration sample and most scripts write it:
/// camera_matrix, cameraMatrix, Camera_Matrix or K; distortion_coefficients, dist_coeffs, distCoeffs,
/// Distortion_Coefficients or D; image_width and image_height. `file` stands for it in messages.
///
/// OpenCV's own reader is not used: it ends the process for some broken files. Throws InputError with file, place,
/// expected and found. Source: OpenCV's documentation of FileStorage and of its camera calibration sample.
CameraIntrinsics readOpenCvLens(const std::string& text, const std::string& file);

/// Sets distortion by coefficients in OpenCV's order: k1, k2, p1, p2, k3, k4, .. Throws InputError for one beyond k3
/// that is not 0, as the lens model has none.
void setDistortion(const std::vector<double>& coefficients, const std::string& file, CameraIntrinsics& lens);

} // namespace naocal

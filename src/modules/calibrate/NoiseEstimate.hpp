#pragma once

#include "residuals/Residuals.hpp"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace naocal {

/// The pixel noise [px] that repeats show: how corners of one board move against each other between two pictures of one
/// pose, after the picture's rigid motion is taken out. No model of the robot enters. Absent without repeats.
std::optional<double> pixelNoiseFromRepeats(const Measurements& measurements,
                                            const std::vector<SightingResidual>& sightings);

/// The pixel noise [px] within single pictures: residuals after the picture's rigid motion is taken out. A lens or a
/// board that is not as believed counts as noise here. Absent where no picture shows enough corners (eight) of a board.
std::optional<double> pixelNoiseWithinPictures(const std::vector<SightingResidual>& sightings);

/// How sure the estimated levels of joint noise are: the covariance of (ln encoder^2, ln pose^2).
struct JointNoise {
  Noise noise;
  Eigen::Matrix2d logCovariance = Eigen::Matrix2d::Zero();
};

/// Encoder and pose noise that make the residuals most likely, restricted (REML) to what the unknowns leave over:
///   -2 l = sum_pose ln |Sigma_pose| + ln |H| + r^T Sigma^-1 (I - P) r
/// (Patterson and Thompson, Biometrika 58 (1971) 545). Pixel noise stays as given. The encoder's level stays too unless
/// poses were left and taken again, for only then do repeats show it, and never falls below the rounding of its steps.
JointNoise jointNoise(const Residuals::Linear& linear, const Eigen::VectorXd& unknowns, const Eigen::VectorXd& sigmas,
                      const Noise& start, bool encoderToo);

/// Gauss-Newton Hessian of all poses and the prior under a noise level: the inverse covariance of the unknowns.
Eigen::MatrixXd informationOf(const Residuals::Linear& linear, const Eigen::VectorXd& sigmas, const Noise& noise);

} // namespace naocal

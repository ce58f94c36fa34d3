#pragma once

#include "evaluation/thesis/SoleCamera.hpp"
#include "math/Sampling.hpp"

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

namespace naocal {

/// Facts of the program that made the thesis's tables 5.6 to 5.8 (tuxbotix/Project_Thesis_HULKs on GitHub, commit
/// 09ab20f and its data and logs).

/// A pattern of points on the floor around the support foot: columns along x, rows along y, spaced evenly; the point
/// (column, row) lies at (column - columns/2, row - rows/2) * spacing in the pattern's frame.
struct FloorPattern {
  int columns = 0, rows = 0;
  double spacing = 0;           // [m]
  double x = 0, y = 0, yaw = 0; // placement in the sole's frame [m, rad]

  /// Points in the pattern's frame [m].
  Eigen::Matrix2Xd points() const;
};

/// The floor grid of 40 x 40 points, 5 cm apart, around the support foot.
FloorPattern programGrid();

/// The board of 10 x 14 points, 5 cm apart. The program's feature files place four or eight of them on the floor; while
/// it looks for visible points it moves each one to the support foot, with yaw 0.
FloorPattern programBoard();

/// Joints between the cameras and the left sole, in the robot's order.
std::vector<std::string> programJoints();

/// The left foot's poses in the order in which the program uses them (its 2019-03-19_data2019_dbl_n_FilteredPoses): ten
/// poses, each with the angles of `names` [rad], head and left leg. Throws InputError for other joints.
std::vector<Eigen::VectorXd> programPoses(const std::vector<std::string>& names);

/// Joint offsets of an error set [rad], with the distribution of the first 5000 sets of its file, which is sorted by
/// head yaw: there -6.5 to -0.1 degrees, head pitch min(0, U/2), all others U, uniform within +-6.5 degrees. Its errors
/// are added to readings; ours are subtracted, and so have the opposite sign.
Eigen::VectorXd drawProgramOffsets(const std::vector<std::string>& names, RandomStream& chance);

/// The same of error set `number` of a seed.
Eigen::VectorXd drawProgramSet(const std::vector<std::string>& names, std::uint64_t seed, std::size_t number);

/// Random start of the program's solver as offsets [rad]: head pitch as in error sets, all others uniform within +-6.5
/// degrees.
Eigen::VectorXd drawProgramStart(const std::vector<std::string>& names, RandomStream& chance);

/// Whether the program uses a picture: the optical axis meets the floor at most 3 m from the sole, and the horizon lies
/// in the upper three quarters of the image.
bool passesHorizonTest(const SoleCamera<double>& camera, const SoleCamera<double>::Transform& cameraFromSole);

/// Distance from the sole up to which the program uses the floor [m].
inline constexpr double programReach = 3;

/// Angle noise between reading and true angle, 1 sigma [rad].
extern const double programAngleNoise;

/// Largest mean error of held-out poses: 2 % of the image's height of 480 pixels [px].
inline constexpr double programTestTolerance = 0.02 * 480;

/// Number of held-out poses.
inline constexpr std::size_t programTestPoses = 100;

} // namespace naocal

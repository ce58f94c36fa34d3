#pragma once

#include "data/Capture.hpp"
#include "robot/Kinematics.hpp"

#include <optional>
#include <random>

namespace naocal {

/// Distance between the soles when they stand side by side [m].
constexpr double footDistance = 0.1;

/// Sole that carries the robot (on both feet: the left one), and the other sole. Requires foot != none. Throws
/// InputError if the robot lacks the sole.
const Sole& supportSole(const Robot& robot, SupportFoot foot);
const Sole& otherSole(const Robot& robot, SupportFoot foot);

/// Required margins of a stable stance.
struct SupportMargin {
  double depth = 0;     // of the centre of mass inside the support polygon [m]
  double clearance = 0; // on one foot: of the other sole above the floor [m]
};

/// Required robustness of a stance against joint errors.
struct BalanceRequirement {
  double jointError = 0; // per motor, uniform in +- this [rad]
  int draws = 200;       // number of simulated robots
  double share = 0.99;   // required share of balanced robots
};

/// Whether the robot stands statically balanced: its centre of mass (the zero moment point of a still robot) projects
/// into the outline of the level support sole, and the other sole is entirely above the floor. On both feet: into the
/// convex hull of both soles, on the least-squares plane through their corners, since joint errors tilt the soles.
bool isBalanced(const Robot& robot, const LinkPoses& torsoFromLink, SupportFoot foot, const SupportMargin& least);

/// Share of robots with random joint errors that stay balanced with zero margin; 1 with zero draws. Stops early and
/// returns nothing once the share falls below `wanted.share`.
std::optional<double> balancedFraction(const Robot& robot, const ModelState& modelState, SupportFoot foot,
                                       const BalanceRequirement& wanted, std::mt19937_64& random);

} // namespace naocal

#pragma once

#include "data/Capture.hpp"
#include "robot/Kinematics.hpp"

#include <optional>
#include <random>

namespace naocal {

/// The distance of two soles that stand side by side [m].
constexpr double footDistance = 0.1;

/// The sole that carries a robot on one foot, and the one in the air; on both feet the left and the right one. Throws
/// InputError when the robot has none.
const Sole& supportSole(const Robot& robot, SupportFoot foot);
const Sole& otherSole(const Robot& robot, SupportFoot foot);

/// What it takes to stand.
struct SupportMargin {
  double depth = 0;     // of the centre of mass inside the outline of what carries the robot [m]
  double clearance = 0; // on one foot: of the other sole over the floor [m]
};

/// How much of it remains for a robot whose joints are not where they were sent.
struct BalanceRequirement {
  double jointError = 0; // per motor, uniform in +- this [rad]
  int draws = 200;       // robots with such errors
  double share = 0.99;   // of them that must stand
};

/// The robot stands still: its centre of mass is over the outline (a still robot's zero moment point) of the flat
/// support sole, and the whole other sole is above the floor. On both feet: over the hull of both soles, on the plane
/// nearest to their corners (least squares), to which legs with wrong joint zeros give way.
bool isBalanced(const Robot& robot, const LinkPoses& torsoFromLink, SupportFoot foot, const SupportMargin& least);

/// The share of robots drawn that stand by the least Footing there is; absent, as soon as that is decided, where it is
/// smaller than wanted. 1 where none are drawn.
std::optional<double> balancedFraction(const Robot& robot, const ModelState& belief, SupportFoot foot,
                                       const BalanceRequirement& wanted, std::mt19937_64& random);

} // namespace naocal

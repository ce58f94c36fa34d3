#pragma once

#include "captures/Capture.hpp"
#include "model/Kinematics.hpp"

#include <optional>
#include <random>

namespace naocal {

/// The sole that carries a robot on one foot, and the one in the air. Throws InputError when the robot has none.
const Sole& supportSole(const Robot& robot, SupportFoot foot);
const Sole& otherSole(const Robot& robot, SupportFoot foot);

/// What it takes to stand on one foot.
struct Footing {
  double depth = 0;     // of the centre of mass inside the support sole's outline [m]
  double clearance = 0; // of the other sole over the floor [m]
};

/// How much of it remains for a robot whose joints are not where they were sent.
struct Stability {
  double jointError = 0; // per motor, uniform in +- this [rad]
  int draws = 200;       // robots with such errors
  double share = 0.99;   // of them that must stand
};

/// The robot stands still on the flat `support` sole: its centre of mass is over the outline (a still robot's zero
/// moment point), and the whole other sole is above the floor.
bool stands(const Robot& robot, const Posture& torsoFromLink, const Sole& support, const Sole& other,
            const Footing& least);

/// The share of robots drawn that stand by the least Footing there is; absent, as soon as that is decided, where it is
/// smaller than wanted. 1 where none are drawn.
std::optional<double> shareStanding(const Robot& robot, const Belief& belief, const Sole& support, const Sole& other,
                                    const Stability& wanted, std::mt19937_64& random);

} // namespace naocal

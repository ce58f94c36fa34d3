#pragma once

#include "math/Sampling.hpp"
#include "poses/candidates/PlanningScene.hpp"
#include "robot/Balance.hpp"

#include <cstdint>

namespace naocal {

/// A sampling interval.
struct Interval {
  double lower, upper;
};

/// Number of samples that passed each test, in this order.
struct PassCounts {
  std::size_t generated = 0;
  std::size_t reachable = 0;     // within the legs' reach, joint limits and margin
  std::size_t collisionFree = 0; // no self-collision
  std::size_t stable = 0;        // balanced, and so are enough robots with joint errors
  std::size_t seeing = 0;        // sees a board, and is stable with its head turned there

  PassCounts& operator+=(const PassCounts& other);
};

/// On both feet: pose of the right sole in the frame of the left one, flat on the floor, and the centre of mass. By
/// default the feet do not move between poses.
struct DoubleSupportRanges {
  Interval forwards{0, 0}, sideways{footDistance, footDistance};     // [m]
  Interval yaw{0, 0};                                                // [rad]
  Interval centreForwards{-0.03, 0.03}, centreSideways{-0.04, 0.04}; // relative to the midpoint between the soles [m]
};

/// Sampling ranges and acceptance limits. The defaults suit an uncalibrated robot with offsets within 6.5 degrees: of
/// 200 000 samples 1518 are within reach and joint limits, 780 free of self-collision, 364 stable (with 99 of 100 such
/// robots), and 339 see one of four A2 boards around the robot.
struct PoseOptions {
  SupportFoot supportFoot = SupportFoot::left; // or right, or both
  std::size_t count = 24;
  std::uint64_t seed = 1;
  std::size_t choice = 10;           // candidates per pose; the most informative ones are selected
  std::size_t maxAttempts = 400'000; // number of samples
  SamplingMethod sampling = SamplingMethod::random;

  // Torso above the support sole. On both feet its yaw is solved for, since one motor turns both hips.
  Interval height{0.25, 0.33};                                       // [m]
  Interval roll{-0.3, 0.3}, pitch{-0.3, 0.6}, yaw{-0.6, 0.6};        // [rad]
  Interval centreForwards{-0.03, 0.03}, centreOutwards{-0.01, 0.01}; // centre of mass relative to the outline's centre
                                                                     // [m]
  // On one foot: other sole in the frame of the support sole.
  Interval otherForwards{-0.08, 0.08}, otherSideways{0.09, 0.16}, otherUp{0.03, 0.09}; // [m]
  Interval otherTilt{-0.2, 0.2};                                                       // roll and pitch [rad]

  DoubleSupportRanges beside;

  double limitMargin = radians(6.5);          // distance of legs and head from their limits [rad]
  SupportMargin footing{0.02, 0.02};          // of the drawn robot
  BalanceRequirement stability{radians(6.5)}; // of robots with unknown offsets
  double clearance = 0.005;                   // between parts that must not touch [m]
  VisibilityLimits sight;
};

} // namespace naocal

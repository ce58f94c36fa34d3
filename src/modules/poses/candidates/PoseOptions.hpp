#pragma once

#include "math/Sampling.hpp"
#include "poses/candidates/PlanningScene.hpp"
#include "robot/Balance.hpp"

#include <cstdint>

namespace naocal {

/// An interval to draw from.
struct Interval {
  double lower, upper;
};

/// How many attitudes passed each test, in this order.
struct PassCounts {
  std::size_t generated = 0;
  std::size_t reachable = 0;     // the legs reach, within their joints' limits and the margin
  std::size_t collisionFree = 0; // no part touches another
  std::size_t stable = 0;        // the robot stands, and so do enough others with joint errors
  std::size_t seeing = 0;        // it sees a board, still stable with its head turned there

  PassCounts& operator+=(const PassCounts& other);
};

/// On both feet: the right sole in the frame of the left one, flat on its floor, and the centre of mass. The feet do
/// not move from pose to pose; hence no ranges, unless they are wanted.
struct DoubleSupportRanges {
  Interval forwards{0, 0}, sideways{footDistance, footDistance};     // [m]
  Interval yaw{0, 0};                                                // [rad]
  Interval centreForwards{-0.03, 0.03}, centreSideways{-0.04, 0.04}; // from the middle between the soles [m]
};

/// What to draw and what to accept. Defaults are for a robot of which nothing is known but that its offsets lie within
/// 6.5 degrees: of 200 000 attitudes the legs reach 1518 clear of their limits, 780 touch nothing, 364 stand (of which
/// 99 of 100 such robots do), 339 see one of four A2 boards around the robot.
struct PoseOptions {
  SupportFoot supportFoot = SupportFoot::left; // or right, or both
  std::size_t count = 24;
  std::uint64_t seed = 1;
  std::size_t choice = 10;           // candidates per pose, of which the most informative ones are taken
  std::size_t maxAttempts = 400'000; // attitudes drawn, until it is given up
  SamplingMethod sampling = SamplingMethod::random;

  // The torso over the support sole. On both feet its yaw is what lets one motor turn both hips.
  Interval height{0.25, 0.33};                                       // [m]
  Interval roll{-0.3, 0.3}, pitch{-0.3, 0.6}, yaw{-0.6, 0.6};        // [rad]
  Interval centreForwards{-0.03, 0.03}, centreOutwards{-0.01, 0.01}; // centre of mass from the outline's middle [m]
  // On one foot: the other sole in the frame of the support sole.
  Interval otherForwards{-0.08, 0.08}, otherSideways{0.09, 0.16}, otherUp{0.03, 0.09}; // [m]
  Interval otherTilt{-0.2, 0.2};                                                       // roll and pitch [rad]

  DoubleSupportRanges beside;

  double limitMargin = radians(6.5);          // of legs and head from their limits [rad]
  SupportMargin footing{0.02, 0.02};          // of the drawn robot
  BalanceRequirement stability{radians(6.5)}; // of robots with unknown offsets
  double clearance = 0.005;                   // between parts that must not touch [m]
  VisibilityLimits sight;
};

} // namespace naocal

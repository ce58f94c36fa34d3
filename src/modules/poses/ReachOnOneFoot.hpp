#pragma once

#include "poses/OneFootWays.hpp"
#include "poses/PlannedInformation.hpp"

#include <map>

namespace naocal {

/// Whether poses on one foot can be reached from standing upright on it, each joint from the side that is wanted, as
/// robots reach them (OneFootWays). Of poses on both feet nothing is asked.
class ReachOnOneFoot {
public:
  /// `jointError`: as of Stability [rad].
  ReachOnOneFoot(const Robot& robot, double jointError) : robot_{robot}, jointError_{jointError} {}

  bool operator()(const ProposedPose& pose);

private:
  const Robot& robot_;
  double jointError_;
  std::map<SupportFoot, OneFootWays> ways_;
};

} // namespace naocal

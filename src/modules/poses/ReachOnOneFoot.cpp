#include "poses/ReachOnOneFoot.hpp"

namespace naocal {

bool ReachOnOneFoot::operator()(const ProposedPose& pose) {
  constexpr double aside = radians(1); // where an approach begins, as robots are configured
  const SupportFoot foot = pose.pose.supportFoot;
  if (foot != SupportFoot::left && foot != SupportFoot::right) {
    return true;
  }
  const auto ways = ways_.try_emplace(foot, robot_, foot, bentKnees(robot_), jointError_).first;
  std::mt19937_64 random{1};
  return ways->second.approach(pose.pose.angles, pose.approach, aside, random).has_value();
}

} // namespace naocal

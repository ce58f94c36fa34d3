#include "evidence/ScoreProblem.hpp"

#include <algorithm>

namespace naocal {

Eigen::Index ScoreProblem::ownOf(const PoseSystem& pose) const {
  return std::lower_bound(pose.unknowns.begin(), pose.unknowns.end(), static_cast<std::size_t>(own())) -
         pose.unknowns.begin();
}

std::vector<std::size_t> ScoreProblem::ownUnknownsOf(const PoseSystem& pose) const {
  return {pose.unknowns.begin(), pose.unknowns.begin() + ownOf(pose)};
}

} // namespace naocal

#include "evidence/ScoreProblem.hpp"

#include "evidence/GramSum.hpp"

#include <algorithm>
#include <utility>

namespace naocal {

ScoreProblem::ScoreProblem(const std::vector<PoseRows>& poses, const DriverColumns& map, Eigen::VectorXd unknowns,
                           Eigen::VectorXd sigmas, Eigen::Index candidates)
    : poses{&poses}, map{&map}, unknowns{std::move(unknowns)}, sigmas{std::move(sigmas)}, candidates{candidates} {
  GramSum sum{own() + candidates};
  for (const PoseRows& pose : poses) {
    sum.add(pose.unknowns, pose.byUnknowns);
  }
  gram = sum.taken();
}

Eigen::Index ScoreProblem::ownOf(const PosePart& pose) const {
  return std::lower_bound(pose.unknowns.begin(), pose.unknowns.end(), static_cast<std::size_t>(own())) -
         pose.unknowns.begin();
}

std::vector<std::size_t> ScoreProblem::ownUnknownsOf(const PosePart& pose) const {
  return {pose.unknowns.begin(), pose.unknowns.begin() + ownOf(pose)};
}

} // namespace naocal

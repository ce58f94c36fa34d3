#include "evidence/ScoreProblem.hpp"

#include "evidence/GramSum.hpp"
#include "math/Parallel.hpp"

#include <algorithm>
#include <utility>

namespace naocal {

ScoreProblem::ScoreProblem(const std::vector<PoseRows>& poses, const DriverColumns& map, Eigen::VectorXd unknowns,
                           Eigen::VectorXd sigmas, Eigen::Index candidates)
    : poses{&poses}, map{&map}, unknowns{std::move(unknowns)}, sigmas{std::move(sigmas)}, candidates{candidates} {
  const Eigen::Index columns = own() + candidates;
  gram = Eigen::MatrixXd::Zero(columns, columns);
  for (GramSum& part : gatheredInParts(
           poses.size(), [&] { return GramSum{columns}; },
           [&](std::size_t pose, GramSum&sum) { sum.add(poses[pose].unknowns, poses[pose].byUnknowns); })) {
    gram += part.taken();
  }
}

Eigen::Index ScoreProblem::ownOf(const PosePart& pose) const {
  return std::lower_bound(pose.unknowns.begin(), pose.unknowns.end(), static_cast<std::size_t>(own())) -
         pose.unknowns.begin();
}

std::vector<std::size_t> ScoreProblem::ownUnknownsOf(const PosePart& pose) const {
  return {pose.unknowns.begin(), pose.unknowns.begin() + ownOf(pose)};
}

} // namespace naocal

#include "poses/CriteriaComparison.hpp"

#include <algorithm>
#include <cmath>

namespace naocal {

namespace {

double largest(const std::map<std::string, double>& sigmas) {
  double result = 0;
  for (const auto& [joint, sigma] : sigmas) {
    result = std::max(result, sigma);
  }
  return result;
}

double rootMeanSquare(const std::map<std::string, double>& sigmas) {
  double sum = 0;
  for (const auto& [joint, sigma] : sigmas) {
    sum += sigma * sigma;
  }
  return std::sqrt(sum / static_cast<double>(sigmas.size()));
}

} // namespace

std::vector<CriterionResult> compareCriteria(const Robot& robot, const std::vector<Board>& boards,
                                             const std::map<std::string, CameraIntrinsics>& cameras,
                                             const PlanOptions& options, const std::vector<SievedPose>& candidates) {
  std::vector<CriterionResult> result;
  for (std::size_t criterion = 0; criterion < static_cast<std::size_t>(Criterion::time); ++criterion) {
    if (static_cast<Criterion>(criterion) == Criterion::discriminate && options.effects.empty()) {
      continue;
    }
    PlanOptions own = options;
    own.wornRobots = 0;
    own.criterion = static_cast<Criterion>(criterion);
    const PlanScore score{robot, boards, cameras, own};
    for (const std::size_t count : {3, 5, 8}) {
      const std::vector<SievedPose> poses = score.best(candidates, count);
      const std::map<std::string, double> unknown = score.sigmas(poses, false);
      result.push_back({own.criterion, poses.size(), largest(unknown), rootMeanSquare(unknown),
                        largest(score.sigmas(poses, true)), score.interaction(poses), score.misfit(poses)});
    }
  }
  return result;
}

} // namespace naocal

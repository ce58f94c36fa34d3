#include "math/SubsetSelection.hpp"

#include "math/Parallel.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace naocal {

namespace {

/// The candidate not yet chosen with the lowest objective together with `rest`; the first one if none is finite.
std::size_t findBestBeside(const Eigen::MatrixXd& rest, const Objective& judge,
                           const std::vector<Eigen::MatrixXd>& candidates, const std::vector<std::size_t>& chosen) {
  std::vector<double> values(candidates.size());
  parallelFor(candidates.size(), [&](std::size_t i) { values[i] = judge(rest + candidates[i]); });
  for (const std::size_t taken : chosen) {
    values[taken] = std::numeric_limits<double>::infinity();
  }
  return static_cast<std::size_t>(std::min_element(values.begin(), values.end()) - values.begin());
}

} // namespace

std::vector<std::size_t> selectGreedily(const Objective& judge, Eigen::MatrixXd known,
                                        const std::vector<Eigen::MatrixXd>& candidates, std::size_t count) {
  std::vector<std::size_t> chosen;
  while (chosen.size() < std::min(count, candidates.size())) {
    chosen.push_back(findBestBeside(known, judge, candidates, chosen));
    known += candidates[chosen.back()];
  }
  return chosen;
}

void improveByExchange(const Objective& judge, const Eigen::MatrixXd& known,
                       const std::vector<Eigen::MatrixXd>& candidates, std::vector<std::size_t>& chosen) {
  Eigen::MatrixXd sum = known;
  for (const std::size_t index : chosen) {
    sum += candidates[index];
  }
  double value = judge(sum);
  for (bool better = chosen.size() < candidates.size(); better;) {
    better = false;
    for (std::size_t& each : chosen) {
      const Eigen::MatrixXd rest = sum - candidates[each];
      const std::size_t other = findBestBeside(rest, judge, candidates, chosen);
      if (const double there = judge(rest + candidates[other]); there < value - 1e-9 * std::abs(value)) {
        each = other;
        sum = rest + candidates[other];
        value = there;
        better = true;
      }
    }
  }
}

std::vector<std::size_t> selectDOptimal(const Eigen::MatrixXd& prior, const std::vector<Eigen::MatrixXd>& candidates,
                                        std::size_t count) {
  const auto volume = [](const Eigen::MatrixXd& information) {
    return -Eigen::LLT<Eigen::MatrixXd>{information}.matrixLLT().diagonal().array().log().sum();
  };
  return selectGreedily(volume, prior, candidates, count);
}

} // namespace naocal

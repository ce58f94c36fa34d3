#include "poses/PoseSelection.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>

namespace naocal {

std::vector<std::size_t> mostInformative(const Eigen::MatrixXd& prior, const std::vector<Eigen::MatrixXd>& candidates,
                                         std::size_t count) {
  const auto logDeterminant = [](const Eigen::MatrixXd& information) {
    return Eigen::LLT<Eigen::MatrixXd>{information}.matrixLLT().diagonal().array().log().sum();
  };
  Eigen::MatrixXd known = prior;
  std::vector<bool> picked(candidates.size(), false);
  std::vector<std::size_t> order;
  while (order.size() < std::min(count, candidates.size())) {
    double best = -std::numeric_limits<double>::infinity();
    std::size_t next = 0;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (const double value = picked[i] ? best : logDeterminant(known + candidates[i]); value > best) {
        best = value;
        next = i;
      }
    }
    known += candidates[next];
    picked[next] = true;
    order.push_back(next);
  }
  return order;
}

} // namespace naocal

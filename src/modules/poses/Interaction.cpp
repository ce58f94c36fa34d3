#include "poses/Interaction.hpp"

#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cmath>

namespace naocal {

namespace {

template <typename PairValue> Eigen::ArrayXd perPair(Eigen::Index joints, const PairValue& value) {
  Eigen::ArrayXd result(joints * (joints - 1) / 2);
  for (Eigen::Index b = 0, pair = 0; b < joints; ++b) {
    for (Eigen::Index a = 0; a < b; ++a, ++pair) {
      result[pair] = value(a, b);
    }
  }
  return result;
}

} // namespace

Eigen::ArrayXd jointInteraction(const Eigen::MatrixXd& observation) {
  return perPair(observation.cols(), [&](Eigen::Index a, Eigen::Index b) {
    const double norms = observation.col(a).norm() * observation.col(b).norm();
    return norms > 0 ? std::min(1.0, std::abs(observation.col(a).dot(observation.col(b))) / norms) : 1.0;
  });
}

InteractionJudge::InteractionJudge(const Eigen::VectorXd& jointWeights)
    : weights_{perPair(jointWeights.size(),
                       [&](Eigen::Index a, Eigen::Index b) { return jointWeights[a] * jointWeights[b]; })} {
  weights_ /= weights_.sum();
}

Interaction InteractionJudge::operator()(const Eigen::ArrayXd& product) const {
  constexpr double toldApart = 0.01;
  return {(weights_ * product).sum(), static_cast<std::size_t>((product > toldApart).count())};
}

std::vector<std::size_t> InteractionJudge::chain(const std::vector<Eigen::ArrayXd>& poses, std::size_t count) const {
  std::vector<std::size_t> chosen;
  Eigen::ArrayXd product = Eigen::ArrayXd::Ones(weights_.size());
  double cost = 1;
  while (chosen.size() < count) {
    std::size_t best = poses.size();
    double least = cost;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const double with = (*this)(product * poses[i]).cost;
      if (with < least && std::find(chosen.begin(), chosen.end(), i) == chosen.end()) {
        best = i;
        least = with;
      }
    }
    if (best == poses.size()) {
      break;
    }
    chosen.push_back(best);
    product *= poses[best];
    cost = least;
  }
  return chosen;
}

} // namespace naocal

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace naocal {

/// How alike small turns of joints look to a sensor in one pose, per pair of joints (joint-joint interaction, thesis
/// 4.4): |cos| of their columns of the observation, in the order (0, 1), (0, 2), (1, 2), (0, 3), ... A joint that the
/// sensor does not see move looks like every other one: 1.
///
/// `observation`: n numbers of any sensor by m joints.
Eigen::ArrayXd jointInteraction(const Eigen::MatrixXd& observation);

/// What a set of poses leaves alike.
struct Interaction {
  double cost = 1;       // mean over pairs of joints, weighted
  std::size_t count = 0; // pairs that are not told apart: above 0.01
};

/// Judges pose-pose interaction (thesis 4.5): the product, pair by pair, of the poses' joint-joint interactions.
class InteractionJudge {
public:
  /// `jointWeights`: how much each joint matters; a pair's weight is the product of its joints'.
  explicit InteractionJudge(const Eigen::VectorXd& jointWeights);

  Interaction operator()(const Eigen::ArrayXd& product) const;

  /// The thesis's chain: the pose of the least cost, then always the one with which the product's cost falls most, as
  /// long as it falls, up to `count`. Indices.
  std::vector<std::size_t> chain(const std::vector<Eigen::ArrayXd>& poses, std::size_t count) const;

private:
  Eigen::ArrayXd weights_; // per pair, together 1
};

} // namespace naocal

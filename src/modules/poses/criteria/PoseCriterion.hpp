#pragma once

#include "poses/candidates/PlanningScene.hpp"

#include <Eigen/Core>
#include <array>
#include <string_view>
#include <vector>

namespace naocal {

/// Objective of pose selection; C is the covariance of the targets: joint offsets, and what else is asked for.
enum class Criterion {
  determinant, // D: the volume, log det C
  trace,       // A: the mean variance
  eigenvalue,  // E: the worst direction's variance
  worst,       // worst joint's variance (smooth maximum), with cameras and boards unknown and, weighted 3.4-fold, known
  interaction, // thesis: joints that look alike to the cameras (poses/criteria/ThesisCriterion.hpp)
  discriminate, // confusion of two effects (poses/criteria/EffectPairCriterion.hpp)
  time          // time to play poses that reach a required sigma
};
constexpr std::array<std::string_view, 7> criterionNames{"D", "A", "E", "worst", "thesis", "discriminate", "time"};
constexpr std::string_view toString(Criterion criterion) {
  return criterionNames[static_cast<std::size_t>(criterion)];
}

/// Evaluates information about a problem's unknowns by some of them, the targets, marginalising others. A planned NAO's
/// are the offsets of its joints, with cameras and boards marginalised.
class PoseCriterion {
public:
  /// `prior`: information about all unknowns before any pose. Those that are neither `others` nor `targets` are known.
  PoseCriterion(Eigen::MatrixXd prior, std::vector<Eigen::Index> others, const std::vector<Eigen::Index>& targets,
                Criterion criterion);

  /// For a scene's unknowns (PlanningScene::information). `joints`: those that move the images. `known`: camera mounts
  /// and board placements are known.
  PoseCriterion(const Robot& robot, const PlanningScene& scene, const std::vector<std::size_t>& joints,
                Criterion criterion, bool known = false);

  /// The relevant block: other unknowns first, then the targets.
  Eigen::MatrixXd relevantInformation(const Eigen::MatrixXd& information) const;
  Eigen::MatrixXd prior() const { return relevantInformation(prior_); }

  /// Covariance of the targets for a sum of blocks.
  Eigen::MatrixXd covariance(const Eigen::MatrixXd& sum) const;
  /// Objective to minimise, for a sum of blocks (`interaction`, `discriminate`, `time`: as `worst`).
  double operator()(const Eigen::MatrixXd& information) const;

  /// The same unknowns with another criterion.
  PoseCriterion withCriterion(Criterion criterion) const {
    PoseCriterion result = *this;
    result.criterion_ = criterion;
    return result;
  }

private:
  Eigen::MatrixXd prior_;
  std::vector<Eigen::Index> order_; // others, then targets
  Eigen::Index targets_;
  Criterion criterion_;
};

/// Selects `count` (at most all) candidates, given by their information blocks, in addition to `known`: greedily by
/// each of D, A, E and worst, each improved by exchange; returns the indices of the best result.
std::vector<std::size_t> selectPoses(const PoseCriterion& judge, const Eigen::MatrixXd& known,
                                     const std::vector<Eigen::MatrixXd>& candidates, std::size_t count);

} // namespace naocal

#pragma once

#include "poses/candidates/PlanningScene.hpp"

#include <Eigen/Core>
#include <array>
#include <string_view>
#include <vector>

namespace naocal {

/// What a set of poses should make small, of the joint offsets' covariance C or else.
enum class Criterion {
  determinant,  // D: the volume, log det C
  trace,        // A: the mean variance
  eigenvalue,   // E: the worst direction's variance
  worst,        // the worst joint's variance (smoothly: a norm), be cameras and boards unknown or, 3.4 times, known
  interaction,  // the thesis's: what looks alike to the cameras (poses/Interaction.hpp)
  discriminate, // what leaves open which of two effects is there (poses/EffectPairCriterion.hpp)
  time          // the seconds that it takes to play poses which reach a sigma that is asked for
};
constexpr std::array<std::string_view, 7> criterionNames{"D", "A", "E", "worst", "thesis", "discriminate", "time"};
constexpr std::string_view toString(Criterion criterion) {
  return criterionNames[static_cast<std::size_t>(criterion)];
}

/// Judges information about a scene's unknowns (Scene::information) by the offsets of some joints; cameras and boards
/// are unknown along with them.
class PoseCriterion {
public:
  /// `joints`: of the robot's, those whose pictures depend on them. `known`: where cameras and boards are is known.
  PoseCriterion(const Robot& robot, const PlanningScene& scene, std::vector<std::size_t> joints, Criterion criterion,
                bool known = false);

  /// The part that matters: what is unknown beside the offsets, then these.
  Eigen::MatrixXd relevantInformation(const Eigen::MatrixXd& information) const;
  Eigen::MatrixXd prior() const { return relevantInformation(prior_); }

  /// Of the offsets, by a sum of parts [rad^2].
  Eigen::MatrixXd covariance(const Eigen::MatrixXd& sum) const;
  /// The value to make small, by a sum of parts (`interaction`, `discriminate`, `time`: as `worst`).
  double operator()(const Eigen::MatrixXd& information) const;

  const std::vector<std::size_t>& joints() const { return joints_; }

  /// The same unknowns judged otherwise.
  PoseCriterion withCriterion(Criterion criterion) const {
    PoseCriterion result = *this;
    result.criterion_ = criterion;
    return result;
  }

private:
  Eigen::MatrixXd prior_;
  std::vector<std::size_t> joints_;
  std::vector<Eigen::Index> order_;
  Criterion criterion_;
};

/// Picks `count` (at most all) of the candidates, given by their parts, beside what is `known`: greedily by each
/// criterion in turn, then by exchange; the best of these. Indices.
std::vector<std::size_t> selectPoses(const PoseCriterion& judge, const Eigen::MatrixXd& known,
                                     const std::vector<Eigen::MatrixXd>& candidates, std::size_t count);

} // namespace naocal

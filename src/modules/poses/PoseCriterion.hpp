#pragma once

#include "poses/Scene.hpp"

#include <Eigen/Core>
#include <string_view>
#include <vector>

namespace naocal {

/// What a set of poses should make small, of the joint offsets' covariance C.
enum class Criterion {
  determinant, // D: the volume, log det C
  trace,       // A: the mean variance
  eigenvalue,  // E: the worst direction's variance
  worst        // the worst joint's variance
};
constexpr std::string_view name(Criterion criterion) {
  constexpr std::string_view all[]{"D", "A", "E", "worst"};
  return all[static_cast<int>(criterion)];
}

/// Judges information about a scene's unknowns (Scene::information) by the offsets of some joints; cameras and boards
/// are unknown along with them.
class PoseJudge {
public:
  /// `joints`: of the robot's, those whose pictures depend on them. `known`: where cameras and boards are is known.
  PoseJudge(const Robot& robot, const Scene& scene, std::vector<std::size_t> joints, Criterion criterion,
            bool known = false);

  /// The part that matters: what is unknown beside the offsets, then these.
  Eigen::MatrixXd part(const Eigen::MatrixXd& information) const;
  Eigen::MatrixXd prior() const { return part(prior_); }

  /// Of the offsets, by a sum of parts [rad^2].
  Eigen::MatrixXd covariance(const Eigen::MatrixXd& sum) const;
  /// The value to make small, by a sum of parts.
  double operator()(const Eigen::MatrixXd& sum) const;

  const std::vector<std::size_t>& joints() const { return joints_; }

private:
  Eigen::MatrixXd prior_;
  std::vector<std::size_t> joints_;
  std::vector<Eigen::Index> order_;
  Criterion criterion_;
};

/// Picks `count` (at most all) of the candidates, given by their parts: greedily, then exchanging one for another as
/// long as that helps (Fedorov). Those `kept` stay picked, in front. Indices.
std::vector<std::size_t> selected(const PoseJudge& judge, const std::vector<Eigen::MatrixXd>& candidates,
                                  std::size_t count, const std::vector<std::size_t>& kept = {});

} // namespace naocal

#pragma once

#include "estimation/Marginalization.hpp"
#include "estimation/Model.hpp"
#include "estimation/PictureResiduals.hpp"
#include "measurements/Measurements.hpp"
#include "measurements/Noise.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <optional>
#include <vector>

namespace naocal {

/// The whitened least-squares problem of a model and its measurements: residuals, derivatives and cost. A problem for
/// `levenbergMarquardt`. Keeps references to measurements and model.
class Residuals {
public:
  Residuals(const Measurements& measurements, const Model& model, const Noise& noise, const Loss& loss = {});

  /// The unknowns, and each pose's deflections in units of their standard deviations.
  struct State {
    Eigen::VectorXd unknowns;
    std::vector<Eigen::VectorXd> deflections;
  };
  /// Cost (chi2 / 2, with priors and loss), its gradient and Gauss-Newton Hessian, deflections marginalised.
  struct Linear {
    double cost = 0;
    Eigen::VectorXd gradient;
    Eigen::MatrixXd hessian;
    std::vector<PoseSystem> poses;
    std::vector<MarginalSystem> eliminated;
  };

  /// State with zero deflections.
  State startState(const Eigen::VectorXd& unknowns) const;
  /// Absent if the state is infeasible (a corner without projection). Poses run in parallel and are summed in order.
  std::optional<Linear> linearize(const State& state) const;
  /// As above, with deflections optimised at the state's unknowns (variable projection: Golub and Pereyra, Inverse
  /// Problems 19 (2003) R1), so that the cost depends on the unknowns alone: where corners lose weight, the gradient
  /// with respect to the unknowns ignores what deflections would still gain. False if the state is infeasible. `result`
  /// must be empty or filled by an earlier call; its memory is reused.
  bool linearize(State& state, Linear& result) const;
  /// The same as rows, for models with many unknowns. Absent if the state is infeasible.
  std::optional<std::vector<PoseRows>> rows(const State& state) const;
  /// State after a step of the unknowns, with deflections at their minimum according to `linear`.
  State applyStep(const State& state, const Linear& linear, const Eigen::VectorXd& step) const;
  const Eigen::VectorXd& scales() const { return sigmas_; }

  /// Measured and predicted corners per observation at a state.
  std::vector<BoardResidual> boardResiduals(const State& state) const;
  /// Witnesses at a state.
  std::vector<WitnessResidual> witnessResiduals(const State& state) const;
  /// Motion sums of the same observations, in pose order. Absent if the state is infeasible.
  std::optional<std::vector<BoardMotionSums>> boardMotions(const State& state) const;

  /// Selects the free unknowns; others stay fixed. All are free by default.
  void setFree(const std::vector<bool>& free) { free_ = free; }

  const Measurements& measurements() const { return measurements_; }
  const Model& model() const { return model_; }
  const Noise& noise() const { return noise_; }

private:
  bool linearizeAt(std::size_t pose, const State& state, const Eigen::VectorXd& inSigmas, PoseSystem& system,
                   MarginalSystem& part) const;
  void settleDeflections(std::size_t pose, State& state, PoseSystem& system, MarginalSystem& part) const;
  template <class AtPose> bool linearisePoses(Linear& result, const AtPose& atPose) const;
  void sumPoses(const State& state, Linear& result) const;
  bool addPose(std::size_t pose, const State& state, const Eigen::VectorXd& deflections, PictureWorkspace& work,
               PosePart& part) const;
  template <class Visit> bool visitPictures(const State& state, const Visit& visit) const;
  PosePart listColumns(const PoseGroup& pose);

  const Measurements& measurements_;
  const Model& model_;
  Noise noise_;
  PictureResiduals pictures_;
  Eigen::VectorXd sigmas_;
  std::vector<bool> free_;
  std::vector<PreparedImage> prepared_; // per picture
  std::vector<PosePart> columns_;       // structure per pose, without sums
  std::vector<JointErrorRoot> roots_;   // per pose
};

/// Distances of corners from their predictions: rms = sqrt(mean(du^2 + dv^2)).
struct ResidualSummary {
  double rmsPx = 0, medianPx = 0; // [px]; 0 without corners, not finite where one is behind the camera
  std::size_t corners = 0;
};
/// Summary of these distances [px].
ResidualSummary summarizeDistances(std::vector<double> distances);

/// Distance of every corner [px].
std::vector<double> collectDistances(const std::vector<BoardResidual>& residuals);

} // namespace naocal

#pragma once

#include "estimation/Marginalization.hpp"
#include "estimation/Model.hpp"
#include "estimation/NormalEquations.hpp"
#include "measurements/Measurements.hpp"
#include "measurements/Noise.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <optional>
#include <vector>

namespace naocal {

/// Residuals of one observation's corners, with their weights.
struct BoardResidual {
  std::size_t picture = 0, observation = 0;
  Eigen::Matrix2Xd predicted; // [px]
  Eigen::Matrix2Xd residual;  // measured - predicted [px]: minus the r of all formulas
  Eigen::VectorXd weight;     // loss weight, 0..1
  Eigen::MatrixXd motionRows; // derivative of `predicted` with respect to (omega, v) of the board in the optical frame;
                              // rows u0, v0, ..., 6 columns
};

/// Residuals of one witness.
struct WitnessResidual {
  std::size_t picture = 0, witness = 0;
  Eigen::VectorXd residual; // predicted - measured [m] or [rad], as its parts say
  double weight = 1;        // least loss weight of its parts, 0..1
};

/// Normal equations of a single observation for a rigid motion of its board in the optical frame (omega, v), with cross
/// terms to the unknowns and deflections of its pose. L: `motionRows`, W: the corners' weights; before any noise level
/// is applied.
struct BoardMotionSums {
  std::size_t picture = 0, observation = 0, pose = 0;
  Eigen::Matrix<double, 6, 6> gram;               // L^T W L   [px^2 / (rad or m)^2]
  Eigen::Matrix<double, 6, 1> gradient;           // L^T W r, r = predicted - measured
  Eigen::Matrix<double, 6, Eigen::Dynamic> cross; // L^T W [J_x J_t]: the pose's unknowns, then its deflections
};

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
  struct Workspace;
  bool linearizeAt(std::size_t pose, const State& state, const Eigen::VectorXd& inSigmas, PoseSystem& system,
                   MarginalSystem& part) const;
  void settleDeflections(std::size_t pose, State& state, PoseSystem& system, MarginalSystem& part) const;
  template <class AtPose> bool linearisePoses(Linear& result, const AtPose& atPose) const;
  void sumPoses(const State& state, Linear& result) const;
  bool addPose(std::size_t pose, const State& state, const Eigen::VectorXd& deflections, Workspace& work,
               PosePart& part) const;
  template <class Visit> bool visitPictures(const State& state, const Visit& visit) const;
  PosePart listColumns(const PoseGroup& pose);
  void predictImageState(const ImageObservation& picture, const PreparedImage& prepared,
                         const Eigen::VectorXd& unknowns, const Eigen::VectorXd& deflections, Workspace& work) const;
  bool addPicture(const ImageObservation& picture, const PreparedImage& prepared, Workspace& work,
                  PosePart& part) const;
  void addFloorContact(const ObservationChain& sole, const PreparedImage::Group& group, Workspace& work,
                       PosePart& part) const;
  void addWitness(const WitnessObservation& observation, const PreparedImage::Group& group, Workspace& work,
                  PosePart& part) const;
  Loss::Value lossOf(const WitnessObservation& observation, const Eigen::Ref<const Eigen::VectorXd>& residual,
                     const Witness::Part& part) const;
  WitnessRows compareWitness(const WitnessObservation& observation, const Workspace& work,
                             std::optional<CameraFrames>& frames) const;
  bool addCorners(const BoardObservation& observation, const std::vector<std::size_t>& extras, CameraFrames& attitude,
                  Workspace& work) const;
  void addImuReading(const ImageObservation& picture, const PreparedImage& prepared, Workspace& work,
                     PosePart& part) const;
  bool addGroup(const ImageObservation& picture, const PreparedImage::Group& group, Workspace& work,
                PosePart& part) const;
  BoardResidual boardResidual(std::size_t picture, std::size_t index, Workspace& work) const;
  bool addMotion(const BoardObservation& observation, const PreparedImage::Group& group, Workspace& work,
                 BoardMotionSums& motion) const;

  const Measurements& measurements_;
  const Model& model_;
  Noise noise_;
  Loss loss_;
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

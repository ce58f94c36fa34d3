#pragma once

#include "estimation/Marginalization.hpp"
#include "estimation/Model.hpp"
#include "estimation/PictureWorkspace.hpp"
#include "measurements/Noise.hpp"

#include <Eigen/Core>
#include <optional>

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

/// Residuals and derivatives of all that one picture holds: corners of boards, contact of further soles with the floor,
/// the IMU's tilt, and witnesses. `predictState` comes first; all else is at the workspace's state. Keeps references to
/// measurements and model.
class PictureResiduals {
public:
  PictureResiduals(const Measurements& measurements, const Model& model, const Noise& noise, const Loss& loss);

  /// Predicts the state at the picture's instant, evaluates its slopes, and places the links.
  void predictState(const ImageObservation& picture, const PreparedImage& prepared, const Eigen::VectorXd& unknowns,
                    const Eigen::VectorXd& deflections, PictureWorkspace& work) const;
  /// Adds the sums over a picture to those of its pose. False if a corner has no projection.
  bool add(const ImageObservation& picture, const PreparedImage& prepared, PictureWorkspace& work,
           PosePart& part) const;

  /// Residuals of one board in one picture; not finite if a corner has no projection.
  BoardResidual boardResidual(std::size_t picture, std::size_t index, PictureWorkspace& work) const;
  WitnessResidual witnessResidual(std::size_t picture, std::size_t index, const PictureWorkspace& work) const;
  /// Computes an observation's motion sums. False if a corner has no projection.
  bool addMotion(const BoardObservation& observation, const PreparedImage::Group& group, PictureWorkspace& work,
                 BoardMotionSums& motion) const;

private:
  bool addGroup(const ImageObservation& picture, const PreparedImage::Group& group, PictureWorkspace& work,
                PosePart& part) const;
  bool addCorners(const BoardObservation& observation, const std::vector<std::size_t>& extras, CameraFrames& attitude,
                  PictureWorkspace& work) const;
  void addFloorContact(const ObservationChain& sole, const PreparedImage::Group& group, PictureWorkspace& work,
                       PosePart& part) const;
  void addImuReading(const ImageObservation& picture, const PreparedImage& prepared, PictureWorkspace& work,
                     PosePart& part) const;
  void addWitness(const WitnessObservation& observation, const PreparedImage::Group& group, PictureWorkspace& work,
                  PosePart& part) const;
  WitnessRows compareWitness(const WitnessObservation& observation, const PictureWorkspace& work,
                             std::optional<CameraFrames>& frames) const;
  Loss::Value lossOf(const WitnessObservation& observation, const Eigen::Ref<const Eigen::VectorXd>& residual,
                     const Witness::Part& part) const;

  const Measurements& measurements_;
  const Model& model_;
  Noise noise_;
  Loss loss_;
};

} // namespace naocal

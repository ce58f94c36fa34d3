#pragma once

#include "data/Capture.hpp"
#include "poses/candidates/PoseSampler.hpp"
#include "robot/Kinematics.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace naocal {

/// What is observed of a robot in a pose when its joints turn a little: any n numbers per radian, by m joints.
class PoseSensor {
public:
  virtual ~PoseSensor() = default;

  /// Angles per joint of the drawing [rad].
  virtual Eigen::MatrixXd observe(const Eigen::VectorXd& angles) const = 0;
};

/// Cameras over a floor of points every 0.25 m, 4 m around the robot (thesis, algorithm 1): a small turn of a joint
/// moves the picture of the floor almost rigidly, by (t_x, t_y, r_z) about the picture's middle. Three rows per camera,
/// all in pixels: the turn is that of a point half a picture's width off the middle. Lenses without distortion. A
/// camera that has no floor in sight observes nothing: zeros.
class FloorSensor : public PoseSensor {
public:
  /// `joints`: motors; `weights`: how much a camera's rows count, 1 where it has none.
  FloorSensor(const Robot& robot, const Sole& support, const std::map<std::string, CameraIntrinsics>& cameras,
              std::vector<std::size_t> joints, const std::map<std::string, double>& weights = {});

  Eigen::MatrixXd observe(const Eigen::VectorXd& angles) const override;

private:
  struct Eye {
    std::size_t camera;
    CameraIntrinsics lens;
    double weight;
  };
  RigidTransform opticalFromSole(const Eye& eye, const LinkPoses& torsoFromLink) const;

  const Robot& robot_;
  std::size_t sole_; // link
  std::vector<std::size_t> joints_;
  std::vector<Eye> eyes_;
  std::vector<Eigen::Vector3d> floor_; // in the sole's frame [m]
};

/// How alike small turns of joints look to a sensor in one pose, per pair of joints (joint-joint interaction, thesis
/// 4.4): |cos| of their columns of the observation, in the order (0, 1), (0, 2), (1, 2), (0, 3), ... A joint that the
/// sensor does not see move looks like every other one: 1.
///
/// `observation`: n numbers of any sensor by m joints.
Eigen::ArrayXd computeJointInteraction(const Eigen::MatrixXd& observation);

/// What a set of poses leaves alike.
struct Interaction {
  double cost = 1;       // mean over pairs of joints, weighted
  std::size_t count = 0; // pairs that are not told apart: above 0.01
};

/// Judges pose-pose interaction (thesis 4.5): the product, pair by pair, of the poses' joint-joint interactions.
class InteractionCriterion {
public:
  /// `jointWeights`: how much each joint matters; a pair's weight is the product of its joints'.
  explicit InteractionCriterion(const Eigen::VectorXd& jointWeights);

  Interaction operator()(const Eigen::ArrayXd& product) const;

  /// The thesis's chain: the pose of the least cost, then always the one with which the product's cost falls most, as
  /// long as it falls, up to `count`. Indices.
  std::vector<std::size_t> selectChain(const std::vector<Eigen::ArrayXd>& poses, std::size_t count) const;

private:
  Eigen::ArrayXd weights_; // per pair, together 1
};

/// The thesis's way to select poses, by what looks alike to the cameras over the floor.
class ThesisCriterion {
public:
  /// `joints`: motors whose turns are to be told apart; `weights`: of joints and cameras by name, 1 where it has none.
  ThesisCriterion(const Robot& robot, const Sole& support, const std::map<std::string, CameraIntrinsics>& cameras,
                  const std::vector<std::size_t>& joints, const std::map<std::string, double>& weights);

  Interaction interaction(const std::vector<ValidPose>& poses) const;
  /// InteractionCriterion::chain.
  std::vector<std::size_t> selectChain(const std::vector<ValidPose>& poses, std::size_t count) const;

private:
  std::vector<Eigen::ArrayXd> interactions(const std::vector<ValidPose>& poses) const;

  FloorSensor sensor_;
  InteractionCriterion judge_;
  Eigen::Index angles_; // per pose
};

} // namespace naocal

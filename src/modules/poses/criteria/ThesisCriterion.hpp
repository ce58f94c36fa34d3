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

/// Observation of small joint rotations in a pose: an n x m matrix, n values per radian for m joints.
class PoseSensor {
public:
  virtual ~PoseSensor() = default;

  /// `angles`: per joint of the drawing [rad].
  virtual Eigen::MatrixXd observe(const Eigen::VectorXd& angles) const = 0;
};

/// Cameras above a floor of points every 0.25 m, within 4 m of the robot (thesis, algorithm 1): a small joint rotation
/// moves the image of the floor almost rigidly, by (t_x, t_y, r_z) about the image centre. Three rows per camera, all
/// in pixels: the rotation is scaled to a point half an image width off the centre. Ignores lens distortion. A camera
/// without floor in view gives zeros.
class FloorSensor : public PoseSensor {
public:
  /// `joints`: motors; `weights`: factor of a camera's rows by name, default 1.
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

/// Joint-joint interaction (thesis 4.4): similarity of small joint rotations in one pose, per pair of joints: |cos| of
/// their columns of the observation, in the order (0, 1), (0, 2), (1, 2), (0, 3), ... A joint with a zero column has 1
/// with every other one.
///
/// `observation`: n values of a sensor by m joints.
Eigen::ArrayXd computeJointInteraction(const Eigen::MatrixXd& observation);

/// Remaining similarity of joints after a set of poses.
struct Interaction {
  double cost = 1;       // weighted mean over pairs of joints
  std::size_t count = 0; // pairs not distinguished: product above 0.01
};

/// Evaluates pose-pose interaction (thesis 4.5): the product, pair by pair, of the poses' joint-joint interactions.
class InteractionCriterion {
public:
  /// `jointWeights`: importance of each joint; a pair's weight is the product of its joints' weights.
  explicit InteractionCriterion(const Eigen::VectorXd& jointWeights);

  Interaction operator()(const Eigen::ArrayXd& product) const;

  /// The thesis's chain: starts with the pose of the least cost, then always adds the one that reduces the product's
  /// cost most, while it decreases, up to `count`. Returns indices.
  std::vector<std::size_t> selectChain(const std::vector<Eigen::ArrayXd>& poses, std::size_t count) const;

private:
  Eigen::ArrayXd weights_; // per pair, sum 1
};

/// The thesis's selection of poses, by similarity of joint rotations to the cameras above the floor.
class ThesisCriterion {
public:
  /// `joints`: motors to distinguish; `weights`: of joints and cameras by name, default 1.
  ThesisCriterion(const Robot& robot, const Sole& support, const std::map<std::string, CameraIntrinsics>& cameras,
                  const std::vector<std::size_t>& joints, const std::map<std::string, double>& weights);

  Interaction interaction(const std::vector<ValidPose>& poses) const;
  /// InteractionCriterion::selectChain.
  std::vector<std::size_t> selectChain(const std::vector<ValidPose>& poses, std::size_t count) const;

private:
  std::vector<Eigen::ArrayXd> interactions(const std::vector<ValidPose>& poses) const;

  FloorSensor sensor_;
  InteractionCriterion judge_;
  Eigen::Index angles_; // number of joint angles per pose
};

} // namespace naocal

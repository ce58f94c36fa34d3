#pragma once

#include "camera/CornerBlock.hpp"
#include "math/Simd.hpp"
#include "robot/Kinematics.hpp"
#include "robot/ModelState.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace naocal {

/// Lens (fx, fy, cx, cy, k1, k2, p1, p2, k3), shape of the board (scale, bow) and time between rows: quantities whose
/// effect is not a rigid motion of the scene. Each adds a column to the six of the rigid motion.
constexpr std::size_t lensCount = 9;
constexpr std::size_t boardScaleExtra = 9, boardBowExtra = 10, rowTimeExtra = 11, extraCount = 12;

/// Projection of four corners and its derivative with respect to a motion of the board in the optical frame: d(u) =
/// rowsU . (omega, v), d(v) = rowsV . (omega, v) for pointInOptical moving by omega x p + v.
struct ProjectedBlock {
  Double4 u, v;               // predicted [px]
  Double4 rowsU[6], rowsV[6]; // [px/rad] x 3, [px/m] x 3
  Double4 x, y;               // X/Z, Y/Z [1]
};
using ProjectedBlocks = std::vector<ProjectedBlock>;

/// Camera, torso, target, world and board frames at one instant.
struct CameraFrames {
  RigidTransform opticalFromTorso, opticalFromTarget, opticalFromWorld, opticalFromBoard;
  Eigen::Matrix<double, 6, 1> drift = Eigen::Matrix<double, 6, 1>::Zero(); // of the scene, (omega, v) [rad/s, m/s]
};

/// A robot's links in one model state. Refers to its parts for the duration of a call.
struct PosedRobot {
  const Robot& robot;
  const ModelState& modelState;
  const LinkPoses& torsoFromLink;
};

/// Shift of four corners in the picture [px] per unit of a quantity.
struct CornerShift {
  Double4 u{}, v{};
};

/// Board that a camera sees: the link that carries it (for a board in the world, the support), and its index.
struct ChainTarget {
  std::size_t link;
  bool inWorld;
  std::size_t board;
};

/// Kinematic chain between one camera and one target: the links between them, and the motion of the target in the
/// camera by each quantity.
///
///   pointInOptical = opticalFromLink(camera) * linkFromTorso * torsoFromLink(target) * linkFromBoard * pointInBoard
///
/// A link may replace the camera (`betweenLinks`); then "optical" is that link's frame.
/// For a board in the world the target link is the support and linkFromBoard = inverse(worldFromSupport) *
/// worldFromBoard. A camera in the world is carried by the support, too: linkFromOptical = inverse(worldFromSupport) *
/// worldFromOptical.
class ObservationChain {
public:
  /// `support`: the link that stands in the world, for a camera beside the robot.
  ObservationChain(const Robot& robot, const StateLayout& quantities, std::size_t camera, const ChainTarget& target,
                   std::optional<std::size_t> support = std::nullopt);

  /// Chain from a link to the floor under a sole.
  static ObservationChain betweenLinks(const Robot& robot, const StateLayout& quantities, std::size_t eyeLink,
                                       std::size_t sole);

  /// Links that `cameraFrames` needs, parents first.
  const std::vector<std::size_t>& links() const { return links_; }
  /// Joints between camera and target: the ones that affect the picture.
  const std::vector<std::size_t>& joints() const { return joints_; }
  std::size_t board() const { return target_.board; }
  /// Lets the board's placement count from `reference` in its link or in the world: reference * T(placement).
  void setReference(const RigidTransform& reference) { reference_ = reference; }
  /// Whether both chains connect the same camera and link. They then have the same derivatives, except for those by the
  /// boards themselves.
  bool sharesPath(const ObservationChain& other) const {
    return camera_ == other.camera_ && target_.link == other.target_.link && target_.inWorld == other.target_.inWorld;
  }

  /// Requires `posed.torsoFromLink` to contain `links()`.
  CameraFrames cameraFrames(const PosedRobot& posed) const;
  /// The same in two steps, for several boards along one chain: all but opticalFromBoard, then only that.
  CameraFrames pathFrames(const PosedRobot& posed) const;
  void placeBoard(const RigidTransform& linkFromBoard, CameraFrames& attitude) const;

  /// Sets the velocity of the scene in the optical frame for joint velocities `velocity` (one per joint) [rad/s].
  void setDrift(const PosedRobot& posed, const Eigen::VectorXd& velocity, CameraFrames& attitude) const;

  /// Projects corners through the lens, each at the exposure time of its row:
  ///
  ///   p -> p + (omega x p + v) * rowTime * (v_measured - cy),  (omega, v) = the drift
  ///
  /// The derivatives are taken at that position; the derivative of the drift itself is neglected (relative error at
  /// most velocity times 15 ms). Returns false if a corner lies behind the camera and so has no projection.
  bool project(const CameraFrames& attitude, const ModelState& modelState, const CornerBlocks& corners,
               ProjectedBlocks& projected) const;

  /// Fills `columns` (6 + number of extras rows, one column per quantity in `wanted`) with the motion (omega, v) of the
  /// scene in the optical frame per unit of the quantity, or with 1 in the row of its extra if it is one. `extras`:
  /// indices of the extras (0..11) in the order of the rows beyond the six.
  void fillMotionColumns(const PosedRobot& posed, const CameraFrames& attitude, const std::vector<std::size_t>& wanted,
                         const std::vector<std::size_t>& extras, Eigen::Ref<Eigen::MatrixXd> columns) const;

  /// Shift of four corners per unit of an extra.
  static CornerShift shiftByExtra(std::size_t extra, const CameraFrames& attitude, const ModelState& modelState,
                                  const CornerBlock& corners, const ProjectedBlock& projected);

  /// Index of a quantity among the extras (0..11), if it is one.
  std::optional<std::size_t> extraIndex(std::size_t quantity) const;

private:
  ObservationChain(const Robot& robot, const StateLayout& quantities, std::optional<std::size_t> camera,
                   std::size_t eyeLink, const ChainTarget& target);
  Twist linkMotion(const PosedRobot& posed, const CameraFrames& attitude, std::size_t quantity) const;
  Twist mountMotion(const Robot& robot, const ModelState& modelState, std::size_t number) const;
  Twist linkStepMotion(const PosedRobot& posed, const CameraFrames& attitude, std::size_t joint,
                       std::size_t number) const;
  RigidTransform boardParent(const CameraFrames& attitude) const;

  StateLayout quantities_;
  std::optional<std::size_t> camera_; // absent: a link replaces the camera
  std::size_t eye_;                   // link
  bool eyeInWorld_;
  ChainTarget target_;
  std::optional<RigidTransform> reference_; // of the board's placement; absent: the identity
  std::vector<std::size_t> links_, joints_;
  std::vector<int> side_; // per link: -1 carries the camera, +1 carries the target, 0 lies not between them
};

} // namespace naocal

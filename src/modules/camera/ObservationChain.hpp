#pragma once

#include "camera/CornerBlock.hpp"
#include "math/Simd.hpp"
#include "robot/Kinematics.hpp"
#include "robot/ModelState.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace naocal {

/// Lens (fx, fy, cx, cy, k1, k2, p1, p2, k3), shape of the board (scale, bow) and the time between rows: quantities
/// that do not merely move the picture's scene rigidly. Each adds a column of its own beside the six of the picture's
/// motion.
constexpr std::size_t lensCount = 9;
constexpr std::size_t boardScaleExtra = 9, boardBowExtra = 10, rowTimeExtra = 11, extraCount = 12;

/// Where four corners are seen, and how that changes when the board moves in the camera's (optical) frame:
/// d(u) = rowsU . (omega, v), d(v) = rowsV . (omega, v) for pointInOptical moving by omega x p + v.
struct ProjectedBlock {
  Double4 u, v;               // predicted [px]
  Double4 rowsU[6], rowsV[6]; // [px/rad] x 3, [px/m] x 3
  Double4 x, y;               // X/Z, Y/Z [1]
};
using ProjectedBlocks = std::vector<ProjectedBlock>;

/// Where camera, torso, target, world and board are at one instant.
struct CameraFrames {
  RigidTransform opticalFromTorso, opticalFromTarget, opticalFromWorld, opticalFromBoard;
  Eigen::Matrix<double, 6, 1> drift = Eigen::Matrix<double, 6, 1>::Zero(); // of the scene, (omega, v) [rad/s, m/s]
};

/// How one camera sees one target: the path of links between them, and what moves the one against the other.
///
///   pointInOptical = opticalFromLink(camera) * linkFromTorso * torsoFromLink(target) * linkFromBoard * pointInBoard
///
/// A link may take the camera's place (`betweenLinks`): then "optical" is that link's frame.
/// For a floor board the target link is the support foot's sole and linkFromBoard = inverse(worldFromSole) *
/// worldFromBoard.
class ObservationChain {
public:
  ObservationChain(const Robot& robot, const StateLayout& quantities, std::size_t camera, std::size_t targetLink,
                   bool onFloor, std::size_t board);

  /// How a link sees the floor on which a sole stands.
  static ObservationChain betweenLinks(const Robot& robot, const StateLayout& quantities, std::size_t eyeLink,
                                       std::size_t sole);

  /// Links whose posture `cameraFrames` needs, parents first.
  const std::vector<std::size_t>& links() const { return links_; }
  /// Joints on the path between camera and target: the ones whose angles move the picture.
  const std::vector<std::size_t>& joints() const { return joints_; }
  std::size_t board() const { return board_; }
  /// From the same camera to the same link: what moves the one picture moves the other in the same way, but for what
  /// moves the boards themselves.
  bool sharesPath(const ObservationChain& other) const {
    return camera_ == other.camera_ && target_ == other.target_ && onFloor_ == other.onFloor_;
  }

  /// `torsoFromLink` must hold `links()`.
  CameraFrames cameraFrames(const Robot& robot, const ModelState& belief, const LinkPoses& torsoFromLink) const;
  /// The same in two steps, for several boards along one path: all but opticalFromBoard, and only that.
  CameraFrames pathFrames(const Robot& robot, const ModelState& belief, const LinkPoses& torsoFromLink) const;
  void placeBoard(const RigidTransform& linkFromBoard, CameraFrames& attitude) const;

  /// How the scene drifts in the optical frame while the joints move at `velocity` (one per joint) [rad/s].
  void setDrift(const Robot& robot, const ModelState& belief, const LinkPoses& torsoFromLink,
                const Eigen::VectorXd& velocity, CameraFrames& attitude) const;

  /// Projects corners through the lens, each where it is when its row is exposed:
  ///
  ///   p -> p + (omega x p + v) * rowTime * (v_measured - cy),  (omega, v) = the drift
  ///
  /// (The rows of the derivative are taken there and the change of the drift itself is left out: a share of at most
  /// velocity times 15 ms.) False when one of them lies behind the camera (then it is nowhere in the
  /// picture).
  bool project(const CameraFrames& attitude, const ModelState& belief, const CornerBlocks& corners,
               ProjectedBlocks& projected) const;

  /// Fills `columns` (6 + number of extras rows, one column per wanted quantity) with the motion (omega, v) of the
  /// scene in the optical frame per unit of each quantity in `wanted`, and 1 in the row of its extra where it is one.
  /// `extras`: extras' numbers (0..11) in the order of the rows beyond the six.
  void fillMotionColumns(const Robot& robot, const CameraFrames& attitude, const ModelState& belief,
                         const LinkPoses& torsoFromLink, const std::vector<std::size_t>& wanted,
                         const std::vector<std::size_t>& extras, Eigen::Ref<Eigen::MatrixXd> columns) const;

  /// d(u), d(v) of four corners per unit of an extra.
  static void fillExtraRows(std::size_t extra, const CameraFrames& attitude, const ModelState& belief,
                            const CornerBlock& corners, const ProjectedBlock& projected, Double4& du, Double4& dv);

  /// The extra's number (0..11) of a quantity, if it is one.
  std::optional<std::size_t> extraIndex(std::size_t quantity) const;

private:
  ObservationChain(const Robot& robot, const StateLayout& quantities, std::optional<std::size_t> camera,
                   std::size_t eyeLink, std::size_t targetLink, bool onFloor, std::size_t board);
  using Twist = Eigen::Matrix<double, 6, 1>; // omega [rad], v [m], in the optical frame
  Twist linkMotion(const Robot& robot, const CameraFrames& attitude, const ModelState& belief,
                   const LinkPoses& torsoFromLink, std::size_t quantity) const;
  Twist mountMotion(const Robot& robot, const ModelState& belief, std::size_t number) const;

  StateLayout quantities_;
  std::optional<std::size_t> camera_; // absent: a link is the eye
  std::size_t eye_, target_, board_;  // links, and the target's number
  bool onFloor_;
  std::vector<std::size_t> links_, joints_;
  std::vector<int> side_; // per link: -1 it carries the camera, +1 it carries the target, 0 it is not between them
};

} // namespace naocal

#pragma once

#include "camera/ObservationChain.hpp"
#include "data/Capture.hpp"
#include "math/Angles.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// When a corner counts as seen: the detector must be able to measure it.
struct VisibilityLimits {
  double nearest = 0.4, farthest = 1.6; // from the camera [m]
  double grazing = radians(15);         // least angle between ray and board [rad]
  double border = 10;                   // least distance to the picture's edge [px]
  std::size_t corners = 8;              // a board with fewer is not seen
  bool wholeBoards = false;             // nor is one that is not wholly in the picture
};

/// A board that a camera sees.
struct VisibleBoard {
  std::string camera, board;
  std::vector<int> corners; // ids
};

/// A robot on one sole or both, boards around it on the floor, and what its cameras see of them.
class PlanningScene {
public:
  /// `boards`: with their placements in the support sole's frame (on both feet the left one's), else InputError.
  /// `cameras`: by the robot's names.
  PlanningScene(const Robot& robot, SupportFoot foot, const std::vector<Board>& boards,
                const std::map<std::string, CameraIntrinsics>& cameras, const VisibilityLimits& limits);

  /// The drawn robot on its sole among the boards, all angles zero.
  const ModelState& nominalState() const { return drawn_; }

  /// Joints between the sole and the cameras, by their motors; on both feet the other leg's too.
  std::vector<std::size_t> joints() const;

  std::vector<VisibleBoard> visibleBoards(const ModelState& belief, const LinkPoses& torsoFromLink) const;

  /// J^T R^-1 J over the corners in sight, `pixel` being their noise [px]: what the pictures of a pose tell about the
  /// unknowns: an offset per joint of the drawing (at its motor) [rad], three rotations per camera [rad], and x, y [m],
  /// yaw [rad] per board. On both feet also over how the right sole lies on the left one's floor (FloorContact).
  Eigen::MatrixXd information(const ModelState& belief, const LinkPoses& torsoFromLink, double pixel = 1) const;

  /// What is known of them before any picture: 1 / sigma^2 on the diagonal.
  Eigen::MatrixXd priorInformation() const;

private:
  /// One camera before one board.
  struct Outlook {
    std::size_t camera;
    CameraIntrinsics lens;
    ObservationChain view;
    CornerBlocks corners;
  };

  /// Where the board's corners come to lie in the picture, and which of them are seen.
  struct Projection {
    CameraFrames attitude;
    ProjectedBlocks corners;
    std::vector<int> seen; // ids
  };
  Projection projection(const Outlook& outlook, ModelState& belief, const LinkPoses& torsoFromLink) const;

  void addFloorContact(const ModelState& belief, const LinkPoses& torsoFromLink, Eigen::MatrixXd& information) const;

  const Robot& robot_;
  VisibilityLimits limits_;
  std::vector<Board> boards_;
  StateLayout quantities_;
  ModelState drawn_;
  std::vector<Outlook> outlooks_;
  std::optional<ObservationChain> otherSole_; // on both feet: how it sees the floor
};

} // namespace naocal

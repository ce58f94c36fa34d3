#pragma once

#include "camera/ObservationChain.hpp"
#include "data/Capture.hpp"
#include "math/Angles.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// Visibility limits of corners: beyond them the detector cannot measure reliably.
struct VisibilityLimits {
  double nearest = 0.4, farthest = 1.6; // from the camera [m]
  double grazing = radians(15);         // smallest angle between ray and board [rad]
  double border = 10;                   // smallest distance to the image border [px]
  std::size_t corners = 8;              // a board with fewer visible corners is ignored
  bool wholeBoards = false;             // requires complete boards in the image
};

/// A board visible to a camera.
struct VisibleBoard {
  std::string camera, board;
  std::vector<int> corners; // ids
};

/// A robot on one sole or both, boards around it on the floor, and their visibility to its cameras.
class PlanningScene {
public:
  /// `boards`: need placements in the support sole's frame (on both feet the left one's), otherwise throws InputError.
  /// `cameras`: by the drawing's names; throws InputError for unknown ones.
  PlanningScene(const Robot& robot, SupportFoot foot, const std::vector<Board>& boards,
                const std::map<std::string, CameraIntrinsics>& cameras, const VisibilityLimits& limits);

  /// The drawn robot on its sole among the boards; all angles are zero.
  const ModelState& nominalState() const { return drawn_; }

  /// Joints between the support sole and the cameras, as motors; on both feet also those of the other leg.
  std::vector<std::size_t> joints() const;

  std::vector<VisibleBoard> visibleBoards(const ModelState& modelState, const LinkPoses& torsoFromLink) const;

  /// J^T R^-1 J over the visible corners, `pixel` being their noise, 1 sigma [px]: Fisher information of a pose's
  /// images about the unknowns: an offset per joint of the drawing (at its motor) [rad], three rotations per camera
  /// [rad], and x, y [m], yaw [rad] per board. On both feet it includes the contact of the right sole with the left
  /// one's floor (FloorContact).
  Eigen::MatrixXd information(const ModelState& modelState, const LinkPoses& torsoFromLink, double pixel = 1) const;

  /// Prior information: 1 / sigma^2 on the diagonal.
  Eigen::MatrixXd priorInformation() const;

private:
  /// A camera and a board.
  struct Outlook {
    std::size_t camera;
    CameraIntrinsics lens;
    ObservationChain view;
    CornerBlocks corners;
  };

  /// Projected corners of a board, and the visible ones.
  struct Projection {
    CameraFrames attitude;
    ProjectedBlocks corners;
    std::vector<int> seen; // ids
  };
  Projection projection(const Outlook& outlook, ModelState& modelState, const LinkPoses& torsoFromLink) const;

  void addFloorContact(const ModelState& modelState, const LinkPoses& torsoFromLink,
                       Eigen::MatrixXd& information) const;

  const Robot& robot_;
  VisibilityLimits limits_;
  std::vector<Board> boards_;
  StateLayout quantities_;
  ModelState drawn_;
  std::vector<Outlook> outlooks_;
  std::optional<ObservationChain> otherSole_; // on both feet: chain between the soles
};

} // namespace naocal

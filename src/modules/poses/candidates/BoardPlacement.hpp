#pragma once

#include "data/Capture.hpp"
#include "math/Polygon.hpp"
#include "robot/Balance.hpp"
#include "robot/Robot.hpp"

#include <Eigen/Core>
#include <vector>

namespace naocal {

/// The squares of a board on the floor and `margin` around them [m], counter-clockwise.
ConvexPolygon boardOutline(const Board& board, double margin = 0);

/// y of the line between them in the frame of the one that the robot stands on [m].
constexpr double midlineBetweenFeet(SupportFoot supportFoot) {
  return supportFoot == SupportFoot::right ? footDistance / 2 : -footDistance / 2;
}

/// Where boards may lie on the floor around a robot.
class BoardPlacementRules {
public:
  /// `farthest`: a board's middle from the support sole [m]; `gap`: between boards, and from where feet stand [m].
  BoardPlacementRules(const Robot& robot, SupportFoot supportFoot, double farthest, double gap);

  /// Whether one of the boards, in the support sole's frame, lies well beside feet and other boards.
  bool isAllowed(const std::vector<Board>& boards, std::size_t one) const;

private:
  double farthest_, gap_;
  std::vector<ConvexPolygon> feet_; // the support sole, and the other one beside it
};

/// The angles of the mirror image of a robot's pose, left and right exchanged. Throws InputError for a joint without a
/// mirror image of its own.
Eigen::VectorXd mirrorAngles(const Robot& robot, const Eigen::VectorXd& angles);

/// Where a board lies when its sheet is mirrored at the line y = `middle`.
Placement mirrorAngles(const Board& board, double middle);

/// Boards that lie alike to the left and to the right of y = `middle`, and remain so.
class MirroredBoards {
public:
  /// Pairs each board with the one nearest to its mirror image, which may be itself.
  MirroredBoards(const std::vector<Board>& boards, double middle);

  std::size_t mirrorImageOf(std::size_t board) const { return mates_[board]; }
  /// After one was moved: brings its mate to its mirror image; a board that is its own mate back onto the line, square
  /// to it.
  void mirrorMoved(std::vector<Board>& boards, std::size_t moved) const;

private:
  double middle_;
  std::vector<std::size_t> mates_;
};

} // namespace naocal

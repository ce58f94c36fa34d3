#pragma once

#include "data/Capture.hpp"
#include "math/Polygon.hpp"
#include "robot/Balance.hpp"
#include "robot/Robot.hpp"

#include <Eigen/Core>
#include <vector>

namespace naocal {

/// Outline of a board's squares with a margin [m], counter-clockwise.
ConvexPolygon boardOutline(const Board& board, double margin = 0);

/// y of the midline between the feet in the support sole's frame [m].
constexpr double midlineBetweenFeet(SupportFoot supportFoot) {
  return supportFoot == SupportFoot::right ? footDistance / 2 : -footDistance / 2;
}

/// Allowed places for boards on the floor around a robot.
class BoardPlacementRules {
public:
  /// `farthest`: distance of a board's centre from the support sole [m]; `gap`: between boards, and between boards and
  /// feet [m].
  BoardPlacementRules(const Robot& robot, SupportFoot supportFoot, double farthest, double gap);

  /// Whether board `one` (placements in the support sole's frame) is within range and clear of feet and other boards.
  bool isAllowed(const std::vector<Board>& boards, std::size_t one) const;

private:
  double farthest_, gap_;
  std::vector<ConvexPolygon> feet_; // support sole, and the other one beside it
};

/// Angles of the mirror image of a pose, left and right exchanged. Throws InputError for a joint without a mirror
/// image.
Eigen::VectorXd mirrorAngles(const Robot& robot, const Eigen::VectorXd& angles);

/// Placement of a board's mirror image about the line y = `middle`.
Placement mirrorPlacement(const Board& board, double middle);

/// Keeps boards symmetric about the line y = `middle`.
class MirroredBoards {
public:
  /// Pairs each board with the one nearest to its mirror image, possibly itself.
  MirroredBoards(const std::vector<Board>& boards, double middle);

  std::size_t mirrorImageOf(std::size_t board) const { return mates_[board]; }
  /// Restores symmetry after a move: places the board's mate at its mirror image; a board paired with itself returns to
  /// the midline, aligned with it.
  void mirrorMoved(std::vector<Board>& boards, std::size_t moved) const;

private:
  double middle_;
  std::vector<std::size_t> mates_;
};

} // namespace naocal

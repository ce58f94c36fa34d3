#pragma once

#include "data/Capture.hpp"
#include "robot/Robot.hpp"

#include <Eigen/Core>
#include <vector>

namespace naocal {

/// The angles of the mirror image of a robot's pose, left and right exchanged. Throws InputError for a joint without a
/// mirror image of its own.
Eigen::VectorXd mirrored(const Robot& robot, const Eigen::VectorXd& angles);

/// Where a board lies when its sheet is mirrored at the line y = `middle`.
Placement mirrored(const Board& board, double middle);

/// Boards that lie alike to the left and to the right of y = `middle`, and remain so.
class MirroredBoards {
public:
  /// Pairs each board with the one nearest to its mirror image, which may be itself.
  MirroredBoards(const std::vector<Board>& boards, double middle);

  std::size_t mate(std::size_t board) const { return mates_[board]; }
  /// After one was moved: brings its mate to its mirror image; a board that is its own mate back onto the line, square
  /// to it.
  void follow(std::vector<Board>& boards, std::size_t moved) const;

private:
  double middle_;
  std::vector<std::size_t> mates_;
};

} // namespace naocal

#include "poses/BoardPlaces.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace naocal {

BoardPlaces::BoardPlaces(const Robot& robot, SupportFoot supportFoot, double farthest, double gap)
    : farthest_{farthest}, gap_{gap} {
  feet_ = {supportSole(robot, supportFoot).outline, otherSole(robot, supportFoot).outline};
  for (Eigen::Vector2d& corner : feet_.back()) {
    corner.y() += supportFoot == SupportFoot::right ? betweenFeet : -betweenFeet;
  }
}

bool BoardPlaces::allow(const std::vector<Board>& boards, std::size_t one) const {
  const Outline own = sheet(boards[one], gap_);
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& corner : own) {
    middle += corner / static_cast<double>(own.size());
  }
  const auto clear = [&](const Outline& other) { return apart(own, other); };
  for (std::size_t i = 0; i < boards.size(); ++i) {
    if (i != one && !clear(sheet(boards[i]))) {
      return false;
    }
  }
  return middle.norm() <= farthest_ && std::all_of(feet_.begin(), feet_.end(), clear);
}

Outline sheet(const Board& board, double margin) {
  Eigen::AlignedBox3d extent;
  for (const Eigen::Vector3d& point : board.points) {
    extent.extend(point);
  }
  const double beyond = margin + (board.pattern ? board.pattern->squareLength : 0); // the outermost squares
  const Eigen::Vector3d least = extent.min().array() - beyond, most = extent.max().array() + beyond;
  const Eigen::Rotation2Dd turn{board.placement->yaw};
  const Eigen::Vector2d at{board.placement->x, board.placement->y};
  Outline result;
  for (const Eigen::Vector2d& corner : {Eigen::Vector2d{least.x(), least.y()}, Eigen::Vector2d{most.x(), least.y()},
                                        Eigen::Vector2d{most.x(), most.y()}, Eigen::Vector2d{least.x(), most.y()}}) {
    result.push_back(at + turn * corner);
  }
  return result;
}

} // namespace naocal

#include "poses/candidates/BoardPlacement.hpp"

#include "io/InputError.hpp"
#include "math/Angles.hpp"
#include "math/LinearAlgebra.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <numeric>

namespace naocal {

BoardPlacementRules::BoardPlacementRules(const Robot& robot, SupportFoot supportFoot, double farthest, double gap)
    : farthest_{farthest}, gap_{gap} {
  feet_ = {supportSole(robot, supportFoot).outline, otherSole(robot, supportFoot).outline};
  for (Eigen::Vector2d& corner : feet_.back()) {
    corner.y() += supportFoot == SupportFoot::right ? footDistance : -footDistance;
  }
}

bool BoardPlacementRules::isAllowed(const std::vector<Board>& boards, std::size_t one) const {
  const ConvexPolygon own = boardOutline(boards[one], gap_);
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& corner : own) {
    middle += corner / static_cast<double>(own.size());
  }
  const auto clear = [&](const ConvexPolygon& other) { return areSeparated(own, other); };
  for (std::size_t i = 0; i < boards.size(); ++i) {
    if (i != one && !clear(boardOutline(boards[i]))) {
      return false;
    }
  }
  return middle.norm() <= farthest_ && std::all_of(feet_.begin(), feet_.end(), clear);
}

ConvexPolygon boardOutline(const Board& board, double margin) {
  Eigen::AlignedBox3d extent;
  for (const Eigen::Vector3d& point : board.points) {
    extent.extend(point);
  }
  const double beyond = margin + (board.pattern ? board.pattern->squareLength : 0); // the outermost squares
  const Eigen::Vector3d least = extent.min().array() - beyond, most = extent.max().array() + beyond;
  const Eigen::Rotation2Dd turn{board.placement->yaw};
  const Eigen::Vector2d at{board.placement->x, board.placement->y};
  ConvexPolygon result;
  for (const Eigen::Vector2d& corner : {Eigen::Vector2d{least.x(), least.y()}, Eigen::Vector2d{most.x(), least.y()},
                                        Eigen::Vector2d{most.x(), most.y()}, Eigen::Vector2d{least.x(), most.y()}}) {
    result.push_back(at + turn * corner);
  }
  return result;
}

namespace {

Eigen::Vector2d middleOf(const Board& board) {
  const ConvexPolygon corners = boardOutline(board);
  return std::accumulate(corners.begin(), corners.end(), Eigen::Vector2d::Zero().eval()) /
         static_cast<double>(corners.size());
}

std::string otherSide(const std::string& name) {
  return name.starts_with('L') ? 'R' + name.substr(1) : name.starts_with('R') ? 'L' + name.substr(1) : name;
}

} // namespace

Eigen::VectorXd mirrorAngles(const Robot& robot, const Eigen::VectorXd& angles) {
  Eigen::VectorXd result(angles.size());
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    const auto other = robot.jointIndex(otherSide(robot.joints[joint].name));
    // Mirror image of a rotation axis.
    const Eigen::Vector3d image = Eigen::Vector3d{-1, 1, -1}.cwiseProduct(robot.joints[joint].axis);
    const double sign = other ? image.dot(robot.joints[*other].axis) : 0;
    if (std::abs(std::abs(sign) - 1) > 1e-6) {
      throw InputError{
          fmt::format("the drawing of {}: expected a joint that is the mirror image of {}, found none; its "
                      "poses cannot be mirrored",
                      robot.model, robot.joints[joint].name)};
    }
    result[eigenIndex(*other)] = std::round(sign) * angles[eigenIndex(joint)];
  }
  return result;
}

Placement mirrorPlacement(const Board& board, double middle) {
  // A mirrored sheet has the opposite yaw; its lower edge becomes the upper one.
  Board image = board;
  image.placement->yaw = -board.placement->yaw;
  const Eigen::Vector2d wanted{middleOf(board).x(), 2 * middle - middleOf(board).y()};
  const Eigen::Vector2d step = wanted - middleOf(image);
  image.placement->x += step.x();
  image.placement->y += step.y();
  return *image.placement;
}

MirroredBoards::MirroredBoards(const std::vector<Board>& boards, double middle) : middle_{middle} {
  mates_.assign(boards.size(), boards.size());
  for (std::size_t i = 0; i < boards.size(); ++i) {
    const Eigen::Vector2d image{middleOf(boards[i]).x(), 2 * middle - middleOf(boards[i]).y()};
    double least = std::numeric_limits<double>::infinity();
    std::size_t nearest = i;
    for (std::size_t k = i; k < boards.size() && mates_[i] == boards.size(); ++k) {
      const double distance = (middleOf(boards[k]) - image).norm();
      if (mates_[k] == boards.size() && boards[k].points.size() == boards[i].points.size() && distance < least) {
        least = distance;
        nearest = k;
      }
    }
    if (mates_[i] == boards.size()) {
      mates_[i] = nearest;
      mates_[nearest] = i;
    }
  }
}

void MirroredBoards::mirrorMoved(std::vector<Board>& boards, std::size_t moved) const {
  Board& board = boards[moved];
  if (mates_[moved] != moved) {
    boards[mates_[moved]].placement = mirrorPlacement(board, middle_);
    return;
  }
  constexpr double quarter = std::numbers::pi / 2;
  const Eigen::Vector2d before = middleOf(board);
  board.placement->yaw = quarter * std::round(board.placement->yaw / quarter);
  const Eigen::Vector2d step = Eigen::Vector2d{before.x(), middle_} - middleOf(board);
  board.placement->x += step.x();
  board.placement->y += step.y();
}

} // namespace naocal

#pragma once

#include "data/Capture.hpp"
#include "math/Polygon.hpp"
#include "robot/Balance.hpp"
#include "robot/Robot.hpp"

#include <vector>

namespace naocal {

/// The squares of a board on the floor and `margin` around them [m], counter-clockwise.
Outline sheet(const Board& board, double margin = 0);

/// y of the line between them in the frame of the one that the robot stands on [m].
constexpr double middleBetweenFeet(SupportFoot supportFoot) {
  return supportFoot == SupportFoot::right ? betweenFeet / 2 : -betweenFeet / 2;
}

/// Where boards may lie on the floor around a robot.
class BoardPlaces {
public:
  /// `farthest`: a board's middle from the support sole [m]; `gap`: between boards, and from where feet stand [m].
  BoardPlaces(const Robot& robot, SupportFoot supportFoot, double farthest, double gap);

  /// Whether one of the boards, in the support sole's frame, lies well beside feet and other boards.
  bool allow(const std::vector<Board>& boards, std::size_t one) const;

private:
  double farthest_, gap_;
  std::vector<Outline> feet_; // the support sole, and the other one beside it
};

} // namespace naocal

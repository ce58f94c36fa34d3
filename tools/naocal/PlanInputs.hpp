#pragma once

#include "poses/PosePlan.hpp"
#include "poses/criteria/PlanOptions.hpp"

#include <map>
#include <string>
#include <vector>

namespace naocal {

/// What `naocal poses` plans for.
struct PlannedScene {
  std::vector<Board> boards; // placements seen from the sole
  std::map<std::string, CameraIntrinsics> cameras;
};

/// Four A2 boards around the robot.
PlannedScene plannedScene();
/// Boards and cameras of a capture set; placements that are only guessed are where planning begins. Throws InputError
/// where none lies on the floor.
PlannedScene plannedScene(const std::string& captureSet);

/// Has the poses of an earlier plan stay, and the `boards` where it has them. Throws InputError where these are not
/// its own, or its poses are on another foot.
void extendPlan(const std::string& earlier, const Robot& robot, std::vector<Board>& boards, PlanOptions& plan);

/// Of NAME=NUMBER. Throws InputError for anything else.
std::map<std::string, double> readWeights(const std::vector<std::string>& texts);

} // namespace naocal

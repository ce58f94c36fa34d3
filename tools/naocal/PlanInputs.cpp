#include "PlanInputs.hpp"

#include "data/CaptureSetFile.hpp"
#include "io/InputError.hpp"
#include "poses/PoseFile.hpp"
#include "poses/criteria/PlanOptions.hpp"
#include "simulation/SimulationPlan.hpp"

#include <cstdlib>
#include <fmt/format.h>

namespace naocal {

PlannedScene plannedScene() {
  const SimulationPlan usual;
  return {usual.boards, usual.cameras};
}

PlannedScene plannedScene(const std::string& captureSet) {
  const CaptureSet set = readCaptureSet(captureSet, BadCaptures::skip).set;
  PlannedScene result{{}, set.cameras};
  for (Board board : set.boards) {
    if (board.link == "floor") {
      board.placement = board.placement || !board.hasGuess ? board.placement : board.placementGuess;
      result.boards.push_back(board);
    }
  }
  if (result.boards.empty()) {
    throw InputError{fmt::format("{}: expected a board on the floor, found none", captureSet)};
  }
  return result;
}

void extendPlan(const std::string& earlier, const Robot& robot, std::vector<Board>& boards, PlanOptions& plan) {
  const PoseFile file = readPoseFile(earlier, robot);
  for (const PlayablePose& pose : file.poses) {
    if (pose.supportFoot != plan.poses.supportFoot) {
      throw InputError{fmt::format("{}: expected poses on the foot of --support, found {} on another; extend a plan of "
                                   "one foot",
                                   earlier, pose.id)};
    }
    plan.kept.push_back(pose.angles);
  }
  for (Board& board : boards) {
    const auto place = file.boards.find(board.id);
    if (place == file.boards.end()) {
      throw InputError{fmt::format("{}: expected where board {} lies, found nothing; name the set that has the plan's "
                                   "boards with --boards",
                                   earlier, board.id)};
    }
    board.placement = place->second;
  }
  plan.moveBoards = false;
}

std::map<std::string, double> readWeights(const std::vector<std::string>& texts) {
  std::map<std::string, double> result;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    char* end = nullptr;
    const double weight = equals == std::string::npos ? -1 : std::strtod(text.c_str() + equals + 1, &end);
    if (!(weight >= 0) || *end != '\0' || end == text.c_str() + equals + 1) {
      throw InputError{fmt::format("--weight: expected NAME=NUMBER such as LKneePitch=2, found {}", text)};
    }
    result[text.substr(0, equals)] = weight;
  }
  return result;
}

} // namespace naocal

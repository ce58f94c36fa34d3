#include "poses/PoseFile.hpp"

#include "captures/CaptureWords.hpp"
#include "poses/PoseJson.hpp"
#include "poses/PoseOrder.hpp"

#include <nlohmann/json.hpp>

namespace naocal {

namespace {

using Json = nlohmann::json;

/// Where boards are thought to lie, seen from the first pose's sole.
Json boardsOf(const NextPoses& next) {
  for (const Surroundings& here : next.around) {
    if (!next.poses.empty() && here.supportFoot == next.poses.front().pose.supportFoot) {
      return boardsJson(here.boards);
    }
  }
  return Json::array();
}

/// As fast as the joints can.
std::vector<std::optional<double>> secondsAtFullSpeed(const NextPoses& next, const Robot& robot) {
  std::vector<std::optional<double>> result;
  Eigen::VectorXd before = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(robot.joints.size()));
  for (const ProposedPose& pose : next.poses) {
    result.push_back(secondsBetween(robot, before, pose.pose.angles, 1));
    before = pose.pose.angles;
  }
  return result;
}

Json assumptions(const NextPoses& next) {
  return {{"noise", noiseJson(next.noise)},
          {"samples", next.samples},
          {"angles", "sent to the motors as they stand, without compensation"},
          {"boards", "lie where they lay when the last captures were taken; here seen from the first pose's sole"},
          {"collisions", "no part of the drawn robot touches another"},
          {"stance", "the robot stands anew, about where it stood"},
          {"predictedSigma", "from the captures and these poses together"}};
}

} // namespace

Json nextJson(const NextPoses& next, const Robot& robot) {
  return {{"poses", posesOf(next.poses, secondsAtFullSpeed(next, robot), robot)},
          {"why", next.why},
          {"growth", next.growth}};
}

Json posesJson(const NextPoses& next, const Robot& robot) {
  const bool oneFoot = next.around.size() == 1;
  const auto foot = [](SupportFoot each) { return std::string{supportFootWords[static_cast<std::size_t>(each)]}; };
  Json result = nextJson(next, robot);
  result["format"] = "naocal-poses";
  result["version"] = 1;
  result["robot"] = robot.model;
  result["support"] = oneFoot ? foot(next.around.front().supportFoot) : "both";
  result["candidates"] = {{"stable", next.stable}, {"seeing", next.seeing}};
  result["boards"] = boardsOf(next);
  result["firstStance"] = next.firstStance;
  result["predictedSigma"] = next.predictedSigma;
  result["criterion"] = "discrimination";
  result["assumptions"] = assumptions(next);
  return result;
}

} // namespace naocal

#include "poses/PoseFile.hpp"

#include "data/CaptureSetFile.hpp"
#include "poses/OneFoot.hpp"
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

/// Straight on from one to the next, as slowly as a robot on one foot moves.
std::vector<std::optional<double>> secondsBetweenThem(const NextPoses& next, const Robot& robot) {
  std::vector<std::optional<double>> result;
  Eigen::VectorXd before = bentKnees(robot);
  for (const ProposedPose& pose : next.poses) {
    result.push_back(secondsBetween(robot, before, pose.pose.angles, Motion{}.speed));
    before = pose.pose.angles;
  }
  return result;
}

Json assumptions(const NextPoses& next) {
  return {
      {"jointError", next.jointError},
      {"noise", noiseJson(next.noise)},
      {"samples", next.samples},
      {"angles", "what the joints shall have: a robot adds its offsets; sent as they are, the fitted robot stands too"},
      {"boards", "lie where they lay when the last captures were taken; here seen from the first pose's sole"},
      {"collisions", "no part of the drawn robot touches another"},
      {"stance", "the robot stands anew, about where it stood"},
      {"predictedSigma", "from the captures and these poses together"}};
}

} // namespace

Json nextJson(const NextPoses& next, const Robot& robot) {
  return {{"poses", posesOf(next.poses, secondsBetweenThem(next, robot), robot)},
          {"why", next.why},
          {"growth", next.growth},
          {"assumptions", {{"jointError", next.jointError}}}};
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

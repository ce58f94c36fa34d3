#include "poses/PoseFile.hpp"

#include "captures/CaptureWords.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <set>

namespace naocal {

namespace {

using Json = nlohmann::json;

/// From one pose to another with every joint at its full speed [s].
double secondsBetween(const Robot& robot, const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
  double seconds = 0;
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    const auto i = static_cast<Eigen::Index>(joint);
    if (robot.joints[joint].maxSpeed > 0) {
      seconds = std::max(seconds, std::abs(to[i] - from[i]) / robot.joints[joint].maxSpeed);
    }
  }
  return seconds;
}

Json perJoint(const Robot& robot, const Eigen::VectorXd& values, bool whole) {
  Json result = Json::object();
  for (const std::string_view name : fingers) {
    result[std::string{name}] = 0;
  }
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    const double value = values[static_cast<Eigen::Index>(joint)];
    result[robot.joints[joint].name] = whole ? Json(std::lround(value)) : Json(value);
  }
  return result;
}

Json poseJson(const ProposedPose& proposed, std::size_t number, const Eigen::VectorXd& before, const Robot& robot) {
  const PlannedPose& pose = proposed.pose;
  std::set<std::string> boards;
  for (const Sight& sight : pose.sights) {
    boards.insert(sight.board);
  }
  return {{"id", fmt::format("{}{:02}", pose.supportFoot == SupportFoot::right ? 'R' : 'L', number)},
          {"supportFoot", supportFootWords[static_cast<std::size_t>(pose.supportFoot)]},
          {"joints", perJoint(robot, pose.angles, false)},
          {"approach", perJoint(robot, proposed.approach, true)},
          {"observes", boards},
          {"secondsToReach", secondsBetween(robot, before, pose.angles)}};
}

Json posesOf(const NextPoses& next, const Robot& robot) {
  Json result = Json::array();
  Eigen::VectorXd before = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(robot.joints.size()));
  for (const ProposedPose& pose : next.poses) {
    result.push_back(poseJson(pose, result.size(), before, robot));
    before = pose.pose.angles;
  }
  return result;
}

/// Where boards are thought to lie, seen from the first pose's sole.
Json boardsOf(const NextPoses& next) {
  Json result = Json::array();
  for (const Surroundings& here : next.around) {
    for (const Board& board : here.boards) {
      if (!next.poses.empty() && here.supportFoot == next.poses.front().pose.supportFoot) {
        const Placement& place = *board.placement;
        result.push_back({{"id", board.id}, {"placement", {{"x", place.x}, {"y", place.y}, {"yaw", place.yaw}}}});
      }
    }
  }
  return result;
}

Json assumptions(const NextPoses& next) {
  return {{"noise", {{"pixel", next.noise.pixel}, {"encoder", next.noise.encoder}, {"pose", next.noise.pose}}},
          {"samples", next.samples},
          {"angles", "sent to the motors as they stand, without compensation"},
          {"boards", "lie where they lay when the last captures were taken; here seen from the first pose's sole"},
          {"collisions", "legs and arms are not checked against each other"},
          {"stance", "the robot stands anew, about where it stood"},
          {"predictedSigma", "from the captures and these poses together"}};
}

} // namespace

Json nextJson(const NextPoses& next, const Robot& robot) {
  return {{"poses", posesOf(next, robot)}, {"why", next.why}, {"growth", next.growth}};
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

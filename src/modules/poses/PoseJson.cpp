#include "poses/PoseJson.hpp"

#include "data/CaptureSetFile.hpp"
#include "poses/PoseFile.hpp"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <set>

namespace naocal {

namespace {

nlohmann::json perJoint(const Robot& robot, const Eigen::VectorXd& values, bool whole) {
  nlohmann::json result = nlohmann::json::object();
  for (const std::string_view name : fingers) {
    result[std::string{name}] = 0;
  }
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    const double value = values[static_cast<Eigen::Index>(joint)];
    result[robot.joints[joint].name] = whole ? nlohmann::json(std::lround(value)) : nlohmann::json(value);
  }
  return result;
}

} // namespace

nlohmann::json anglesJson(const Eigen::VectorXd& angles, const Robot& robot) {
  return perJoint(robot, angles, false);
}

nlohmann::json boardsJson(const std::vector<Board>& boards) {
  nlohmann::json result = nlohmann::json::array();
  for (const Board& board : boards) {
    const Placement& place = *board.placement;
    result.push_back({{"id", board.id}, {"placement", {{"x", place.x}, {"y", place.y}, {"yaw", place.yaw}}}});
  }
  return result;
}

nlohmann::json noiseJson(const Noise& noise) {
  return {{"pixel", noise.pixel}, {"encoder", noise.encoder}, {"pose", noise.pose}};
}

nlohmann::json posesOf(const std::vector<ProposedPose>& poses, const std::vector<std::optional<double>>& seconds,
                       const Robot& robot) {
  nlohmann::json result = nlohmann::json::array();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const PlannedPose& pose = poses[i].pose;
    std::set<std::string> boards;
    for (const Sight& sight : pose.sights) {
      boards.insert(sight.board);
    }
    result.push_back({{"id", fmt::format("{}{:02}", "LRB"[static_cast<std::size_t>(pose.supportFoot)], i)},
                      {"supportFoot", supportFootWords[static_cast<std::size_t>(pose.supportFoot)]},
                      {"joints", perJoint(robot, pose.angles, false)},
                      {"approach", perJoint(robot, poses[i].approach, true)},
                      {"observes", boards}});
    if (seconds[i]) {
      result.back()["secondsToReach"] = *seconds[i];
    }
  }
  return result;
}

} // namespace naocal

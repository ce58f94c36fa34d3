#include "poses/PlanFile.hpp"

#include "data/CaptureSetFile.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "poses/PoseFile.hpp"
#include "poses/PoseJson.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sstream>

namespace naocal {

namespace {

using Json = nlohmann::json;

bool hasFingers(const Joint& wrist) {
  return wrist.name.ends_with("WristYaw");
}

std::vector<std::optional<double>> secondsOf(const PosePlan& plan) {
  std::vector<std::optional<double>> result;
  for (const auto& way : plan.ways) {
    result.push_back(way ? std::optional{way->seconds} : std::nullopt);
  }
  return result;
}

Json assumptions(const PlanOptions& options) {
  return {{"noise", noiseJson(options.noise)},
          {"samples", 1},
          {"jointError", options.poses.stability.jointError},
          {"boards",
           "placements in the frame of the sole that the robot stands on, on both feet the left one; for poses on both "
           "feet in turn that of the first pose, the other foot 0.1 m beside it"},
          {"unknowns", "joint offsets, rotations of both cameras, x, y and yaw of every board"},
          {"floor", "on both feet the right sole lies on the left one's floor to 1 mm and 0.005 rad"}};
}

Json boardsWithTolerances(const PosePlan& plan) {
  Json boards = boardsJson(plan.boards);
  for (std::size_t i = 0; i < plan.tolerances.size(); ++i) {
    boards[i]["tolerance"] = {{"shift", plan.tolerances[i].shift}, {"turn", plan.tolerances[i].turn}};
  }
  return boards;
}

/// One foot, or both in turn.
std::string_view supportOf(const PosePlan& plan) {
  const bool one = std::all_of(plan.poses.begin(), plan.poses.end(),
                               [&](const ProposedPose& each) { return each.pose.supportFoot == plan.supportFoot; });
  return supportFootWords[static_cast<std::size_t>(one ? plan.supportFoot : SupportFoot::both)];
}

Json comparisonJson(const PosePlan& plan) {
  Json result = Json::array();
  for (const CriterionResult& each : plan.comparison) {
    result.push_back({{"criterion", name(each.criterion)},
                      {"poses", each.poses},
                      {"worstSigma", each.worst},
                      {"meanSigma", each.mean},
                      {"worstSigmaKnown", each.worstKnown},
                      {"interaction", {{"cost", each.interaction.cost}, {"count", each.interaction.count}}}});
    if (each.misfit) {
      result.back()["misfit"] = *each.misfit;
    }
  }
  return result;
}

} // namespace

Json planJson(const PosePlan& plan, const Robot& robot) {
  Json poses = posesOf(plan.poses, secondsOf(plan), robot);
  for (std::size_t i = 0; i < plan.standing.size(); ++i) {
    poses[i]["standing"] = plan.standing[i];
    for (const Eigen::VectorXd& angles : plan.ways[i].value_or(PoseWay{}).via) {
      poses[i]["via"].push_back(anglesJson(angles, robot));
    }
  }
  Json result = {{"format", "naocal-poses"},
                 {"version", 1},
                 {"robot", robot.model},
                 {"support", supportOf(plan)},
                 {"candidates",
                  {{"generated", plan.sieve.generated},
                   {"reachable", plan.sieve.reachable},
                   {"collisionFree", plan.sieve.collisionFree},
                   {"stable", plan.sieve.stable},
                   {"seeing", plan.sieve.seeing}}},
                 {"poses", poses},
                 {"boards", boardsWithTolerances(plan)},
                 {"predictedSigma", plan.sigma},
                 {"predictedSigmaKnown", plan.sigmaKnown},
                 {"predictedSigmaOfRobots", plan.sigmaOfRobots},
                 {"criterion", name(plan.options.criterion)},
                 {"interaction", {{"cost", plan.interaction.cost}, {"count", plan.interaction.count}}},
                 {"assumptions", assumptions(plan.options)}};
  if (plan.misfit) {
    result["effects"] = plan.options.effects;
    result["misfit"] = *plan.misfit;
  }
  if (!plan.comparison.empty()) {
    result["comparison"] = comparisonJson(plan);
  }
  return result;
}

void writePoseFiles(const PosePlan& plan, const Robot& robot, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const Json poses = posesOf(plan.poses, secondsOf(plan), robot);
  for (std::size_t i = 0; i < plan.poses.size(); ++i) {
    std::string text;
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
      text += fmt::format("{:.17g} ", plan.poses[i].pose.angles[static_cast<Eigen::Index>(joint)]);
      text += hasFingers(robot.joints[joint]) ? "0 " : "";
    }
    text.back() = '\n';
    writeAtomically(folder / (poses[i].at("id").get<std::string>() + ".pose"), text);
  }
}

Eigen::VectorXd readAnglesFile(const std::filesystem::path& file, const Robot& robot) {
  std::istringstream text{fileContent(file)};
  std::vector<double> numbers;
  for (double number = 0; text >> number;) {
    numbers.push_back(number);
  }
  const std::size_t wanted = robot.joints.size() + fingers.size();
  if (!text.eof() || numbers.size() != wanted) {
    throw InputError{fmt::format("{}: expected {} angles in radians and nothing else, found {} before the end or "
                                 "something that is no number",
                                 file.string(), wanted, numbers.size())};
  }
  Eigen::VectorXd angles(static_cast<Eigen::Index>(robot.joints.size()));
  std::size_t next = 0;
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    angles[static_cast<Eigen::Index>(joint)] = numbers[next];
    next += hasFingers(robot.joints[joint]) ? 2 : 1;
  }
  return angles;
}

} // namespace naocal

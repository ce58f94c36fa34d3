#include "poses/PoseFile.hpp"

#include "data/BoardFile.hpp"
#include "data/CaptureSetFile.hpp"
#include "io/FileVersion.hpp"
#include "io/Files.hpp"
#include "io/Folders.hpp"
#include "io/InputError.hpp"
#include "io/JsonReader.hpp"
#include "measurements/Noise.hpp"
#include "poses/candidates/SupportLegs.hpp"
#include "poses/candidates/Transitions.hpp"
#include "poses/criteria/PlanOptions.hpp"
#include "poses/criteria/PlannedInformation.hpp"
#include "robot/LegKinematics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>

namespace naocal {

namespace {

using Json = nlohmann::json;

/// Joints of a NAO that drawings omit: hands. Files list them as 0.
constexpr std::array<std::string_view, 2> fingers{"LHand", "RHand"};

bool isFinger(const std::string& name, const Robot& robot) {
  return hasPlannableLegs(robot) && std::find(fingers.begin(), fingers.end(), name) != fingers.end();
}

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

using Json = nlohmann::json;

nlohmann::json noiseJson(const Noise& noise) {
  return {{"pixel", noise.pixel}, {"encoder", noise.encoder}, {"pose", noise.pose}};
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

Json assumptions(const CapturePlan& plan) {
  return {{"noise", noiseJson(plan.noise)},
          {"samples", 1},
          {"angles", "what the encoders read"},
          {"estimated", plan.estimated},
          {"collisions", "no part of the robot that its description shapes touches another; ways between poses are not "
                         "tested"}};
}

Json sieveJson(const PassCounts& sieve) {
  return {{"generated", sieve.generated},
          {"reachable", sieve.reachable},
          {"collisionFree", sieve.collisionFree},
          {"stable", sieve.stable},
          {"seeing", sieve.seeing}};
}

/// By name; what has no such value is left out.
Json sigmasJson(const std::vector<PlannedSigma>& sigmas, bool areKnown) {
  Json result = Json::object();
  for (const PlannedSigma& each : sigmas) {
    if (const auto sigma = areKnown ? each.known : each.sigma) {
      result[each.name] = *sigma;
    }
  }
  return result;
}

/// Board placements on the floor.
nlohmann::json boardsJson(const std::vector<Board>& boards) {
  nlohmann::json result = nlohmann::json::array();
  for (const Board& board : boards) {
    const Placement& place = *board.placement;
    result.push_back({{"id", board.id}, {"placement", {{"x", place.x}, {"y", place.y}, {"yaw", place.yaw}}}});
  }
  return result;
}

Json boardsWithTolerances(const PosePlan& plan) {
  Json boards = boardsJson(plan.boards);
  for (std::size_t i = 0; i < plan.tolerances.size(); ++i) {
    boards[i]["tolerance"] = {{"shift", plan.tolerances[i].shift}, {"turn", plan.tolerances[i].turn}};
  }
  return boards;
}

/// The support foot, or both if poses alternate.
std::string_view supportOf(const PosePlan& plan) {
  const bool one = std::all_of(plan.poses.begin(), plan.poses.end(),
                               [&](const ProposedPose& each) { return each.pose.supportFoot == plan.supportFoot; });
  return supportFootWords[static_cast<std::size_t>(one ? plan.supportFoot : SupportFoot::both)];
}

Json comparisonJson(const PosePlan& plan) {
  Json result = Json::array();
  for (const CriterionResult& each : plan.comparison) {
    result.push_back({{"criterion", toString(each.criterion)},
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

/// Assumed board placements relative to the first pose's support sole.
Json boardsOf(const NextPoses& next) {
  for (const LocalScene& here : next.around) {
    if (!next.poses.empty() && here.supportFoot == next.poses.front().pose.supportFoot) {
      return boardsJson(here.boards);
    }
  }
  return Json::array();
}

/// Times of direct transitions at the speed used on one foot; unknown for robots other than NAOs.
std::vector<std::optional<double>> secondsBetweenThem(const NextPoses& next, const Robot& robot) {
  std::vector<std::optional<double>> result;
  if (!hasPlannableLegs(robot)) {
    result.resize(next.poses.size());
    return result;
  }
  Eigen::VectorXd before = bentKneesStance(robot);
  for (const ProposedPose& pose : next.poses) {
    result.push_back(motionTime(robot, before, pose.pose.angles, TransitionOptions{}.speed));
    before = pose.pose.angles;
  }
  return result;
}

Json assumptionsOfAnyRobot(const NextPoses& next) {
  return {{"noise", noiseJson(next.noise)},
          {"samples", next.samples},
          {"angles", "what the encoders read"},
          {"places", "everything stands where it stood when the last captures were taken"},
          {"collisions", "no part of the robot that its description shapes touches another; ways between poses are not "
                         "tested"},
          {"predictedSigma", "from the captures and these poses together"}};
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

nlohmann::json perJoint(const Robot& robot, const Eigen::VectorXd& values, bool whole) {
  nlohmann::json result = nlohmann::json::object();
  for (const std::string_view name : fingers) {
    if (const std::string finger{name}; isFinger(finger, robot)) {
      result[finger] = 0;
    }
  }
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    const double value = values[static_cast<Eigen::Index>(joint)];
    result[robot.joints[joint].name] = whole ? nlohmann::json(std::lround(value)) : nlohmann::json(value);
  }
  return result;
}

/// Angles by joint name; a NAO's hands are 0.
nlohmann::json anglesJson(const Eigen::VectorXd& angles, const Robot& robot) {
  return perJoint(robot, angles, false);
}

/// The list `poses` of POSES.json; `seconds`: transition time from the previous pose, if known.
nlohmann::json poseListJson(const std::vector<ProposedPose>& poses, const std::vector<std::optional<double>>& seconds,
                            const Robot& robot) {
  nlohmann::json result = nlohmann::json::array();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const PlannedPose& pose = poses[i].pose;
    std::set<std::string> observed{pose.tracked.begin(), pose.tracked.end()};
    for (const VisibleBoard& sight : pose.sights) {
      observed.insert(sight.board);
    }
    result.push_back({{"id", poseId(poses[i], i)},
                      {"supportFoot", supportFootWords[static_cast<std::size_t>(pose.supportFoot)]},
                      {"joints", perJoint(robot, pose.angles, false)},
                      {"approach", perJoint(robot, poses[i].approach, true)},
                      {"observes", observed}});
    if (seconds[i]) {
      result.back()["secondsToReach"] = *seconds[i];
    }
  }
  return result;
}

/// Index of a joint by name; absent for hands. Refuses unknown names.
std::optional<Eigen::Index> jointOf(const std::string& name, const JsonCursor& place, const Robot& robot) {
  if (isFinger(name, robot)) {
    return std::nullopt;
  }
  const auto joint = robot.jointIndex(name);
  if (!joint) {
    place.refuse(fmt::format("a joint of the {}", robot.model), fmt::format("\"{}\"", name));
  }
  return static_cast<Eigen::Index>(*joint);
}

Eigen::VectorXd anglesFrom(const JsonCursor& joints, const Robot& robot) {
  constexpr double rounding = 1e-6; // [rad]
  Eigen::VectorXd angles = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(robot.joints.size()), std::nan(""));
  for (const auto& [name, place] : joints.members()) {
    const double angle = place.number(angleRange);
    if (const auto joint = jointOf(name, place, robot)) {
      angles[*joint] = angle;
    }
  }
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    const Joint& drawn = robot.joints[joint];
    const double angle = angles[static_cast<Eigen::Index>(joint)];
    if (std::isnan(angle)) {
      joints.refuse(fmt::format("an angle for each joint of the {}", robot.model), fmt::format("no {}", drawn.name));
    }
    const AngleRange limits = jointLimitsAt(robot, joint, angles);
    const bool isDriven = drawn.motor != joint; // its motor's limits hold
    if (!isDriven && (angle < limits.lower - rounding || angle > limits.upper + rounding)) {
      joints.at(drawn.name)
          .refuse(fmt::format("an angle from {:.4f} to {:.4f} radians, as the joint can take it", limits.lower,
                              limits.upper));
    }
    const double driven = drawn.ratio * angles[static_cast<Eigen::Index>(drawn.motor)] + drawn.shift;
    if (isDriven && std::abs(angle - driven) > rounding) {
      joints.at(drawn.name)
          .refuse(fmt::format("the angle of {}: one motor drives both", robot.joints[drawn.motor].name));
    }
  }
  return angles;
}

/// What poses of the robot stand on.
std::vector<std::string_view> supportWords(const Robot& robot) {
  std::vector<std::string_view> words = supportFootWords;
  if (hasPlannableLegs(robot)) {
    words.pop_back(); // a NAO stands
  }
  return words;
}

PlayablePose poseFrom(const JsonCursor& place, const Robot& robot) {
  PlayablePose pose;
  pose.id = place.at("id").text();
  pose.supportFoot = static_cast<SupportFoot>(place.at("supportFoot").wordIndex(supportWords(robot)));
  pose.angles = anglesFrom(place.at("joints"), robot);
  pose.approach = Eigen::VectorXd::Zero(pose.angles.size());
  if (const auto approach = place.find("approach")) {
    for (const auto& [name, direction] : approach->members()) {
      const int sign = direction.integer(-1, 1);
      if (const auto joint = jointOf(name, direction, robot)) {
        pose.approach[*joint] = sign;
      }
    }
  }
  return pose;
}

/// What proposed poses stand on.
SupportFoot supportOf(const NextPoses& next, const Robot& robot) {
  if (!hasPlannableLegs(robot)) {
    return next.poses.empty() ? SupportFoot::none : next.poses.front().pose.supportFoot;
  }
  return next.around.size() == 1 ? next.around.front().supportFoot : SupportFoot::both;
}

} // namespace

std::string poseId(const ProposedPose& pose, std::size_t index) {
  return fmt::format("{}{:02}", "LRBP"[static_cast<std::size_t>(pose.pose.supportFoot)], index);
}

Json planJson(const PosePlan& plan, const Robot& robot) {
  Json poses = poseListJson(plan.poses, secondsOf(plan), robot);
  for (std::size_t i = 0; i < plan.standing.size(); ++i) {
    poses[i]["standing"] = plan.standing[i];
    for (const Eigen::VectorXd& angles : plan.ways[i].value_or(Transition{}).via) {
      poses[i]["via"].push_back(anglesJson(angles, robot));
    }
  }
  Json result =
      withFormat("naocal-poses", {{"robot", robot.model},
                                  {"support", supportOf(plan)},
                                  {"candidates", sieveJson(plan.sieve)},
                                  {"poses", poses},
                                  {"boards", boardsWithTolerances(plan)},
                                  {"predictedSigma", plan.sigma},
                                  {"predictedSigmaKnown", plan.sigmaKnown},
                                  {"predictedSigmaOfRobots", plan.sigmaOfRobots},
                                  {"criterion", toString(plan.options.criterion)},
                                  {"interaction", {{"cost", plan.interaction.cost}, {"count", plan.interaction.count}}},
                                  {"assumptions", assumptions(plan.options)}});
  if (plan.misfit) {
    result["effects"] = plan.options.effects;
    result["misfit"] = *plan.misfit;
  }
  if (!plan.comparison.empty()) {
    result["comparison"] = comparisonJson(plan);
  }
  return result;
}

Json planJson(const CapturePlan& plan, const Robot& robot) {
  const std::vector<std::optional<double>> unknownTimes(plan.poses.size());
  const SupportFoot foot = plan.poses.front().pose.supportFoot;
  Json result = withFormat("naocal-poses", {{"robot", robot.model},
                                            {"support", supportFootWords[static_cast<std::size_t>(foot)]},
                                            {"candidates", sieveJson(plan.sieve)},
                                            {"poses", poseListJson(plan.poses, unknownTimes, robot)},
                                            {"predictedSigma", sigmasJson(plan.offsets, false)},
                                            {"predictedSigmaKnown", sigmasJson(plan.offsets, true)},
                                            {"predictedSigmaOfMounts", sigmasJson(plan.mounts, false)},
                                            {"cannotTell", Json::object()},
                                            {"criterion", toString(plan.options.criterion)},
                                            {"assumptions", assumptions(plan)}});
  for (const UntoldUnknown& untold : plan.untold) {
    result["cannotTell"][untold.name] = untold.why;
  }
  if (!plan.options.effects.empty()) {
    result["effects"] = plan.options.effects;
    result["predictedSigmaOfEffects"] = sigmasJson(plan.effects, false);
  }
  if (!plan.boards.empty()) {
    result["boards"] = boardsJson(plan.boards);
  }
  return result;
}

void writePoseFiles(const PosePlan& plan, const Robot& robot, const std::filesystem::path& folder) {
  createFolders(folder);
  const Json poses = poseListJson(plan.poses, secondsOf(plan), robot);
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
  std::istringstream text{readFile(file)};
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

Json nextPosesJson(const NextPoses& next, const Robot& robot) {
  Json result{{"poses", poseListJson(next.poses, secondsBetweenThem(next, robot), robot)},
              {"why", next.why},
              {"growth", next.growth},
              {"assumptions", {{"jointError", next.jointError}}}};
  if (!hasPlannableLegs(robot)) {
    result["whyNone"] = next.whyNone;
    result["assumptions"] = assumptionsOfAnyRobot(next);
  }
  return result;
}

Json posesJson(const NextPoses& next, const Robot& robot) {
  Json result = withFormat("naocal-poses", nextPosesJson(next, robot));
  result["robot"] = robot.model;
  result["support"] = supportFootWords[static_cast<std::size_t>(supportOf(next, robot))];
  result["candidates"] = {{"stable", next.stable}, {"seeing", next.seeing}};
  result["firstStance"] = next.firstStance;
  result["predictedSigma"] = next.predictedSigma;
  result["criterion"] = "discrimination";
  if (hasPlannableLegs(robot)) {
    result["boards"] = boardsOf(next);
    result["assumptions"] = assumptions(next);
  }
  return result;
}

PoseFile readPoseFile(const std::filesystem::path& file, const Robot& robot) {
  const nlohmann::json document = parseJson(readFile(file), file.string());
  const JsonCursor all{document, file.string()};
  requireFormat(all, "naocal-poses");
  if (all.at("robot").text() != robot.model) {
    all.at("robot").refuse(fmt::format("poses for the {}", robot.model));
  }
  PoseFile result;
  if (const auto stance = all.find("firstStance")) {
    result.firstStance = stance->integer(0, 1'000'000);
  }
  if (const auto assumptions = all.find("assumptions")) {
    if (const auto jointError = assumptions->find("jointError")) {
      result.jointError = jointError->number({0, radians(20), "rad"});
    }
  }
  if (const auto boards = all.find("boards")) {
    for (const JsonCursor& board : boards->elements()) {
      result.boards[board.at("id").text()] = readFloorPlacement(board.at("placement"));
    }
  }
  for (const JsonCursor& pose : all.at("poses").elements()) {
    result.poses.push_back(poseFrom(pose, robot));
  }
  if (result.poses.empty()) {
    all.at("poses").refuse("at least one pose", "none");
  }
  return result;
}

} // namespace naocal

#include "brain/CalibrationScript.hpp"
#include "math/Angles.hpp"
#include "robot/Balance.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <set>

namespace naocal {
namespace {

/// Feet flat, knees bent, as in PosePlayer.json.
CompensatedAngles stand() {
  CompensatedAngles angles;
  for (const std::string side : {"L", "R"}) {
    const double left = side == "L" ? 1 : -1;
    for (const auto& [joint, degrees] : std::map<const char*, double>{{"ShoulderPitch", 90},
                                                                      {"ShoulderRoll", 10 * left},
                                                                      {"ElbowRoll", -5 * left},
                                                                      {"HipPitch", -25},
                                                                      {"KneePitch", 50},
                                                                      {"AnklePitch", -25}}) {
      angles[*jointIndex(side + joint)] = radians(degrees);
    }
  }
  return angles;
}

Eigen::VectorXd drawn(const Robot& robot, const CompensatedAngles& angles) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(robot.joints.size()));
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    result[static_cast<Eigen::Index>(joint)] = angles[*jointIndex(robot.joints[joint].name)];
  }
  return result;
}

} // namespace

TEST_CASE("the shipped poses on one foot are reached safely, each from both sides, in another order every time") {
  // Proves for each model and foot that a safe path to all eight poses exists (planRound throws otherwise), that all
  // waypoints are within the joint limits, that poses are balanced on one foot, and that the second approach is
  // opposite to the first. The share of simulated robots that fall is measured elsewhere.
  for (const char* model : {"V5", "V6"}) {
    const Robot robot = loadRobot(configurationDirectory(), model);
    const PoseFile file = readPoseFile(configurationDirectory() / "poses" / (std::string{model} + ".json"), robot);
    for (const SupportFoot foot : {SupportFoot::left, SupportFoot::right}) {
      const LegRoundPlanner poses{robot, file, foot, stand()};
      const CalibrationRound round = poses.planRound({2, radians(1), 0, 1}, 3);
      REQUIRE(round.size() == 19); // onto the foot, release, 8 poses twice, back
      CHECK(round.back().points.empty());
      std::vector<std::string> order;
      for (std::size_t i = 2; i + 1 < round.size(); ++i) {
        const CalibrationStep& step = round[i];
        order.push_back(step.taken.pose);
        CHECK(step.taken.stance == 3);
        CHECK(step.taken.supportFoot == foot);
        const Eigen::VectorXd angles = drawn(robot, step.points.back());
        CHECK(isBalanced(robot, forwardKinematics(robot, angles), foot, {}));
        for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
          const auto motion = step.points.back()[*jointIndex(robot.joints[joint].name)] -
                              step.points[step.points.size() - 2][*jointIndex(robot.joints[joint].name)];
          CHECK(motion ==
                Approx(radians(1) * step.taken.joints.approach[*jointIndex(robot.joints[joint].name)]).margin(1e-9));
        }
        for (const CompensatedAngles& point : step.points) {
          const Eigen::VectorXd through = drawn(robot, point);
          for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
            const AngleRange limits = jointLimitsAt(robot, joint, through);
            CHECK(through[static_cast<Eigen::Index>(joint)] >= limits.lower);
            CHECK(through[static_cast<Eigen::Index>(joint)] <= limits.upper);
          }
        }
      }
      for (std::size_t i = 2; i + 1 < round.size(); i += 2) {
        CHECK(round[i].taken.pose == round[i + 1].taken.pose);
        for (std::size_t joint = 0; joint < jointCount; ++joint) {
          CHECK(round[i].taken.joints.approach[joint] == -round[i + 1].taken.joints.approach[joint]);
        }
      }
      CHECK(std::set<std::string>{order.begin(), order.end()}.size() == 8);
      CHECK(poses.planRound({1, radians(1), 0, 2}, 0)[2].taken.pose != order.front());
      CHECK(poses.planRound({1, radians(1), 3, 1}, 0).size() == 6);
    }
  }
}

TEST_CASE("poses without a safe way to them are refused by name") {
  // Proves the refusal of an unbalanced pose and of a foot without poses.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  PoseFile file;
  CompensatedAngles leaning = stand();
  leaning[*jointIndex("LAnkleRoll")] = radians(30);
  file.poses.push_back({"leaning", SupportFoot::left, drawn(robot, leaning), drawn(robot, CompensatedAngles{})});
  CHECK_THROWS_WITH((LegRoundPlanner{robot, file, SupportFoot::left, stand()}.planRound({1, radians(1), 0, 1}, 0)),
                    "pose leaning: there is no safe way to it from standing upright on the left foot; plan other poses "
                    "with 'naocal poses'");
  CHECK_THROWS_WITH((LegRoundPlanner{robot, file, SupportFoot::right, stand()}),
                    "expected poses on the right foot, found none");
}

TEST_CASE("a robot is held between one foot and both, and let go before its first pose") {
  // Proves the order: hold and confirm, path onto the foot, release and confirm, poses, hold and confirm, path back.
  // The round on the other foot starts without a question, as the robot is still held.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  const PoseFile file = readPoseFile(configurationDirectory() / "poses/V6.json", robot);
  const LegRoundPlanner poses{robot, file, SupportFoot::right, stand()};
  const CalibrationRound first = poses.planRound({1, radians(1), 0, 1}, 0),
                         second = poses.planRound({1, radians(1), 0, 1}, 1);
  REQUIRE(first.size() == 11);
  CHECK(first[0].question.find("take it by its trunk") != std::string::npos);
  CHECK(first[1].question.find("right sole lies flat, let go") != std::string::npos);
  CHECK(first[1].points == std::vector{first[0].points.back()});
  CHECK(first[10].question.find("take it by its trunk") != std::string::npos);
  for (std::size_t i = 0; i < first.size(); ++i) {
    CHECK(first[i].held == (i == 0 || i == 10));
    CHECK(first[i].question.empty() == (i > 1 && i < 10));
    CHECK(second[i].held == first[i].held);
    CHECK(second[i].question.empty() == (i == 0 || first[i].question.empty()));
  }
}

TEST_CASE("the head takes every pair of angles in random order, each from both sides") {
  // Proves that all pairs occur, that another seed changes the order, that the last segment has the recorded direction
  // of approach, and that a smaller share reduces the angles.
  const CompensatedAngles stand;
  const std::size_t turns = *jointIndex("HeadYaw"), nods = *jointIndex("HeadPitch");
  const auto looks = [&](const CalibrationRound& round) {
    std::vector<std::pair<double, double>> result;
    for (const CalibrationStep& step : round) {
      if (step.pictures > 0) {
        result.emplace_back(std::round(degrees(step.points.back()[turns])),
                            std::round(degrees(step.points.back()[nods])));
      }
    }
    return result;
  };
  RoundOptions options{2, radians(1), 0, 1};
  const CalibrationRound round = planHeadRound(stand, {-45, 0, 45}, {-10, 10}, 1, options);
  const auto first = looks(round);
  CHECK(first.size() == 12);
  CHECK(std::set(first.begin(), first.end()).size() == 6);
  std::map<std::string, double> sides;
  for (const CalibrationStep& step : round) {
    if (step.pictures > 0) {
      for (const std::size_t joint : {turns, nods}) {
        const double last = step.points.back()[joint] - step.points.front()[joint];
        CHECK(last == Approx(radians(1) * step.taken.joints.approach[joint]));
        sides[step.taken.pose] += step.taken.joints.approach[joint];
      }
      CHECK(step.taken.repeatKind == RepeatKind::reapproach);
    }
  }
  for (const auto& [pose, sum] : sides) {
    CHECK(sum == 0);
  }
  options.seed = 2;
  CHECK(looks(planHeadRound(stand, {-45, 0, 45}, {-10, 10}, 1, options)) != first);
  for (const auto& [turned, nodded] : looks(planHeadRound(stand, {-40, 0, 40}, {-10, 10}, 0.5, options))) {
    CHECK(std::abs(turned) <= 20);
    CHECK(std::abs(nodded) == 5);
  }
}

} // namespace naocal

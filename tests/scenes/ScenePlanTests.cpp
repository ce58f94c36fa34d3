#include "calibration/Calibration.hpp"
#include "estimation/ModelBuilder.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "poses/CapturePlan.hpp"
#include "poses/PoseFile.hpp"
#include "robot/Gravity.hpp"
#include "robot/RobotOfSet.hpp"
#include "scenes/SceneCandidates.hpp"
#include "scenes/SceneSimulation.hpp"

#include "TemporaryFolder.hpp"

#include <Eigen/Geometry>
#include <array>
#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <random>

using namespace naocal;

namespace {

using Point = Eigen::Vector3d;

constexpr double lowest = -2.4, highest = 2.1, baseRadius = 0.15, handRadius = 0.06; // [rad], [m]

struct PlannedArmStep {
  const char* joint;
  Point xyz, rpy;
};
const std::array<PlannedArmStep, 5> steps{{{"turn", {0, 0, 0.1}, {0, 0, 0.2}},
                                           {"lift", {0, 0, 0.1}, {-1.5, 0, 0}},
                                           {"elbow", {0.05, -0.3, 0}, {0, 0.1, 0.4}},
                                           {"bend", {0.3, 0, 0}, {0.1, 0, 1.2}},
                                           {"roll", {0.02, -0.1, 0.03}, {1.57, 0.2, 0}}}};

/// An arm whose joints turn about z, with a sphere at its base and one at its last link.
std::string sphericalArm(const std::string& last) {
  const auto shape = [](double radius) {
    return fmt::format("<collision><geometry><sphere radius=\"{}\"/></geometry></collision>", radius);
  };
  std::string text = "<robot name=\"arm\"><link name=\"base\">" + shape(baseRadius) + "</link>", parent = "base";
  for (const PlannedArmStep& step : steps) {
    const bool isLast = &step == &steps.back();
    const std::string link = isLast ? last : std::string{step.joint} + "_link";
    text += fmt::format("<link name=\"{}\">{}<inertial><mass value=\"1\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" "
                        "iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial></link><joint name=\"{}\" type=\"revolute\"><parent "
                        "link=\"{}\"/><child link=\"{}\"/><origin xyz=\"{} {} {}\" rpy=\"{} {} {}\"/><axis xyz=\"0 0 "
                        "1\"/><limit lower=\"{}\" upper=\"{}\" velocity=\"1\" effort=\"1\"/></joint>",
                        link, isLast ? shape(handRadius) : "", step.joint, parent, link, step.xyz.x(), step.xyz.y(),
                        step.xyz.z(), step.rpy.x(), step.rpy.y(), step.rpy.z(), lowest, highest);
    parent = link;
  }
  return text + "</robot>";
}

Eigen::Isometry3d placedAt(const Point& xyz, const Point& rpy) {
  return Eigen::Translation3d{xyz} * Eigen::AngleAxisd{rpy.z(), Point::UnitZ()} *
         Eigen::AngleAxisd{rpy.y(), Point::UnitY()} * Eigen::AngleAxisd{rpy.x(), Point::UnitX()} *
         Eigen::Isometry3d::Identity();
}

Eigen::Isometry3d placedAt(const Placement& p) {
  return placedAt({p.x, p.y, p.z}, {p.roll, p.pitch, p.yaw});
}

/// baseFromHand by the URDF's specification, written anew.
Eigen::Isometry3d baseFromHand(const Eigen::VectorXd& angles) {
  Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    moved = moved * placedAt(steps[i].xyz, steps[i].rpy) *
            Eigen::AngleAxisd{angles[static_cast<Eigen::Index>(i)], Point::UnitZ()};
  }
  return moved;
}

/// Corners of a board that lie in the picture of a pinhole; z is its optical axis.
std::size_t countInPicture(const CameraIntrinsics& lens, const Board& board,
                           const Eigen::Isometry3d& opticalFromBoard) {
  std::size_t count = 0;
  for (const Point& corner : board.points) {
    const Point at = opticalFromBoard * corner;
    const double u = lens.cx + lens.fx * at.x() / at.z(), v = lens.cy + lens.fy * at.y() / at.z();
    count += at.z() > 0 && u >= 0 && v >= 0 && u <= lens.width - 1 && v <= lens.height - 1 ? 1 : 0;
  }
  return count;
}

/// A robot in a scene.
struct Planned {
  explicit Planned(const std::string& last, const std::string& sceneJson = {}) {
    writeAtomically(folder.path() / "arm.urdf", sphericalArm(last));
    const CaptureSet robotOnly = makeRobotOnly((folder.path() / "arm.urdf").string(), SupportFoot::left);
    scene = sceneJson.empty() ? makeDefaultScene(robotOnly, 3) : parseRobotScene(sceneJson, "scene.json", robotOnly);
  }
  explicit Planned(SupportFoot foot) : scene{makeDefaultScene(makeRobotOnly("K1", foot), 1)} {}

  TemporaryFolder folder;
  RobotScene scene;
};

const char* const cameraBeside = R"({"format": "naocal-scene", "version": 1,
    "cameras": {"side": {"link": "world", "about": {"x": 1.6, "z": 0.4, "roll": -1.5708, "yaw": 1.5708}, "width": 640,
                "height": 480, "fx": 600, "fy": 600, "cx": 320, "cy": 240, "distortion": [0, 0, 0, 0, 0]}},
    "boards": [{"id": "badge", "link": "hand", "points": [[0, 0, 0], [0.03, 0, 0], [0.06, 0, 0], [0.09, 0, 0],
                [0, 0.03, 0], [0.03, 0.03, 0], [0.06, 0.03, 0.02], [0.09, 0.03, 0]], "about": {"z": 0.05}}],
    "ranges": {"turn": [-1, 1]}})";
const char* const trackerBefore = R"({"format": "naocal-scene", "version": 1,
    "trackers": {"laser": {"sigma": 0.0002, "sigmaRotation": 0.0005, "about": {"x": 2, "y": 0.3, "z": 1, "yaw": 3}}},
    "markers": [{"id": "ball", "link": "hand", "about": [0.1, 0.05, 0.02]}],
    "frames": [{"id": "tool", "link": "hand", "placement": {"z": 0.1, "roll": 0.4}}]})";

constexpr std::size_t count = 8;

/// The candidates at these places, as if no others had been drawn.
CandidateCaptures pick(const CandidateCaptures& all, const std::vector<std::size_t>& places) {
  CandidateCaptures some = all;
  some.poses.clear();
  some.set.captures.clear();
  for (const std::size_t place : places) {
    for (Capture capture : all.set.captures) {
      if (capture.pose == plannedPoseName(place)) {
        capture.pose = plannedPoseName(some.poses.size());
        some.set.captures.push_back(std::move(capture));
      }
    }
    some.poses.push_back(all.poses[place]);
  }
  return some;
}

/// The largest sigma of a plan's offsets when these candidates are taken [rad]; what they do not tell counts 0.1.
double worstSigma(const CandidateCaptures& taken, const CapturePlan& plan) {
  const CapturePlan all = planCaptures(taken, plan.options);
  double worst = 0;
  for (const PlannedSigma& offset : plan.offsets) {
    const auto found = std::find_if(all.offsets.begin(), all.offsets.end(),
                                    [&](const PlannedSigma& each) { return each.name == offset.name; });
    worst = std::max(worst, found == all.offsets.end() ? 0.1 : found->sigma);
  }
  return worst;
}

void checkBetterThanRandom(const CandidateCaptures& candidates, const CapturePlan& plan) {
  double worst = 0;
  for (const PlannedSigma& offset : plan.offsets) {
    worst = std::max(worst, offset.sigma);
  }
  std::mt19937_64 random{5};
  double sum = 0;
  constexpr int sets = 20;
  for (int i = 0; i < sets; ++i) {
    std::vector<std::size_t> places(candidates.poses.size());
    std::iota(places.begin(), places.end(), 0);
    std::shuffle(places.begin(), places.end(), random);
    places.resize(count);
    sum += worstSigma(pick(candidates, places), plan);
  }
  CAPTURE(worst, sum / sets);
  CHECK(worst < 0.8 * sum / sets);
}

std::vector<PlayablePose> playable(const CapturePlan& plan) {
  std::vector<PlayablePose> poses;
  for (const ProposedPose& pose : plan.poses) {
    poses.push_back({poseId(pose, poses.size()), pose.pose.supportFoot, pose.pose.angles, pose.approach});
  }
  return poses;
}

/// Captures at the planned poses of a robot without offsets, and what a calibration says of them.
void checkSigmasOfCalibration(const RobotScene& scene, const CapturePlan& plan) {
  const SceneSimulation simulation =
      simulateScene(scene, {.given = playable(plan), .samples = 1, .seed = 4, .robotSeed = {}, .spread = 0});
  const Measurements measurements = buildMeasurements({simulation.set}, loadRobot(simulation.set));
  CHECK(measurements.poses.size() == count);
  const Model model = buildModel(measurements, plan.options.effects);
  CalibrationOptions options;
  options.noise = plan.noise;
  options.estimateNoise = options.testMissingEffects = false;
  const CalibrationResult result = calibrate(measurements, model, options);
  for (const PlannedSigma& offset : plan.offsets) {
    const Estimate& estimate = result.estimates[model.find("jointOffset@" + offset.name)->first];
    CAPTURE(offset.name, offset.sigma, estimate.sigma, result.sigmaScale);
    CHECK(estimate.sigma / result.sigmaScale == Approx(offset.sigma).epsilon(0.1));
  }
}

/// Limits, and the spheres of base and hand apart.
void checkLimits(const CapturePlan& plan) {
  for (const ProposedPose& pose : plan.poses) {
    CHECK(pose.pose.angles.minCoeff() >= lowest);
    CHECK(pose.pose.angles.maxCoeff() <= highest);
    CHECK(baseFromHand(pose.pose.angles).translation().norm() > baseRadius + handRadius);
  }
}

std::vector<std::string> untoldNames(const CapturePlan& plan) {
  std::vector<std::string> names;
  for (const UntoldUnknown& untold : plan.untold) {
    names.push_back(untold.name);
  }
  return names;
}

std::string refusalOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was refused";
}

} // namespace

TEST_CASE("poses planned for a wrist camera see the board and tell the arm as a calibration will") {
  // Proves limits, self-collision and corners in the picture against Eigen and a pinhole written here; that the worst
  // offset is told better than by random candidates; and the predicted sigmas against a calibration of captures at the
  // planned poses with the same noise, apart from that fit's own chi2. The first joint looks like the board's unknown
  // place, and the last one turns about the optical axis, as the camera's mount may.
  const Planned arm{"camera_color_optical_frame"};
  const CandidateCaptures candidates = drawCandidates(arm.scene);
  const CapturePlan plan = planCaptures(candidates, {.count = count});
  REQUIRE(plan.poses.size() == count);
  checkLimits(plan);
  const Board& board = arm.scene.set.boards.front();
  const Eigen::Isometry3d worldFromBoard = placedAt(arm.scene.about.at("boards.plate"));
  for (const ProposedPose& pose : plan.poses) {
    const Eigen::Isometry3d opticalFromBoard = baseFromHand(pose.pose.angles).inverse() * worldFromBoard;
    CHECK(countInPicture(arm.scene.set.cameras.at("camera"), board, opticalFromBoard) >= 8);
    CHECK(pose.pose.sights.front().corners.size() >= 8);
  }
  CHECK(untoldNames(plan) == std::vector<std::string>{"turn", "roll", "cameraRotation@camera rx"});
  CHECK(plan.untold.front().why == "cannot be told from where board plate is");
  CHECK(plan.untold[1].why == "cannot be told from the camera camera's roll");
  CHECK(plan.mounts.size() == 2);
  checkBetterThanRandom(candidates, plan);
  checkSigmasOfCalibration(arm.scene, plan);
}

TEST_CASE("poses planned for a camera beside an arm show it the board on the hand") {
  // Proves the same for a camera that stands in the world, with ranges of a joint.
  const Planned arm{"hand", cameraBeside};
  const CandidateCaptures candidates = drawCandidates(arm.scene);
  const CapturePlan plan = planCaptures(candidates, {.count = count});
  REQUIRE(plan.poses.size() == count);
  checkLimits(plan);
  const Eigen::Isometry3d worldFromOptical = placedAt(arm.scene.about.at("cameras.side")),
                          handFromBoard = placedAt(arm.scene.about.at("boards.badge"));
  for (const ProposedPose& pose : plan.poses) {
    const Eigen::Isometry3d opticalFromBoard =
        worldFromOptical.inverse() * baseFromHand(pose.pose.angles) * handFromBoard;
    CHECK(countInPicture(arm.scene.set.cameras.at("side"), arm.scene.set.boards.front(), opticalFromBoard) >= 8);
    CHECK(std::abs(pose.pose.angles[0]) <= 1);
  }
  CHECK(plan.mounts.empty());
  checkBetterThanRandom(candidates, plan);
  checkSigmasOfCalibration(arm.scene, plan);
}

TEST_CASE("poses planned for a tracker hold the marker in its sight") {
  // Proves the same for points and frames, against the line of sight past the spheres.
  const Planned arm{"hand", trackerBefore};
  const CandidateCaptures candidates = drawCandidates(arm.scene);
  const CapturePlan plan = planCaptures(candidates, {.count = count});
  REQUIRE(plan.poses.size() == count);
  checkLimits(plan);
  const Point tracker{2, 0.3, 1};
  const auto passes = [&](const Point& from, const Point& to, const Point& centre, double radius) {
    const double share = std::clamp((centre - from).dot(to - from) / (to - from).squaredNorm(), 0.0, 1.0);
    return (from + share * (to - from) - centre).norm() >= radius;
  };
  for (const ProposedPose& pose : plan.poses) {
    const Eigen::Isometry3d hand = baseFromHand(pose.pose.angles);
    const auto isSeen = [&](const Point& inHand) {
      const Point at = hand * inHand;
      return passes(tracker, at, Point::Zero(), baseRadius) && passes(tracker, at, hand.translation(), handRadius);
    };
    REQUIRE_FALSE(pose.pose.tracked.empty());
    for (const std::string& name : pose.pose.tracked) {
      CHECK(isSeen(name == "ball" ? Point{0.1, 0.05, 0.02} : Point{0, 0, 0.1}));
    }
  }
  checkBetterThanRandom(candidates, plan);
  checkSigmasOfCalibration(arm.scene, plan);
}

TEST_CASE("poses planned for a K1 on one foot balance and see the boards on the floor") {
  // Proves the same for a shipped robot on its left foot, against its masses and its sole's outline; the arms and the
  // other leg are told by nothing. Its file is read again as it was written.
  const Planned k1{SupportFoot::left};
  const CandidateCaptures candidates = drawCandidates(k1.scene);
  const CapturePlan plan = planCaptures(candidates, {.count = count});
  REQUIRE(plan.poses.size() == count);
  const Robot robot = loadRobot(k1.scene.set);
  for (const ProposedPose& pose : plan.poses) {
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
      CHECK(pose.pose.angles[static_cast<Eigen::Index>(joint)] >= robot.joints[joint].limits.lower);
      CHECK(pose.pose.angles[static_cast<Eigen::Index>(joint)] <= robot.joints[joint].limits.upper);
    }
    const LinkPoses links = forwardKinematics(robot, pose.pose.angles);
    const RigidTransform soleFromTorso = links[robot.findSole("left")->link].inverse();
    const Point centre = soleFromTorso * centreOfMass(robot, links).inTorso;
    CHECK(centre.x() < 0.094);
    CHECK(centre.x() > -0.066);
    CHECK(std::abs(centre.y()) < 0.035);
    CHECK_FALSE(SelfCollision{robot}.collides(links));
    CHECK(pose.pose.supportFoot == SupportFoot::left);
    CHECK(std::any_of(pose.pose.sights.begin(), pose.pose.sights.end(),
                      [](const VisibleBoard& sight) { return sight.corners.size() >= 8; }));
  }
  CHECK(plan.offsets.size() == 8);
  CHECK(plan.untold.size() == 14);
  CHECK(plan.boards.size() == 4);
  checkBetterThanRandom(candidates, plan);
  checkSigmasOfCalibration(k1.scene, plan);

  const TemporaryFolder folder;
  const nlohmann::json written = planJson(plan, robot);
  writeAtomically(folder.path() / "poses.json", written.dump());
  const PoseFile read = readPoseFile(folder.path() / "poses.json", robot);
  REQUIRE(read.poses.size() == count);
  CHECK(read.poses.front().id == "L00");
  CHECK(read.poses.front().angles == plan.poses.front().pose.angles);
  CHECK(read.boards.size() == 4);
  CHECK(written.at("predictedSigma").size() == 8);
  CHECK(written.at("poses")[0].at("joints").size() == robot.joints.size());
  CHECK_FALSE(written.at("poses")[0].at("joints").contains("LHand"));
}

TEST_CASE("poses that are to tell an effect tell it better than poses that are not") {
  // Proves that a spring and a gear's play are targets: their sigmas after poses planned for them against those after
  // poses planned without; and that the file of an arm is read again, with the sides that it is to be approached from.
  const Planned arm{"hand", trackerBefore};
  const CandidateCaptures candidates = drawCandidates(arm.scene);
  const std::vector<std::string> effects{"elasticity@elbow", "hysteresis@lift"};
  const CapturePlan plan =
                        planCaptures(candidates, {.count = count, .criterion = Criterion::trace, .effects = effects}),
                    without = planCaptures(candidates, {.count = count, .criterion = Criterion::trace});
  std::vector<std::size_t> places;
  for (const ProposedPose& pose : without.poses) {
    const auto found = std::find_if(candidates.poses.begin(), candidates.poses.end(),
                                    [&](const ProposedPose& each) { return each.pose.angles == pose.pose.angles; });
    places.push_back(static_cast<std::size_t>(found - candidates.poses.begin()));
  }
  const CapturePlan other = planCaptures(pick(candidates, places), plan.options);
  REQUIRE(plan.effects.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(plan.effects[i].sigma < 0.9 * other.effects[i].sigma);
  }
  CHECK(plan.poses.front().approach.cwiseAbs().minCoeff() == 1);
  CHECK(without.poses.front().approach.isZero());

  const TemporaryFolder folder;
  const Robot robot = loadRobot(arm.scene.set);
  writeAtomically(folder.path() / "poses.json", planJson(plan, robot).dump());
  const PoseFile read = readPoseFile(folder.path() / "poses.json", robot);
  CHECK(read.poses.front().id == "P00");
  CHECK(read.poses.front().supportFoot == SupportFoot::none);
  CHECK(read.poses.front().approach == plan.poses.front().approach);
}

TEST_CASE("what cannot be planned is refused with a sentence") {
  // Proves the messages, and that given poses in which nothing is seen are no set.
  const Planned arm{"hand", trackerBefore};
  const CandidateCaptures candidates = drawCandidates(arm.scene, {.count = 20});
  const auto planning = [&](const CapturePlanOptions& options) {
    return refusalOf([&] { planCaptures(candidates, options); });
  };
  CHECK_THAT(planning({.count = 21}), Catch::Contains("expected 21 poses that are measured, found 20 among"));
  CHECK_THAT(planning({.count = 4, .effects = {"elasticity@elbo"}}), Catch::Contains("near it are elasticity@elbow"));
  CHECK_THAT(planning({.count = 4, .effects = {"thermalDrift@elbow"}}), Catch::Contains("no temperatures"));
  CHECK_THAT(planning({.count = 4, .criterion = Criterion::time}), Catch::Contains("expected D, A, E or worst"));
  const Planned unmeasured{"hand", R"({"format": "naocal-scene", "version": 1})"};
  CHECK_THAT(refusalOf([&] { drawCandidates(unmeasured.scene); }),
             Catch::Contains("expected a scene with cameras or trackers, found neither"));
  std::string away = cameraBeside;
  away.replace(away.find("\"yaw\": 1.5708"), 13, "\"yaw\": -1.5708");
  const Planned unseen{"hand", away};
  const std::string farAway = refusalOf([&] { drawCandidates(unseen.scene, {.draws = 300}); });
  CHECK_THAT(farAway, Catch::Contains("in none of 300 poses that were drawn a camera sees eight corners of a board"));
  PlayablePose pose{"P00", SupportFoot::none, Eigen::VectorXd::Zero(5), Eigen::VectorXd::Zero(5)};
  CHECK_THAT(refusalOf([&] { simulateScene(unseen.scene, {.given = {pose}, .robotSeed = {}}); }),
             Catch::Contains("in none of the 1 given poses a camera sees"));
}

#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "math/LinearAlgebra.hpp"
#include "robot/Gravity.hpp"
#include "robot/RobotOfSet.hpp"
#include "scenes/ScenePoses.hpp"
#include "scenes/SceneSimulation.hpp"

#include "TemporaryFolder.hpp"

#include <Eigen/Geometry>
#include <array>
#include <catch2/catch.hpp>
#include <fmt/format.h>

using namespace naocal;

namespace {

using Vector = Eigen::Vector3d;

/// Steps of an arm with a camera on its wrist; every joint turns.
struct ArmStep {
  const char* joint;
  Vector xyz, rpy, axis;
  double mass; // of the link after it, whose centre is 0.1 m along z
};
const std::array<ArmStep, 5> armSteps{{{"turn", {0, 0, 0.1}, {0, 0, 0.2}, {0, 0, 1}, 2},
                                       {"lift", {0, 0, 0.1}, {-1.5, 0, 0}, {0, 0, 1}, 1.5},
                                       {"elbow", {0.05, -0.3, 0}, {0, 0.1, 0.4}, {0, 0, 1}, 1},
                                       {"bend", {0.3, 0, 0}, {0.1, 0, 1.2}, {0, 0, 1}, 0.5},
                                       {"roll", {0, -0.1, 0}, {1.57, 0.2, 0}, {0, 0.6, 0.8}, 0.2}}};

std::string numbers(const Vector& v) {
  return fmt::format("{} {} {}", v.x(), v.y(), v.z());
}

/// The arm; `wrist`: the name of its last link.
std::string armUrdf(const std::string& wrist) {
  std::string text = "<robot name=\"arm\"><link name=\"base\"/>", parent = "base";
  for (const ArmStep& part : armSteps) {
    const std::string link = &part == &armSteps.back() ? wrist : std::string{part.joint} + "_link";
    text += fmt::format("<link name=\"{}\"><inertial><origin xyz=\"0 0 0.1\"/><mass value=\"{}\"/><inertia ixx=\"1\" "
                        "ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial></link>",
                        link, part.mass);
    text += fmt::format("<joint name=\"{}\" type=\"revolute\"><parent link=\"{}\"/><child link=\"{}\"/><origin "
                        "xyz=\"{}\" rpy=\"{}\"/><axis xyz=\"{}\"/><limit lower=\"-2.5\" upper=\"2\" velocity=\"1\" "
                        "effort=\"1\"/></joint>",
                        part.joint, parent, link, numbers(part.xyz), numbers(part.rpy), numbers(part.axis));
    parent = link;
  }
  return text + "</robot>";
}

/// A folder with an arm, and its scene.
struct Arm {
  explicit Arm(const std::string& wrist) { writeAtomically(folder.path() / "arm.urdf", armUrdf(wrist)); }
  std::string urdf() const { return (folder.path() / "arm.urdf").string(); }
  CaptureSet robot() const { return makeRobotOnly(urdf(), SupportFoot::left); }
  RobotScene scene(const std::string& json) const {
    writeAtomically(folder.path() / "scene.json", json);
    return readRobotScene(folder.path() / "scene.json", robot());
  }
  RobotScene trackedScene() const {
    return scene(R"({"format": "naocal-scene", "version": 1,
      "trackers": {"laser": {"sigma": 0.0002, "about": {"x": 2, "y": 0.3, "z": 1, "yaw": 3}}},
      "markers": [{"id": "ball", "link": "hand", "about": [0.1, 0.05, 0.02]}],
      "frames": [{"id": "tool", "link": "hand", "placement": {"z": 0.1, "roll": 0.4}}]})");
  }
  TemporaryFolder folder;
};

Eigen::Isometry3d isometry(const Vector& xyz, const Vector& rpy) {
  return Eigen::Translation3d{xyz} * Eigen::AngleAxisd{rpy.z(), Vector::UnitZ()} *
         Eigen::AngleAxisd{rpy.y(), Vector::UnitY()} * Eigen::AngleAxisd{rpy.x(), Vector::UnitX()} *
         Eigen::Isometry3d::Identity();
}

Eigen::Isometry3d turnsInOrder(double x, double y, double z) {
  return Eigen::AngleAxisd{x, Vector::UnitX()} * Eigen::AngleAxisd{y, Vector::UnitY()} *
         Eigen::AngleAxisd{z, Vector::UnitZ()} * Eigen::Isometry3d::Identity();
}

/// baseFromWrist by the true unknowns of offsets and link geometry: the URDF's specification, written anew.
Eigen::Isometry3d baseFromWrist(const std::vector<double>& measured, const Truth& truth) {
  Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
  for (std::size_t i = 0; i < armSteps.size(); ++i) {
    const auto geometry = [&](const char* unknown) {
      return truth.value("linkGeometry", armSteps[i].joint, unknown).value_or(0);
    };
    moved =
        moved * isometry(armSteps[i].xyz, armSteps[i].rpy) *
        Eigen::Translation3d{geometry("x"), geometry("y"), geometry("z")} *
        turnsInOrder(geometry("rx"), geometry("ry"), geometry("rz")) *
        Eigen::AngleAxisd{measured[i] - truth.value("jointOffset", armSteps[i].joint, "o").value(), armSteps[i].axis};
  }
  return moved;
}

Eigen::Isometry3d placed(const Truth& truth, const char* list, const char* id) {
  const Placement p = truth.scene->placements.at(list).at(id);
  return isometry({p.x, p.y, p.z}, {p.roll, p.pitch, p.yaw});
}

ScenePlan plan(std::vector<std::string> flaws = {}) {
  return {.poses = 6, .samples = 1, .offsetRange = 0.1, .mountRange = 0.03, .flaws = std::move(flaws)};
}

void silence(RobotScene& scene) {
  scene.noise = {.pixel = 0, .encoder = 0, .pose = 0, .tracker = 0, .trackerRotation = 0};
}

double angleOf(const CaptureSet& set, const Capture& capture, const std::string& joint) {
  const auto at = std::find(set.jointNames.begin(), set.jointNames.end(), joint) - set.jointNames.begin();
  return capture.joints.measured[static_cast<std::size_t>(at)];
}

} // namespace

TEST_CASE("corners of a simulated wrist camera are where the true arm puts them") {
  // Proves offsets, the camera's true rotation, the board's true placement and the projection, without noise, against
  // Eigen's transforms and a pinhole written here. The scene is the default one of a URDF with an optical frame.
  const Arm arm{"camera_color_optical_frame"};
  RobotScene scene = makeDefaultScene(arm.robot(), 3);
  silence(scene);
  const SceneSimulation simulation = simulateScene(scene, plan());
  const CameraIntrinsics& lens = simulation.set.cameras.at("camera");
  const auto turn = [&](const char* unknown) {
    return simulation.truth.value("cameraRotation", "camera", unknown).value();
  };
  Eigen::Isometry3d opticalFromForward = Eigen::Isometry3d::Identity();
  opticalFromForward.linear() << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  std::size_t corners = 0;
  for (const Capture& capture : simulation.set.captures) {
    const Eigen::Isometry3d worldFromCamera = baseFromWrist(capture.joints.measured, simulation.truth) *
                                              opticalFromForward * turnsInOrder(turn("rx"), turn("ry"), turn("rz"));
    const Eigen::Isometry3d cameraFromBoard = worldFromCamera.inverse() * placed(simulation.truth, "boards", "plate");
    for (const BoardCorners& board : *capture.corners) {
      for (std::size_t i = 0; i < board.ids.size(); ++i) {
        const Vector point =
            cameraFromBoard * simulation.set.boards.front().points[static_cast<std::size_t>(board.ids[i])];
        CHECK(board.uv[i].x() == Approx(lens.cx - lens.fx * point.y() / point.x()).margin(1e-6));
        CHECK(board.uv[i].y() == Approx(lens.cy - lens.fy * point.z() / point.x()).margin(1e-6));
        ++corners;
      }
    }
  }
  CHECK(corners >= 6 * 8);
}

TEST_CASE("a simulated tracker reads where the true arm puts markers and frames") {
  // Proves points and frames, the tracker's scale and a link drawn wrongly, without noise, against Eigen's transforms.
  const Arm arm{"hand"};
  RobotScene scene = arm.trackedScene();
  silence(scene);
  scene.set.instruments.trackers.front().sigma = 0;
  const SceneSimulation simulation = simulateScene(scene, plan({"linkGeometry@elbow", "trackerScale@laser.s"}));
  const Truth& truth = simulation.truth;
  const double scale = 1 + truth.value("trackerScale", "laser", "s").value();
  CHECK(std::abs(scale - 1) == Approx(0.002));
  CHECK(std::abs(truth.value("linkGeometry", "elbow", "x").value()) == Approx(0.005));
  CHECK(std::abs(truth.value("linkGeometry", "elbow", "ry").value()) == Approx(0.02));
  REQUIRE(simulation.set.captures.size() == 6);
  for (const Capture& capture : simulation.set.captures) {
    const Eigen::Isometry3d trackerFromHand =
        placed(truth, "trackers", "laser").inverse() * baseFromWrist(capture.joints.measured, truth);
    CHECK((capture.points.front().xyz - scale * (trackerFromHand * truth.scene->markers.at("ball"))).norm() < 1e-9);
    const Eigen::Isometry3d tool = trackerFromHand * placed(truth, "frames", "tool");
    CHECK((capture.frames.front().xyz - scale * tool.translation()).norm() < 1e-9);
    CHECK((capture.frames.front().rotation.toRotationMatrix() - tool.linear()).norm() < 1e-9);
  }
  CHECK_FALSE(simulation.set.instruments.trackers.front().placement); // the set does not tell
  CHECK(simulation.set.instruments.frames.front().placement);         // the scene gives it
}

TEST_CASE("the same seed gives the same scene and another one another") {
  // Proves it for readings and truth; the robot of another seed keeps its errors and takes other poses.
  const Arm arm{"hand"};
  const RobotScene scene = arm.trackedScene();
  const auto simulate = [&](std::uint64_t seed, std::optional<std::uint64_t> robotSeed = {}) {
    ScenePlan seeded = plan();
    seeded.seed = seed;
    seeded.robotSeed = robotSeed;
    return simulateScene(scene, seeded);
  };
  const SceneSimulation one = simulate(1), again = simulate(1), other = simulate(2), sameRobot = simulate(2, 1);
  CHECK(formatTruth(one.truth) == formatTruth(again.truth));
  CHECK(one.set.captures.back().points.front().xyz == again.set.captures.back().points.front().xyz);
  CHECK(one.set.captures.back().points.front().xyz != other.set.captures.back().points.front().xyz);
  CHECK(one.truth.value("jointOffset", "lift", "o") != other.truth.value("jointOffset", "lift", "o"));
  CHECK(one.truth.value("jointOffset", "lift", "o") == sameRobot.truth.value("jointOffset", "lift", "o"));
  CHECK(one.set.captures.back().joints.measured != sameRobot.set.captures.back().joints.measured);
}

TEST_CASE("poses of a scene are within its ranges") {
  // Proves ranges of joints and that a camera beside the robot sees a board on the hand in every pose.
  const Arm arm{"hand"};
  RobotScene scene = arm.scene(R"({"format": "naocal-scene", "version": 1,
      "cameras": {"side": {"link": "world", "about": {"x": 1.6, "z": 0.4, "roll": -1.5708, "yaw": 1.5708}, "width": 640,
                  "height": 480, "fx": 600, "fy": 600, "cx": 320, "cy": 240, "distortion": [0, 0, 0, 0, 0]}},
      "boards": [{"id": "badge", "link": "hand", "points": [[0, 0, 0], [0.03, 0, 0], [0.06, 0, 0], [0.09, 0, 0],
                  [0, 0.03, 0], [0.03, 0.03, 0], [0.06, 0.03, 0], [0.09, 0.03, 0]], "about": {"z": 0.05}}],
      "ranges": {"turn": [-0.5, 0.5], "elbow": [0.2, 9]}, "noise": {"encoder": 0}})");
  ScenePlan still = plan();
  still.offsetRange = 0;
  const SceneSimulation simulation = simulateScene(scene, still);
  for (const Capture& capture : simulation.set.captures) {
    CHECK(std::abs(angleOf(simulation.set, capture, "turn")) <= 0.5);
    CHECK(angleOf(simulation.set, capture, "elbow") >= 0.2);
    CHECK(angleOf(simulation.set, capture, "elbow") <= 2);
    REQUIRE(capture.corners->size() == 1);
    CHECK(capture.corners->front().ids.size() == 8);
  }
}

TEST_CASE("springs of a scene give way by 0.02 rad at most unless they are scaled") {
  // Proves the size of a flaw that loads drive: of the true spring times the largest torque in many poses.
  const Arm arm{"hand"};
  const RobotScene scene = arm.trackedScene();
  const double c = simulateScene(scene, plan({"elasticity@lift"})).truth.value("elasticity", "lift", "c").value();
  const Robot robot = loadRobot(arm.robot());
  ScenePoses poses{robot, scene, 7};
  double largest = 0;
  for (int i = 0; i < 200; ++i) {
    if (const auto angles = poses.draw()) {
      ModelState state = nominalState(robot, StateLayout{robot.joints.size(), 0, 0});
      state.values.head(angles->size()) = *angles;
      const LinkPoses links = forwardKinematics(robot, state);
      largest = std::max(largest, std::abs(gravityTorques(robot, state, links, 0, Vector::UnitZ())[1]));
    }
  }
  CHECK(c > 0);
  CHECK(c * largest == Approx(0.02).epsilon(0.3));
  ScenePlan large = plan({"elasticity@lift"});
  large.flawScale = 3;
  CHECK(simulateScene(scene, large).truth.value("elasticity", "lift", "c").value() == Approx(3 * c));
}

TEST_CASE("a robot that leaves a pose and comes back has a new scatter and one that rests has not") {
  // Proves what repeats share, by readings without noise: of rest everything, of a new approach the pose's scatter
  // alone. Every approach takes the time of a pose.
  const Arm arm{"hand"};
  RobotScene scene = arm.trackedScene();
  silence(scene);
  scene.set.instruments.trackers.front().sigma = scene.set.instruments.trackers.front().sigmaRotation = 1e-9;
  scene.noise.approach = 0.002;
  ScenePlan twice = plan();
  twice.samples = 2;
  const auto shiftBetween = [](const CaptureSet& set) {
    REQUIRE(set.captures.size() == 12);
    CHECK(set.captures[0].pose == set.captures[1].pose);
    CHECK(set.captures[1].repeat == 1);
    CHECK(set.captures[0].joints.measured == set.captures[1].joints.measured);
    return (set.captures[1].points.front().xyz - set.captures[0].points.front().xyz).norm();
  };
  const CaptureSet rested = simulateScene(scene, twice).set;
  CHECK(rested.captures[1].repeatKind == RepeatKind::rest);
  CHECK(shiftBetween(rested) < 1e-7);
  twice.repeatKind = RepeatKind::reapproach;
  const CaptureSet approached = simulateScene(scene, twice).set;
  CHECK(approached.captures[1].repeatKind == RepeatKind::reapproach);
  CHECK(shiftBetween(approached) > 1e-5);
  CHECK((approached.captures[1].time - approached.captures[0].time).count() == Approx(10));
  scene.noise.approach = 0;
  scene.noise.pose = 0.002;
  CHECK(shiftBetween(simulateScene(scene, twice).set) < 1e-7);
}

TEST_CASE("a joint that turns the other way is recorded with the other sign") {
  // Proves reversedJoint and countSlip against the same robot without them: nothing else differs.
  const Arm arm{"hand"};
  RobotScene scene = arm.trackedScene();
  scene.set.slipSteps["bend"] = 0.3;
  const SceneSimulation right = simulateScene(scene, plan()),
                        wrong = simulateScene(scene, plan({"reversedJoint@elbow", "countSlip@bend"}));
  REQUIRE(right.set.captures.size() == wrong.set.captures.size());
  for (std::size_t i = 0; i < right.set.captures.size(); ++i) {
    const auto &before = right.set.captures[i], &after = wrong.set.captures[i];
    CHECK(angleOf(wrong.set, after, "elbow") == -angleOf(right.set, before, "elbow"));
    CHECK(angleOf(wrong.set, after, "bend") == Approx(angleOf(right.set, before, "bend") + 0.3));
    CHECK(angleOf(wrong.set, after, "lift") == angleOf(right.set, before, "lift"));
    CHECK(after.points.front().xyz == before.points.front().xyz);
  }
  CHECK(wrong.truth.effects.back().effect == "countSlip");
}

TEST_CASE("what a scene cannot have is refused with a sentence") {
  // Proves places of messages; the readers of sets, which read the scene's lists, are tested with them.
  const Arm arm{"hand"};
  const auto refusal = [&](const std::string& json) {
    try {
      arm.scene(json);
    } catch (const InputError& error) {
      return std::string{error.what()};
    }
    return std::string{"nothing was refused"};
  };
  const std::string begin = R"({"format": "naocal-scene", "version": 1, )";
  CHECK_THAT(refusal(begin + R"("trackers": {"laser": {}}})"),
             Catch::Contains("scene.json: trackers: expected of \"laser\" a placement") && Catch::Contains("about"));
  CHECK_THAT(refusal(begin + R"("ranges": {"knee": [0, 1]}})"), Catch::Contains("ranges.knee: expected a range of a"));
  CHECK_THAT(refusal(begin + R"("ranges": {"lift": [1, 0]}})"), Catch::Contains("not above the highest"));
  CHECK_THAT(refusal(begin + R"("noise": {"pixels": 1}})"), Catch::Contains("noise.pixels: expected one of the noise"));
  CHECK_THAT(refusal(begin + R"("captures": []})"), Catch::Contains("captures: expected no `captures`"));
  CHECK_THAT(refusal(begin + R"("markers": [{"id": "ball", "link": "hand"}], "places": [{"id": "a"}]})"),
             Catch::Contains("scene.json: places: expected of \"a\" a point") && Catch::Contains("about"));
  CHECK_THAT(refusal(begin + R"("places": [{"id": "a", "about": [0.1, 0, 0]}]})"),
             Catch::Contains("places: expected `markers` on the robot that touch them"));
  CHECK_THAT(refusal(R"({"format": "naocal-captures", "version": 1})"), Catch::Contains("naocal-scene"));
  const RobotScene scene = arm.trackedScene();
  const auto flawed = [&](const std::string& flaw) { return simulateScene(scene, plan({flaw})); };
  ScenePlan anew = plan();
  anew.repeatKind = RepeatKind::restand;
  CHECK_THROWS_WITH(simulateScene(scene, anew), Catch::Contains("expected rest or reapproach, found restand"));
  CHECK_THROWS_WITH(flawed("elasticity@elbo"), Catch::Contains("near it are elasticity@elbow"));
  CHECK_THROWS_WITH(flawed("reversedJoint@elbo"), Catch::Contains("near it are elbow"));
  CHECK_THROWS_WITH(flawed("countSlip@elbow"), Catch::Contains("slipSteps.elbow"));
  CHECK_THROWS_WITH(flawed("thermalDrift@elbow"), Catch::Contains("no temperatures were recorded"));
  CHECK_THROWS_WITH(simulateScene(arm.scene(begin + R"("trackers": {}})"), plan()), Catch::Contains("found neither"));
}

TEST_CASE("a shipped robot on one foot balances and keeps all but its sole above the floor") {
  // Proves it for the Booster K1's true joints on either foot, against its masses and its sole's outline.
  for (const auto& [foot, side] : {std::pair{SupportFoot::left, "left"}, std::pair{SupportFoot::right, "right"}}) {
    const RobotScene scene = makeDefaultScene(makeRobotOnly("K1", foot), 1);
    const Robot robot = loadRobot(scene.set);
    ScenePoses poses{robot, scene, 1};
    int drawn = 0;
    for (int i = 0; i < 500; ++i) {
      if (const auto angles = poses.draw()) {
        ++drawn;
        const LinkPoses links = forwardKinematics(robot, *angles);
        const RigidTransform soleFromTorso = links[robot.findSole(side)->link].inverse();
        const Vector centre = soleFromTorso * centreOfMass(robot, links).inTorso;
        CHECK(centre.x() < 0.094);
        CHECK(centre.x() > -0.066);
        CHECK(std::abs(centre.y()) < 0.035);
        for (const RigidTransform& link : links) {
          CHECK((soleFromTorso * link.translation).z() > -1e-9);
        }
      }
    }
    CHECK(drawn > 20);
    const SceneSimulation simulation = simulateScene(scene, plan());
    CHECK(simulation.set.stances.front().supportFoot == foot);
    CHECK(simulation.set.version == 1);
    CHECK(simulation.shapedLinks == 13);
  }
}

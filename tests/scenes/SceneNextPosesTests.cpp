#include "data/CaptureSetFile.hpp"
#include "estimation/ModelBuilder.hpp"
#include "io/Files.hpp"
#include "poses/criteria/Discrimination.hpp"
#include "robot/RobotOfSet.hpp"
#include "scenes/SceneNextPoses.hpp"
#include "scenes/SceneSimulation.hpp"

#include "MeasuredArm.hpp"
#include "TemporaryFolder.hpp"

#include <catch2/catch.hpp>

using namespace naocal;

namespace {

/// An arm before a tracker, and captures of it in the same places.
struct TrackedArm {
  TrackedArm() {
    writeAtomically(folder.path() / "arm.urdf", measuredArmUrdf);
    scene = parseRobotScene(R"({"format": "naocal-scene", "version": 1,
        "trackers": {"laser": {"sigma": 0.0002, "about": {"x": 2, "y": 0.3, "z": 1, "yaw": 3}}},
        "markers": [{"id": "ball", "link": "hand", "about": [0.1, 0.05, 0.02]}],
        "ranges": {"turn": [-0.5, 0.5], "lift": [-0.3, 0.3]}})",
                            "scene.json", makeRobotOnly((folder.path() / "arm.urdf").string(), SupportFoot::left));
  }
  CaptureSet captures(std::vector<PlayablePose> given, std::uint64_t seed) const {
    return simulateScene(scene, {.poses = 8,
                                 .given = std::move(given),
                                 .samples = 1,
                                 .offsetRange = 0.05,
                                 .seed = seed,
                                 .robotSeed = 1,
                                 .sceneSeed = 1})
        .set;
  }
  TemporaryFolder folder;
  RobotScene scene;
};

/// Whether a spring of the joint "lift" is there.
ModelAmbiguity askForSpring() {
  const Eigen::VectorXd size = Eigen::VectorXd::Constant(1, 0.0005); // [rad/Nm]
  return {{{"elasticity@lift", size, size, 1}}, false, {}, {}, allEffects(), "shows whether a spring is there"};
}

Eigen::VectorXd misfitsOf(const std::vector<CaptureSet>& sets, const Noise& noise) {
  const Measurements measurements = buildMeasurements(sets, loadRobot(sets.front()), true);
  const Model own = buildModel(measurements);
  const CalibrationResult fit = calibrate(measurements, own, {.testMissingEffects = false});
  const ModelAmbiguity question = askForSpring();
  const Model model = addHypotheses(measurements, own, question);
  const PlannedInformation information =
      linearizePlans(measurements, model, noise, mapParameters(own, fit.unknowns, model), 0);
  return Discrimination{question, static_cast<Eigen::Index>(own.unknownCount())}.misfits(information.known);
}

} // namespace

TEST_CASE("poses proposed for an arm before a tracker resolve a question by as much as they promise") {
  // Proves that captures at the proposed poses hold the promised evidence, more than as many random ones; that they are
  // in the widened ranges of the set; and that they are reproducible.
  const TrackedArm arm;
  const CaptureSet before = arm.captures({}, 1);
  const Measurements measurements = buildMeasurements({before}, loadRobot(before));
  const Model model = buildModel(measurements);
  CalibrationOptions options;
  options.testMissingEffects = false;
  const CalibrationResult fit = calibrate(measurements, model, options);
  const FittedModel fitted{measurements, model, fit};
  const NextPoses next = proposeSceneNextPoses(fitted, askForSpring()),
                  again = proposeSceneNextPoses(fitted, askForSpring());
  REQUIRE(next.poses.size() == 4);
  CHECK(next.whyNone.empty());
  CHECK(next.firstStance == 0);
  std::vector<PlayablePose> given;
  for (std::size_t i = 0; i < next.poses.size(); ++i) {
    const ProposedPose& pose = next.poses[i];
    CHECK(pose.pose.angles == again.poses[i].pose.angles);
    CHECK(pose.pose.tracked == std::vector<std::string>{"ball"});
    CHECK(std::abs(pose.pose.angles[0]) < 0.5 + 0.5 + 0.1); // the set's span, half of it, an offset
    CHECK(std::abs(pose.pose.angles[1]) < 0.3 + 0.3 + 0.1);
    given.push_back({"N" + std::to_string(i), SupportFoot::none, pose.pose.angles, pose.approach});
  }
  const Eigen::VectorXd told = misfitsOf({before}, fit.noise);
  const ModelAmbiguity question = askForSpring();
  const Discrimination discrimination{question, 0};
  const double proposed = discrimination.growthFactor(told, misfitsOf({before, arm.captures(given, 2)}, fit.noise));
  CaptureSet fewer = arm.captures({}, 3);
  std::erase_if(fewer.captures, [](const Capture& capture) { return capture.pose > "P03"; });
  const double random = discrimination.growthFactor(told, misfitsOf({before, fewer}, fit.noise));
  CAPTURE(next.growth, proposed, random);
  CHECK(next.growth == Approx(proposed).epsilon(0.15));
  CHECK(proposed - 1 > 1.5 * (random - 1));
}

TEST_CASE("no poses are proposed where only touches measured an arm") {
  // Proves the reason that people read; the other reasons are those of NAOs.
  const TemporaryFolder folder;
  writeArmSet(folder.path(), {.points = false, .frames = false});
  const CaptureSet set = readCaptureSet(folder.path()).set;
  const Measurements measurements = buildMeasurements({set}, loadRobot(set));
  const Model model = buildModel(measurements);
  const CalibrationResult fit = calibrate(measurements, model, {.testMissingEffects = false});
  const NextPoses next = proposeSceneNextPoses({measurements, model, fit}, askForSpring());
  CHECK(next.poses.empty());
  CHECK(next.whyNone ==
        "neither a camera nor a tracker measured the robot in the last set, and touches are not planned");
}

TEST_CASE("where proposing poses is refused, the reason stands in their place") {
  // Proves it for a model that cannot be built: callers show the diagnosis all the same.
  const TemporaryFolder folder;
  writeArmSet(folder.path());
  const CaptureSet set = readCaptureSet(folder.path()).set;
  const Measurements measurements = buildMeasurements({set}, loadRobot(set));
  Diagnosis diagnosis;
  diagnosis.with = {"softness@lift"};
  const NextPoses next = proposeSceneNextPoses(measurements, diagnosis, {});
  CHECK(next.poses.empty());
  CHECK_THAT(next.whyNone, Catch::Contains("softness"));
}

TEST_CASE("poses proposed for a K1 on one foot show it the boards of its set from a new stance", "[slow]") {
  // Proves it for a shipped robot, whose world is its first board: every pose sees a board of the set, none is beyond
  // what the encoders can read, and the stance is a new one.
  const RobotScene scene = makeDefaultScene(makeRobotOnly("K1", SupportFoot::left), 2);
  const CaptureSet set =
      simulateScene(scene, {.poses = 6, .samples = 1, .offsetRange = 0.1, .seed = 2, .robotSeed = {}}).set;
  const Robot robot = loadRobot(set);
  const Measurements measurements = buildMeasurements({set}, robot);
  const Model model = buildModel(measurements);
  const CalibrationResult fit = calibrate(measurements, model, {.testMissingEffects = false});
  const Eigen::VectorXd size = Eigen::VectorXd::Constant(1, 0.01); // [m]
  const ModelAmbiguity question{{{"linkLength@shank", size, size, 1}}, false, {}, {}, allEffects(), "shows it"};
  const NextPoses next = proposeSceneNextPoses({measurements, model, fit}, question);
  REQUIRE(next.poses.size() == 4);
  CHECK(next.firstStance == 1);
  CHECK(next.growth > 1.5);
  CHECK(next.predictedSigma.size() == 8);
  for (const ProposedPose& pose : next.poses) {
    CHECK(pose.pose.supportFoot == SupportFoot::left);
    CHECK(std::any_of(pose.pose.sights.begin(), pose.pose.sights.end(),
                      [](const VisibleBoard& sight) { return sight.corners.size() >= 8; }));
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
      CHECK(pose.pose.angles[static_cast<Eigen::Index>(joint)] <= robot.joints[joint].limits.upper);
      CHECK(pose.pose.angles[static_cast<Eigen::Index>(joint)] >= robot.joints[joint].limits.lower);
    }
  }
}

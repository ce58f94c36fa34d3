#include "calibration/Fit.hpp"
#include "calibration/ReadingErrors.hpp"
#include "calibration/result/CalibrationResult.hpp"
#include "diagnosis/Diagnosis.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "math/LinearAlgebra.hpp"
#include "robot/RobotOfSet.hpp"
#include "scenes/SceneSimulation.hpp"

#include "TemporaryFolder.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <map>
#include <set>

using namespace naocal;

namespace {

/// A joint of an arm that touches places, and the mass of the link after it, whose centre is 0.1 m along x.
struct TouchingStep {
  const char* joint;
  Eigen::Vector3d xyz, axis;
  double mass;
};
const std::array<TouchingStep, 6> touchingSteps{{{"turn", {0, 0, 0.1}, {0, 0, 1}, 3},
                                                 {"lift", {0, 0.03, 0.2}, {0, 1, 0}, 2},
                                                 {"elbow", {0.35, 0, 0}, {0, 1, 0}, 1},
                                                 {"twist", {0.15, 0.02, 0}, {1, 0, 0}, 0.6},
                                                 {"bend", {0.15, 0, 0}, {0, 1, 0}, 0.4},
                                                 {"hand_turn", {0.08, 0, 0}, {1, 0, 0}, 0.3}}};

std::string touchingArmUrdf() {
  const auto list = [](const Eigen::Vector3d& v) { return fmt::format("{} {} {}", v.x(), v.y(), v.z()); };
  std::string text = "<robot name=\"arm\"><link name=\"base\"/>", parent = "base";
  for (const TouchingStep& step : touchingSteps) {
    const std::string link = &step == &touchingSteps.back() ? "hand" : std::string{step.joint} + "_link";
    text += fmt::format("<link name=\"{}\"><inertial><origin xyz=\"0.1 0 0\"/><mass value=\"{}\"/><inertia ixx=\"1\" "
                        "ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial></link><joint name=\"{}\" "
                        "type=\"revolute\"><parent link=\"{}\"/><child link=\"{}\"/><origin xyz=\"{}\"/><axis "
                        "xyz=\"{}\"/><limit lower=\"-2.2\" upper=\"2.2\" velocity=\"1\" effort=\"1\"/></joint>",
                        link, step.mass, step.joint, parent, link, list(step.xyz), list(step.axis));
    parent = link;
  }
  return text + "</robot>";
}

/// A known marker on the hand, which is not on the last axis.
constexpr char touchingMarker[] =
    R"("markers": [{"id": "ball", "link": "hand", "point": [0.05, 0.04, 0.03]}], "contactSigma": 0.0002, )";

/// Three known places.
constexpr char knownPlaces[] = R"("places": [{"id": "a", "point": [0.4, 0.1, 0.2]},
  {"id": "b", "point": [0.2, -0.35, 0.3]}, {"id": "c", "point": [0.3, 0.2, 0.5]}])";

/// Three places that the set does not tell, and the distances between them.
constexpr char measuredPlaces[] = R"("places": [{"id": "a", "about": [0.4, 0.1, 0.2]},
  {"id": "b", "about": [0.2, -0.35, 0.3]}, {"id": "c", "about": [0.3, 0.2, 0.5]}],
  "distances": [{"between": ["a", "b"], "sigma": 0.00002}, {"between": ["b", "c"], "sigma": 0.00002},
                {"between": ["c", "a"], "sigma": 0.00002}])";

/// An arm in a folder, in a scene with places.
struct TouchingArm {
  explicit TouchingArm(const std::string& further) {
    writeAtomically(folder.path() / "arm.urdf", touchingArmUrdf());
    scene = parseRobotScene(fmt::format(R"({{"format": "naocal-scene", "version": 1, {}{}}})", touchingMarker, further),
                            "scene.json", makeRobotOnly((folder.path() / "arm.urdf").string(), SupportFoot::left));
  }
  SceneSimulation simulate(ScenePlan plan) const {
    plan.offsetRange = 0.03;
    return simulateScene(scene, plan);
  }
  TemporaryFolder folder;
  RobotScene scene;
};

/// Where the true arm has the ball, by the URDF's specification, written anew [m].
Eigen::Vector3d ballAt(const std::vector<double>& measured, const Truth& truth) {
  Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
  for (std::size_t i = 0; i < touchingSteps.size(); ++i) {
    const TouchingStep& step = touchingSteps[i];
    moved = moved * Eigen::Translation3d{step.xyz} *
            Eigen::AngleAxisd{measured[i] - truth.value("jointOffset", step.joint, "o").value(), step.axis};
  }
  return moved * truth.scene->markers.at("ball");
}

/// Checks the offsets of the joints against the truth.
void checkOffsets(const SceneSimulation& simulation, std::size_t firstJoint) {
  const Measurements measurements = buildMeasurements({simulation.set}, loadRobot(simulation.set));
  const Model model = buildModel(measurements);
  const CalibrationResult result = calibrate(measurements, model, {.testMissingEffects = false});
  for (std::size_t i = firstJoint; i < touchingSteps.size(); ++i) {
    const std::string joint = touchingSteps[i].joint;
    const std::size_t unknown = model.find("jointOffset@" + joint)->first;
    const double sigma = result.estimates[unknown].sigma;
    const double error =
        result.unknowns[eigenIndex(unknown)] - simulation.truth.value("jointOffset", joint, "o").value();
    CAPTURE(joint, error, sigma);
    CHECK(sigma < 0.003);
    CHECK(std::abs(error) < 3 * sigma);
  }
}

Diagnosis diagnoseTouches(const SceneSimulation& simulation) {
  return diagnose(buildMeasurements({simulation.set}, loadRobot(simulation.set)));
}

} // namespace

TEST_CASE("a simulated touch brings the true marker to the true place in joint angles of its own") {
  // Proves the search for joint angles against Eigen's transforms, without noise; limits; and that the truth tells the
  // places and the distances are between them.
  TouchingArm arm{measuredPlaces};
  arm.scene.noise.encoder = 0;
  arm.scene.set.instruments.contactSigma = 1e-9;
  for (PlaceDistance& distance : arm.scene.set.instruments.distances) {
    distance.sigma = 1e-9;
  }
  const SceneSimulation simulation = arm.simulate({.poses = 12, .samples = 1});
  REQUIRE(simulation.set.captures.size() == 12);
  std::map<std::string, std::set<double>> liftsAt;
  for (const Capture& capture : simulation.set.captures) {
    REQUIRE(capture.contacts.size() == 1);
    const std::string& place = capture.contacts.front().place;
    CHECK((ballAt(capture.joints.measured, simulation.truth) - simulation.truth.scene->places.at(place)).norm() < 1e-6);
    for (const double angle : capture.joints.measured) {
      CHECK(std::abs(angle) < 2.2 + 0.03);
    }
    liftsAt[place].insert(std::round(100 * capture.joints.measured[1]));
  }
  REQUIRE(liftsAt.size() == 3);
  for (const auto& [place, lifts] : liftsAt) {
    CHECK(lifts.size() == 4);
  }
  for (const PlaceDistance& distance : simulation.set.instruments.distances) {
    const auto& places = simulation.truth.scene->places;
    CHECK(distance.metres == Approx((places.at(distance.between[0]) - places.at(distance.between[1])).norm()));
  }
  CHECK_FALSE(simulation.set.instruments.places.front().point);
}

TEST_CASE("an arm that touches known places solves to its true offsets") {
  // Proves that simulated touches mean what the calibration takes them for.
  checkOffsets(TouchingArm{knownPlaces}.simulate({.poses = 45, .samples = 1, .seed = 2}), 0);
}

TEST_CASE("an arm that touches places with known distances solves to its true offsets") {
  // Proves the same where places are estimated, but for the first joint, whose zero looks like where the places are.
  checkOffsets(TouchingArm{measuredPlaces}.simulate({.poses = 60, .samples = 1, .seed = 2}), 1);
}

TEST_CASE("a fit at a smaller noise of contacts takes no touch for an outlier") {
  // Proves that the joints' errors follow the noise of readings: those of a fit at a looser noise would leave touches
  // that encoders round more coarsely than they are exact so far from their places that a robust loss gives them no
  // weight.
  constexpr double step = 2 * M_PI / 4096; // [rad], of `Noise::encoder`
  TouchingArm arm{knownPlaces};
  arm.scene.noise.encoder = 0;
  arm.scene.set.instruments.contactSigma = 1e-5;
  CaptureSet set = arm.simulate({.poses = 45, .samples = 1, .seed = 5}).set;
  set.instruments.contactSigma.reset();
  for (const TouchingStep& joint : touchingSteps) {
    set.encoderSteps[joint.joint] = step;
  }
  for (Capture& capture : set.captures) {
    for (double& angle : capture.joints.measured) {
      angle = step * std::round(angle / step);
    }
  }
  const Measurements measurements = buildMeasurements({set}, loadRobot(set));
  const Model model = buildModel(measurements);
  REQUIRE(measurements.levels.size() == 1);
  const Noise loose{.readings = {0.01}}, exact{.readings = {1e-5}};
  const Fit first = fitInitially(measurements, model, loose, {});
  const Fit then = refit(measurements, model, exact, Loss{1}, first);
  const Residuals residuals{measurements, model, exact, then.loss};
  const std::vector<double> distances =
      scaledDistances(measurements, residuals.witnessResiduals(then.minimum.state), exact);
  CHECK(distances.size() == 45);
  CHECK(*std::max_element(distances.begin(), distances.end()) < Loss::inner * exact.pixel);
}

TEST_CASE("touches miss a place by the noise of contacts") {
  // Proves contactSigma: the sample variance of 3 x 90 coordinates is within 4 of its standard errors.
  TouchingArm arm{knownPlaces};
  arm.scene.noise.encoder = 0;
  const SceneSimulation simulation = arm.simulate({.poses = 90, .samples = 1, .seed = 3});
  double squares = 0;
  for (const Capture& capture : simulation.set.captures) {
    const Eigen::Vector3d place = simulation.truth.scene->places.at(capture.contacts.front().place);
    squares += (ballAt(capture.joints.measured, simulation.truth) - place).squaredNorm();
  }
  CHECK(squares / 270 == Approx(0.0002 * 0.0002).epsilon(4 * std::sqrt(2.0 / 270)));
}

TEST_CASE("a touch is repeated by a new approach only") {
  // Proves that rest records a touch once, and that approaches make it anew with other angles within the noise.
  const TouchingArm arm{knownPlaces};
  CHECK(arm.simulate({.poses = 3, .samples = 4}).set.captures.size() == 3);
  const CaptureSet again = arm.simulate({.poses = 3, .samples = 4, .repeatKind = RepeatKind::reapproach}).set;
  REQUIRE(again.captures.size() == 12);
  CHECK(again.captures[1].repeatKind == RepeatKind::reapproach);
  CHECK(again.captures[1].pose == again.captures[0].pose);
  CHECK(again.captures[1].repeat == 1);
  const double apart = std::abs(again.captures[1].joints.measured[1] - again.captures[0].joints.measured[1]);
  CHECK(apart > 0);
  CHECK(apart < 0.01);
}

TEST_CASE("a place that the arm cannot touch is named with what to change") {
  // Proves the sentence.
  const TouchingArm arm{R"("places": [{"id": "far", "point": [3, 0, 0]}])"};
  CHECK_THROWS_WITH(arm.simulate({.poses = 3}),
                    Catch::Contains("places: \"far\"") && Catch::Contains("place it nearer to the robot"));
}

TEST_CASE("a touching arm is adequate without a flaw and its flaw is named", "[slow]") {
  // Proves that a diagnosis tells a flaw of an arm that only touches.
  const TouchingArm arm{knownPlaces};
  const ScenePlan plan{.poses = 45, .samples = 1, .seed = 4};
  const Diagnosis sound = diagnoseTouches(arm.simulate(plan));
  CAPTURE(sound.sentence);
  CHECK(sound.verdict == Verdict::adequate);

  ScenePlan flawed = plan;
  flawed.flaws = {"elasticity@lift"};
  const Diagnosis soft = diagnoseTouches(arm.simulate(flawed));
  CAPTURE(soft.sentence);
  CHECK(soft.verdict == Verdict::effectMissing);
  CHECK(soft.suggested == std::vector<std::string>{"elasticity@lift"});
}

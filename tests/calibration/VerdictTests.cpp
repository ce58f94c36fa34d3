#include "MeasuredArm.hpp"
#include "TemporaryFolder.hpp"

#include "calibration/Calibration.hpp"
#include "calibration/result/Determination.hpp"
#include "calibration/result/Plausibility.hpp"
#include "data/CaptureSetFile.hpp"
#include "effects/Catalogue.hpp"
#include "estimation/ModelBuilder.hpp"
#include "math/Angles.hpp"
#include "robot/RobotOfSet.hpp"
#include "simulation/Simulation.hpp"
#include "simulation/StandingPoses.hpp"

#include <catch2/catch.hpp>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>

namespace naocal {
namespace {

using nlohmann::json;

/// An arm's set with a change of its file.
CalibrationResult solveArm(const ArmReadings& holds, const std::function<void(json&)>& change,
                           const std::vector<std::string>& with = {}) {
  const TemporaryFolder folder;
  writeArmSet(folder.path(), holds);
  json set = json::parse(readFile(folder.path() / "captures.json"));
  change(set);
  writeAtomically(folder.path() / "captures.json", set.dump());
  const CaptureSet read = readCaptureSet(folder.path()).set;
  const Measurements measurements = buildMeasurements({read}, loadRobot(read));
  return calibrate(measurements, buildModel(measurements, with));
}

CaptureSet simulatedV6(std::size_t poses) {
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  SimulationPlan plan;
  plan.samples = 2;
  plan.poses = planStandingPoses(robot, plan, SupportFoot::left, poses, 1);
  return simulate(robot, plan, 7).set;
}

CalibrationResult solveV6(const CaptureSet& set, const std::vector<std::string>& with = {}) {
  const Measurements measurements = buildMeasurements({set}, loadRobot(configurationDirectory(), "V6"));
  return calibrate(measurements, buildModel(measurements, with));
}

/// A share of a set's corners at random places in the picture, as a detector's gross mistakes.
CaptureSet withGrossCorners(CaptureSet set, double share) {
  std::mt19937_64 random{1};
  std::uniform_real_distribution<double> uniform;
  for (Capture& capture : set.captures) {
    for (BoardCorners& corners : *capture.corners) {
      for (Eigen::Vector2d& uv : corners.uv) {
        uv = uniform(random) < share ? Eigen::Vector2d{640 * uniform(random), 480 * uniform(random)} : uv;
      }
    }
  }
  return set;
}

bool says(const std::vector<std::string>& sentences, const std::string& part) {
  return std::any_of(sentences.begin(), sentences.end(),
                     [&](const std::string& sentence) { return sentence.find(part) != std::string::npos; });
}

} // namespace

TEST_CASE("boards on the wrong link are not usable, however well the rest absorbs them") {
  // Proves that an error that no robot has, and camera turns that no mount has, forbid use: all boards are said to be
  // on the head, where they cannot move in the pictures. The likeliest explanation absorbs everything.
  CaptureSet set = simulatedV6(12);
  for (Board& board : set.boards) {
    board.link = "Head";
  }
  const CalibrationResult result = solveV6(set);
  CAPTURE(result.sentence, result.rmsPx);
  CHECK(result.verdict == ResultVerdict::doNotUse);
  CHECK_FALSE(result.usable);
  CHECK(says(reasonsAgainstUse(result.findings), "no robot is so wrong"));
}

TEST_CASE("a camera and a board on one link tell nothing of the camera") {
  // Proves that requested rotations count as offsets do: whatever the joints do, the board lies at the same place in
  // the picture, and where it sits on the hand is unknown. The error is that of noise.
  const CalibrationResult result =
      solveArm({.points = false, .frames = false, .contacts = false, .corners = true}, [](json& set) {
        json& camera = set["cameras"]["side"];
        camera["link"] = "hand";
        camera["axes"] = "forward";
        camera["placement"] = {{"x", 0}, {"y", 0}, {"z", 0.1}};
        camera.erase("placementGuess");
        json& board = set["boards"][0];
        board.erase("placement");
        board["placementGuess"] = {{"x", 0.5}, {"yaw", -1.57}, {"roll", 1.57}};
        json uv = json::array({{600, 450}, {700, 455}, {602, 350}, {705, 352}});
        for (json& capture : set["captures"]) {
          for (json& corner : uv) {
            corner[0] = corner[0].get<double>() + 0.01;
          }
          capture["corners"][0]["uv"] = uv;
        }
      });
  CAPTURE(result.sentence);
  CHECK(result.verdict == ResultVerdict::doNotUse);
  CHECK(says(reasonsAgainstUse(result.findings), "cannot be learned from these captures"));
}

TEST_CASE("an effect that was asked for and that the captures do not tell is named") {
  // Proves the same for another effect: a robot that stands still in every capture tells nothing of the delay of its
  // encoders. The base model of the same captures is usable.
  const CaptureSet set = simulatedV6(8);
  const CalibrationResult base = solveV6(set);
  CHECK(base.usable);
  CHECK(reasonsAgainstUse(base.findings).empty());
  const CalibrationResult asked = solveV6(set, {"timeOffset@all"});
  CAPTURE(asked.sentence);
  CHECK(asked.verdict == ResultVerdict::doNotUse);
  CHECK(says(reasonsAgainstUse(asked.findings), "timeOffset@all"));
}

TEST_CASE("what can only be traded against another effect is no reason against use") {
  // Proves that a camera's pitch and shift, which these poses tell only together with the neck's offset, do not forbid
  // use: predictions with all of them are right.
  const CalibrationResult result = solveV6(simulatedV6(12), {"cameraTranslation@*"});
  CAPTURE(result.sentence);
  CHECK(result.usable);
}

TEST_CASE("readings that a tracker never took are not called good") {
  // Proves that all readings count, not only those that a robust fit keeps: some of them are of another marker. From
  // one in ten on the error is beyond what any robot has; a single one of sixty is counted and the rest used.
  const auto strays = [](std::size_t every) {
    return [every](json& set) {
      for (std::size_t i = 0; i < set["captures"].size(); i += every) {
        set["captures"][i]["points"][0]["xyz"] = {0.1 + 0.001 * static_cast<double>(i), -0.2, 0.3};
      }
    };
  };
  const CalibrationResult many = solveArm({.frames = false, .contacts = false}, strays(4));
  CAPTURE(many.sentence);
  CHECK(many.verdict == ResultVerdict::doNotUse);
  CHECK(says(reasonsAgainstUse(many.findings), "of 60 readings do not fit the rest"));
  const CalibrationResult one = solveArm({.frames = false, .contacts = false}, strays(1000));
  CAPTURE(one.sentence);
  CHECK(one.verdict != ResultVerdict::doNotUse);
  CHECK(one.sentence.find("1 of 60 readings does not fit the rest; without it the error is") != std::string::npos);
}

TEST_CASE("few gross corners leave a result usable and are counted", "[slow]") {
  // Proves that one corner in a hundred at a random place forbids nothing, and that the sentence has the error of the
  // others beside the number of those set aside. Four in a hundred are not called good.
  const CaptureSet set = simulatedV6(12);
  const CalibrationResult few = solveV6(withGrossCorners(set, 0.008));
  CAPTURE(few.sentence, few.rmsPx);
  CHECK(few.usable);
  CHECK(few.rmsPx > 10);
  CHECK(few.sentence.find("corners do not fit the rest; without them the error is 0.") != std::string::npos);
  const CalibrationResult some = solveV6(withGrossCorners(set, 0.04));
  CAPTURE(some.sentence);
  CHECK(some.verdict != ResultVerdict::good);
}

TEST_CASE("an offset of a joint that never moved is not held by what imitates it") {
  // Proves that such joints are refused by name, though the places of the markers on the hand imitate their offsets.
  // With all joints in motion the same arm is usable, and offsets that placements imitate are held.
  const CalibrationResult still = solveArm({.frames = false, .contacts = false, .motion = {1, 0, 0, 0}}, [](json&) {});
  CAPTURE(still.sentence);
  CHECK(still.verdict == ResultVerdict::doNotUse);
  CHECK(says(reasonsAgainstUse(still.findings), "3 joints never moved: the lift, the slide and the roll;"));
  const CalibrationResult moving = solveArm({.frames = false, .contacts = false}, [](json&) {});
  CAPTURE(moving.sentence);
  CHECK(moving.usable);
  CHECK(says(sentencesOf(furtherFindings(moving.findings)), "is held at zero"));
}

TEST_CASE("an effect beyond chance that is too small to matter is named beside a good verdict") {
  // Proves that the reason for a small p-value is said: corners of 0.01 px tell what the simulator does and the model
  // lacks apart from noise, though it moves no corner by 0.1 px. Corners of usual noise do not, and nothing is said.
  // What it is does not matter here.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  SimulationPlan plan;
  plan.samples = 2;
  plan.poses = planStandingPoses(robot, plan, SupportFoot::left, 12, 7);
  CHECK_FALSE(solveV6(simulate(robot, plan, 7).set).negligible);
  plan.corners.pixel = 0.01;
  const CalibrationResult result = solveV6(simulate(robot, plan, 7).set);
  CAPTURE(result.sentence, result.pValue, result.matters);
  CHECK(result.pValue < 0.01);
  CHECK(result.verdict == ResultVerdict::good);
  REQUIRE(result.negligible);
  CHECK(result.negligible->movedPx < 0.1);
  CHECK(result.sentence.find(result.negligible->label + " is hardly chance") != std::string::npos);
}

TEST_CASE("values that no robot has are told from those that some have") {
  // Proves the limits of offsets, slides and mounts, and that a set which says that its camera's mount is unknown may
  // have any turn within that.
  const Term knee{jointOffset(), 0, "LKneePitch"};
  CHECK_FALSE(describeImplausible(knee, std::vector{radians(11.5)}));
  CHECK(describeImplausible(knee, std::vector{radians(-16)}));
  Term slide{jointOffset(), 0, "lift"};
  slide.effect.unknowns.front().unit = "m";
  CHECK_FALSE(describeImplausible(slide, std::vector{0.09}));
  CHECK(describeImplausible(slide, std::vector{0.2}));
  Term camera{cameraRotation(), 0, "top"};
  CHECK_FALSE(describeImplausible(camera, std::vector{0.1, -0.2, 0.1}));
  CHECK(describeImplausible(camera, std::vector{0.0, 2.6, 0.0}));
  for (Unknown& angle : camera.effect.unknowns) {
    angle.sigma = 1;
  }
  CHECK_FALSE(describeImplausible(camera, std::vector{0.0, 2.6, 0.0}));
  CHECK_FALSE(describeImplausible(Term{elasticity(), 0, "LKneePitch"}, std::vector{10.0}));
}

TEST_CASE("a stored result says why it must not be written to a robot") {
  // Proves that reasons are read, that files of older versions are judged by their numbers, and that a usable result of
  // plausible values has none.
  StoredResult result;
  result.usable = true;
  result.terms = {"jointOffset@LKneePitch", "cameraRotation@top"};
  result.values = {{"jointOffset@LKneePitch.o", 0.05},
                   {"cameraRotation@top.rx", 0.01},
                   {"cameraRotation@top.ry", 0.02},
                   {"cameraRotation@top.rz", 0.03}};
  CHECK(listReasonsAgainstUse(result).empty());
  StoredResult far = result;
  far.values["cameraRotation@top.ry"] = 2.7;
  far.values["jointOffset@LKneePitch.o"] = 0.4;
  CHECK(listReasonsAgainstUse(far).size() == 2);
  StoredResult old = result;
  old.learned = {{"cameraRotation@top.rx", 0}, {"cameraRotation@top.ry", 0.1}, {"cameraRotation@top.rz", 0}};
  CHECK(listReasonsAgainstUse(old).size() == 1);
  old.hasReasons = true;
  CHECK(listReasonsAgainstUse(old).empty());
  StoredResult refused = result;
  refused.usable = false;
  refused.reasons = {"one", "two"};
  CHECK(listReasonsAgainstUse(refused) == std::vector<std::string>{"one", "two"});
  refused.reasons.clear();
  refused.sentence = "Do not use it.";
  CHECK(listReasonsAgainstUse(refused) == std::vector<std::string>{"Do not use it."});
}

} // namespace naocal

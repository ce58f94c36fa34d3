#include "MeasuredArm.hpp"
#include "SimulatedSets.hpp"
#include "TemporaryFolder.hpp"
#include "data/CaptureSetFile.hpp"
#include "diagnosis/CheckedCalibration.hpp"
#include "diagnosis/Diagnosis.hpp"
#include "diagnosis/anomalies/Events.hpp"
#include "estimation/ModelBuilder.hpp"
#include "math/Angles.hpp"
#include "robot/RobotOfSet.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <tuple>

namespace naocal {
namespace {

Diagnosis asked(const CaptureSet& set, const DiagnosisOptions& options = {}) {
  return diagnose(buildMeasurements({set}, loadRobot(configurationDirectory(), set.model)), options);
}

double& angle(const CaptureSet& set, Capture& capture, const std::string& joint) {
  const auto found = std::find(set.jointNames.begin(), set.jointNames.end(), joint);
  return capture.joints.measured[static_cast<std::size_t>(found - set.jointNames.begin())];
}

/// An arm before a tracker of unknown noise, whose readings are shifted along x by `shift` of their capture's id [m].
Measurements armBeforeTracker(const std::function<double(int)>& shift) {
  const TemporaryFolder folder;
  const std::filesystem::path arm = folder.path() / "arm";
  writeArmSet(arm, {.points = false, .contacts = false});
  nlohmann::json file = nlohmann::json::parse(readFile(arm / "captures.json"));
  file["trackers"]["laser"] = nlohmann::json::object();
  for (nlohmann::json& capture : file["captures"]) {
    nlohmann::json& x = capture["frames"][0]["xyz"][0];
    x = x.get<double>() + shift(capture["id"].get<int>());
  }
  writeAtomically(arm / "captures.json", file.dump());
  const CaptureSet set = readCaptureSet(arm).set;
  return buildMeasurements({set}, loadRobot(set));
}

} // namespace

TEST_CASE("a bad capture is found although an effect hides more", "[slow]") {
  // Proves that data checks are repeated after adding the missing effect: the knee's gain is off by 4 %, and one
  // capture's head angle by 1.5 degrees.
  CaptureSet set = simulatedSet(16, 4);
  for (Capture& capture : set.captures) {
    angle(set, capture, "LKneePitch") *= 0.96;
  }
  Capture& bad = set.captures[set.captures.size() / 2];
  angle(set, bad, "HeadYaw") += radians(1.5);
  const Diagnosis diagnosis = asked(set);
  CAPTURE(diagnosis.sentence);
  CHECK(diagnosis.verdict == Verdict::badCaptures);
  CHECK(std::find(diagnosis.suggested.begin(), diagnosis.suggested.end(), "encoderGain@LKneePitch") !=
        diagnosis.suggested.end());
  REQUIRE(!diagnosis.anomalies.empty());
  CHECK(diagnosis.anomalies.front().capture == bad.id);
  CHECK(diagnosis.suggested == std::vector<std::string>{"encoderGain@LKneePitch"});
}

TEST_CASE("angles that were wrong for a moment are an accident and no physics", "[slow]") {
  // Proves it for a 2-degree knee error in one image, in all images of one approach, and in all images of one pose:
  // exactly these captures are named.
  const CaptureSet good = simulatedSet(16, 4);
  const std::string pose = good.captures[42].pose;
  const int repeat = good.captures[42].repeat;
  const std::vector<std::function<bool(const Capture&)>> wrong{
      [&](const Capture& one) { return one.id == good.captures[42].id; },
      [&](const Capture& one) { return one.pose == pose && one.repeat == repeat; },
      [&](const Capture& one) { return one.pose == pose; }};
  for (const auto& isWrong : wrong) {
    CaptureSet set = good;
    std::vector<int> ids, named;
    for (Capture& capture : set.captures) {
      if (isWrong(capture)) {
        angle(set, capture, "LKneePitch") += radians(2);
        ids.push_back(capture.id);
      }
    }
    const Diagnosis diagnosis = asked(set);
    CAPTURE(diagnosis.sentence);
    CHECK(diagnosis.verdict == Verdict::badCaptures);
    for (const DataAnomaly& suspicion : diagnosis.anomalies) {
      named.push_back(suspicion.capture.value_or(-1));
    }
    CHECK(named == ids);
  }
}

TEST_CASE("two pictures that were swapped are named, and not the set-up", "[slow]") {
  // Proves that a few images with errors of hundreds of pixels do not make the whole set look wrong.
  CaptureSet set = simulatedSet(16, 4);
  Capture &one = set.captures[10], &other = set.captures[60];
  std::swap(one.corners, other.corners);
  const Diagnosis diagnosis = asked(set);
  CAPTURE(diagnosis.sentence);
  CHECK(diagnosis.verdict == Verdict::badCaptures);
  REQUIRE(!diagnosis.anomalies.empty());
  for (const DataAnomaly& suspicion : diagnosis.anomalies) {
    CHECK((suspicion.capture == one.id || suspicion.capture == other.id));
  }
}

TEST_CASE("a robot that slipped before its last poses is named, although these boards lost their weight", "[slow]") {
  // Proves that the check uses a fit with all corners if whole boards are rejected as outliers: before the last of 16
  // poses all boards move 40 mm to the left, which is equivalent to the robot moving 40 mm to the right.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  SimulationPlan plan;
  plan.poses = planStandingPoses(robot, plan, SupportFoot::left, 16, 1);
  CaptureSet set = simulate(robot, plan, 4).set;
  for (Board& board : plan.boards) {
    board.placement->y += 0.04;
  }
  const CaptureSet elsewhere = simulate(robot, plan, 4).set;
  const std::string last = set.captures.back().pose;
  double before = 0, after = 0;
  for (std::size_t i = 0; i < set.captures.size(); ++i) {
    if (set.captures[i].pose == last) {
      after = after == 0 ? set.captures[i].time.count() : after;
      set.captures[i].corners = elsewhere.captures[i].corners;
    } else {
      before = set.captures[i].time.count();
    }
  }
  const Diagnosis diagnosis = asked(set);
  CAPTURE(diagnosis.sentence);
  CHECK(diagnosis.verdict == Verdict::badCaptures);
  REQUIRE(diagnosis.anomalies.size() == 1);
  const DataAnomaly& told = diagnosis.anomalies.front();
  CHECK(told.why.find("the robot in stance") != std::string::npos);
  REQUIRE(told.when);
  const double first = set.captures.front().time.count();
  CHECK(told.when->time > before - first);
  CHECK(told.when->time < after - first);
}

TEST_CASE("a robot that was put down anew half a metre away is named with the time, not another pattern", "[slow]") {
  // Proves it where the search cannot start, or ends with corners behind the camera: from one capture on, all boards
  // are elsewhere, which is equivalent to a moved robot. The reported time interval must contain the moment, and no
  // capture that shows a board.
  const auto [poses, shift, turn, share] =
      GENERATE(std::tuple{std::size_t{16}, 1.0, 0.7, 0.6}, std::tuple{std::size_t{8}, 0.3, 0.7, 0.3});
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  SimulationPlan plan;
  plan.poses = planStandingPoses(robot, plan, SupportFoot::left, poses, 1);
  CaptureSet set = simulate(robot, plan, 1).set;
  for (Board& board : plan.boards) {
    Placement& place = *board.placement;
    const Eigen::Vector2d there = Eigen::Rotation2Dd{turn} * Eigen::Vector2d{place.x, place.y};
    place.x = there.x();
    place.y = there.y() + shift;
    place.yaw += turn;
  }
  const CaptureSet elsewhere = simulate(robot, plan, 1).set;
  const auto first = static_cast<std::size_t>(share * static_cast<double>(set.captures.size()));
  for (std::size_t i = first; i < set.captures.size(); ++i) {
    set.captures[i].corners = elsewhere.captures[i].corners;
  }
  const Diagnosis diagnosis = asked(set);
  CAPTURE(diagnosis.sentence);
  CHECK(diagnosis.verdict == Verdict::badCaptures);
  REQUIRE(diagnosis.anomalies.size() == 1);
  const DataAnomaly& told = diagnosis.anomalies.front();
  CHECK(told.why.starts_with("the robot in stance 0 was put down anew"));
  REQUIRE(told.when);
  const double begin = set.captures.front().time.count();
  CHECK(told.when->since <= set.captures[first].time.count() - begin);
  CHECK(told.when->until >= set.captures[first - 1].time.count() - begin);
  const auto isInside = [&](const Capture& capture) { // a capture that could narrow the interval
    const double time = capture.time.count() - begin;
    return capture.corners && !capture.corners->empty() && time > told.when->since && time < told.when->until;
  };
  CHECK(std::none_of(set.captures.begin(), set.captures.end(), isInside));
}

TEST_CASE("a tracker that was shifted is named, and its shift is not taken for the noise of its readings", "[slow]") {
  // Proves it where the file gives no noise, for a shift without a turn, which raises the noise of places by itself: a
  // large one, beyond what instruments have, and one that leaves a noise which instruments may have.
  for (const double shift : {0.02, 0.003}) { // m
    const Measurements measurements = armBeforeTracker([&](int id) { return id >= 14 ? shift : 0; });
    const Diagnosis diagnosis = diagnose(measurements);
    CAPTURE(shift, diagnosis.sentence);
    REQUIRE(diagnosis.anomalies.size() == 1);
    CHECK(diagnosis.anomalies.front().moved == "laser");
    CHECK(diagnosis.suggested.empty());
    const CalibrationResult solved = calibrateChecked(measurements, buildModel(measurements));
    CAPTURE(solved.sentence);
    REQUIRE(solved.suspicious.size() == 1);
    CHECK(solved.suspicious.front().moved == "laser");
  }
}

TEST_CASE("readings of unknown noise are sound where nothing moved, and bad where no instrument scatters so",
          "[slow]") {
  // Proves that the search for what raised the noise raises no alarm by itself, and that noise which nothing raised is
  // no excuse: of 8 mm at random, solve and diagnose say so.
  const Measurements sound = armBeforeTracker([](int) { return 0; });
  const CalibrationResult solved = calibrateChecked(sound, buildModel(sound));
  CAPTURE(solved.sentence);
  CHECK(solved.suspicious.empty());
  CHECK(solved.verdict == ResultVerdict::good);

  std::mt19937_64 random{3};
  std::normal_distribution<double> normal{0, 0.014}; // m, along x
  const Measurements coarse = armBeforeTracker([&](int) { return normal(random); });
  const Diagnosis diagnosis = diagnose(coarse);
  CAPTURE(diagnosis.sentence);
  CHECK(diagnosis.verdict == Verdict::badCaptures);
  CHECK(diagnosis.sentence.find("which no instrument does") != std::string::npos);
  CHECK(calibrateChecked(coarse, buildModel(coarse)).verdict == ResultVerdict::doNotUse);
}

TEST_CASE("of too many moments, those between poses are asked first") {
  // Proves that no moment is among captures of one pose, which contradict what happened shortly before or after, as
  // long as there are others: here all gaps are equally long, so that their length tells nothing.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  SimulationPlan plan;
  plan.poses = planStandingPoses(robot, plan, SupportFoot::left, 20, 1);
  CaptureSet set = simulate(robot, plan, 7).set;
  std::map<double, std::string> poses;
  for (std::size_t i = 0; i < set.captures.size(); ++i) {
    set.captures[i].time = Seconds{static_cast<double>(i / set.cameras.size())};
    poses[set.captures[i].time.count()] = set.captures[i].pose;
  }
  std::size_t asked = 0;
  for (const TransientEvent& event : enumerateEvents(buildMeasurements({set}, robot), {})) {
    if (event.term.effect.name == "jointStepped") { // seen in every pose
      const auto after = poses.upper_bound(event.from->time);
      CHECK(after->second != std::prev(after)->second);
      ++asked;
    }
  }
  CHECK(asked > 0);
}

TEST_CASE("squares of another size are told with their size, and nothing else", "[slow]") {
  // Proves the reported size where the linearised estimate falls short: the file's squares are 11 % larger than the
  // printed ones.
  CaptureSet set = simulatedSet(16, 4);
  for (Board& board : set.boards) {
    for (Eigen::Vector3d& point : board.points) {
      point /= 0.9;
    }
  }
  const Diagnosis diagnosis = asked(set);
  CAPTURE(diagnosis.sentence);
  CHECK(diagnosis.verdict == Verdict::badCaptures);
  REQUIRE(diagnosis.anomalies.size() == 1);
  const std::string& why = diagnosis.anomalies.front().why;
  const std::size_t size = why.find(" are ");
  REQUIRE(size != std::string::npos);
  CHECK(std::stod(why.substr(size + 5)) == Approx(10).margin(0.5));
  CHECK(why.find("smaller") != std::string::npos);
}

TEST_CASE("where the alarm stands but nothing is likely, a diagnosis does not call the model adequate", "[slow]") {
  // Proves that the best candidate is named instead, with the verdict inconclusive. The alarm level of 100 % always
  // raises an alarm; with few candidates and no hidden effect, rarely is one of them likely.
  DiagnosisOptions options;
  options.alarm = 1;
  options.calibration.candidateTests.map = false;
  std::erase_if(options.calibration.effects, [](const Effect& effect) {
    return !effect.inBaseModel && effect.name != "soleTilt" && effect.name != "hysteresis";
  });
  int inconclusive = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Diagnosis diagnosis = asked(simulatedSet(12, seed), options);
    CHECK(diagnosis.verdict != Verdict::adequate);
    if (diagnosis.verdict == Verdict::inconclusive) {
      CHECK(diagnosis.sentence.find(diagnosis.ranking.front().term.label()) != std::string::npos);
      ++inconclusive;
    }
  }
  CHECK(inconclusive > 0);
}

} // namespace naocal

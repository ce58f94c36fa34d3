#include "SimulatedSets.hpp"
#include "calibration/result/Verdict.hpp"
#include "diagnosis/Diagnosis.hpp"
#include "diagnosis/DiagnosisFile.hpp"
#include "estimation/ModelBuilder.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>
#include <set>

namespace naocal {
namespace {

/// One board in one picture that lies elsewhere.
struct Displaced {
  int capture = 0;
  std::string board;
  double distance = 0; // [m]
};

struct DisplacedSet {
  CaptureSet set;
  std::vector<Displaced> displaced;
};

/// Fourteen poses, two pictures each by both cameras.
SimulationPlan planOf() {
  static const Robot robot = loadRobot(configurationDirectory(), "V6");
  SimulationPlan plan;
  static const std::vector<CommandedPose> poses = planStandingPoses(robot, plan, SupportFoot::left, 14, 1);
  plan.poses = poses;
  plan.samples = 2;
  return plan;
}

/// The corners of a board that a capture shows, or null.
BoardCorners* cornersOf(Capture& capture, const std::string& board) {
  for (BoardCorners& corners : *capture.corners) {
    if (corners.board == board) {
      return &corners;
    }
  }
  return nullptr;
}

/// Captures in which `count` boards lie 10 to 50 mm off and turned by up to 3 degrees, each in one picture that shows
/// at least eight of its corners. Both sets of captures have the same noise.
DisplacedSet displacedSet(std::size_t count, std::uint64_t seed) {
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  DisplacedSet result{simulate(robot, planOf(), seed).set, {}};
  std::mt19937_64 random{seed};
  std::uniform_real_distribution<double> share{0, 1};
  std::set<std::pair<int, std::string>> taken;
  while (result.displaced.size() < count) {
    SimulationPlan plan = planOf();
    const std::size_t board = random() % plan.boards.size();
    const double distance = 0.01 + 0.04 * share(random), direction = 6.28 * share(random);
    plan.boards[board].placement->x += distance * std::cos(direction);
    plan.boards[board].placement->y += distance * std::sin(direction);
    plan.boards[board].placement->yaw += 0.1 * (share(random) - 0.5);
    CaptureSet elsewhere = simulate(robot, plan, seed).set;
    const std::size_t index = random() % result.set.captures.size();
    const std::string& name = plan.boards[board].id;
    BoardCorners* const here = cornersOf(result.set.captures[index], name);
    const BoardCorners* const there = cornersOf(elsewhere.captures[index], name);
    if (here && there && there->ids.size() >= 8 && taken.insert({result.set.captures[index].id, name}).second) {
      *here = *there;
      result.displaced.push_back({result.set.captures[index].id, name, distance});
    }
  }
  return result;
}

Measurements built(const CaptureSet& set) {
  return buildMeasurements({set}, loadRobot(configurationDirectory(), set.model));
}

} // namespace

TEST_CASE("boards that were displaced in single pictures are named with how far, and nothing else", "[slow]") {
  // Proves board, capture and distance for one to three boards of a set, 10 to 50 mm off, within three sigmas, the form
  // in the file, and that no effect is blamed. In the last set two of a board's last pictures differ, each by itself:
  // it did not move for good. Of 140 boards in 70 sets 136 were named so, none wrongly; that takes an hour.
  for (const auto& [count, seed] : std::vector<std::pair<std::size_t, std::uint64_t>>{{1, 21}, {3, 23}, {2, 1052}}) {
    const DisplacedSet given = displacedSet(count, seed);
    const Diagnosis diagnosis = diagnose(built(given.set));
    CAPTURE(count, diagnosis.sentence);
    CHECK(diagnosis.verdict == Verdict::badCaptures);
    CHECK(diagnosis.suggested.empty());
    REQUIRE(diagnosis.anomalies.size() == count);
    for (const Displaced& one : given.displaced) {
      const auto told = std::find_if(diagnosis.anomalies.begin(), diagnosis.anomalies.end(), [&](const auto& anomaly) {
        return anomaly.capture == one.capture && anomaly.moved == one.board;
      });
      REQUIRE(told != diagnosis.anomalies.end());
      REQUIRE(told->values.size() == 3);
      const EventValue &x = told->values[0], &y = told->values[1];
      CHECK(std::hypot(x.value, y.value) == Approx(one.distance).margin(3 * std::hypot(x.sigma, y.sigma)));
      CHECK(std::hypot(x.sigma, y.sigma) < 0.005);
      CHECK(told->why.starts_with("board " + one.board + " lies "));
    }
    const nlohmann::json file = diagnosisJson(diagnosis);
    CHECK(file["suspicious"][0]["values"][2]["unit"] == "rad");
    CHECK(file["suspicious"][0]["values"][0]["interval"].size() == 2);
  }
}

TEST_CASE("a calibration names a board that was displaced in one picture, and how far", "[slow]") {
  // Proves the warning with capture, board and distance, that the rest of the result is good, and that sound captures
  // have no such warning.
  const DisplacedSet given = displacedSet(1, 31);
  const Measurements measurements = built(given.set);
  const Model model = buildModel(measurements);
  const CalibrationResult result = calibrate(measurements, model);
  CHECK(result.verdict == ResultVerdict::good);
  const auto whole = std::find_if(result.outliers.begin(), result.outliers.end(),
                                  [](const Outlier& outlier) { return outlier.move.has_value(); });
  REQUIRE(whole != result.outliers.end());
  CHECK(whole->move->distance() == Approx(given.displaced.front().distance).margin(0.004));
  const std::string start = "Board " + given.displaced.front().board + " lies ",
                    end = " in capture " + std::to_string(given.displaced.front().capture) +
                          " than in all others: left out there.";
  const std::vector<std::string> warnings = sentencesOf(furtherFindings(result.findings));
  CHECK(std::any_of(warnings.begin(), warnings.end(),
                    [&](const std::string& one) { return one.starts_with(start) && one.ends_with(end); }));
  const Measurements sound = built(simulate(loadRobot(configurationDirectory(), "V6"), planOf(), 31).set);
  CHECK(calibrate(sound, buildModel(sound)).outliers.empty());
}

} // namespace naocal

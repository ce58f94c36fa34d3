#include "calibration/SharedCauses.hpp"

#include "calibration/Calibration.hpp"
#include "estimation/ModelBuilder.hpp"
#include "simulation/HandMadePoses.hpp"
#include "simulation/Simulation.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <random>
#include <set>

namespace naocal {
namespace {

Measurements measure(const CaptureSet& set, const Robot& robot) {
  return buildMeasurements({set}, robot);
}

/// Takes the weight of the views for which `isHit` is true.
void reject(Measurements& measurements,
            const std::function<bool(const ImageObservation&, const BoardObservation&)>& isHit) {
  for (ImageObservation& picture : measurements.pictures) {
    for (BoardObservation& observation : picture.observations) {
      if (isHit(picture, observation)) {
        for (CornerBlock& block : observation.corners) {
          block.present = Double4{};
        }
      }
    }
  }
}

CaptureSet simulatedSet(const Robot& robot, int poses) {
  return simulate(robot, handMadePlan(robot, poses), 3).set;
}

} // namespace

TEST_CASE("rejected views that follow a joint's angle share it") {
  // Proves the test of joints: the poses in which the knee bends most are rejected. Not that such views exist.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  Measurements measurements = measure(simulatedSet(robot, 24), robot);
  const auto knee = static_cast<Eigen::Index>(*robot.jointIndex("LKneePitch"));
  std::vector<double> angles;
  for (const ImageObservation& picture : measurements.pictures) {
    angles.push_back(picture.instant.q[knee]);
  }
  std::nth_element(angles.begin(), angles.begin() + static_cast<std::ptrdiff_t>(3 * angles.size() / 4), angles.end());
  const double bent = angles[3 * angles.size() / 4];
  reject(measurements,
         [&](const ImageObservation& picture, const BoardObservation&) { return picture.instant.q[knee] > bent; });
  const std::vector<SharedCause> causes = findSharedCauses(measurements);
  REQUIRE(!causes.empty());
  CHECK(std::any_of(causes.begin(), causes.end(), [](const SharedCause& one) { return one.driver == "LKneePitch"; }));
  CHECK(causes.front().p < 0.01);
}

TEST_CASE("rejected views of one board in many poses share the board") {
  // Proves the test of boards and cameras.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  Measurements measurements = measure(simulatedSet(robot, 24), robot);
  const std::size_t board = measurements.pictures.front().observations.front().view.board();
  reject(measurements,
         [&](const ImageObservation&, const BoardObservation& seen) { return seen.view.board() == board; });
  const std::vector<SharedCause> causes = findSharedCauses(measurements);
  REQUIRE(!causes.empty());
  CHECK(causes.front().driver == "board " + measurements.targets[board].name);
}

TEST_CASE("views rejected by chance share nothing") {
  // Proves the level of the test: of 200 draws of one to six random poses, at most 5 share something (1 % expected; six
  // and more of 200 have probability 0.02), and that no or a single hit pose never does.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  const Measurements sound = measure(simulatedSet(robot, 24), robot);
  CHECK(findSharedCauses(sound).empty());
  std::mt19937_64 random{4};
  int alarms = 0;
  for (int draw = 0; draw < 200; ++draw) {
    Measurements measurements = sound;
    std::set<std::size_t> hit;
    for (int i = 0; i <= draw % 6; ++i) {
      hit.insert(std::uniform_int_distribution<std::size_t>{0, sound.pictures.size() - 1}(random));
    }
    std::size_t board = 0;
    for (const std::size_t index : hit) {
      const auto& seen = sound.pictures[index].observations;
      board = seen.empty() ? board : seen[draw % seen.size()].view.board();
      reject(measurements, [&](const ImageObservation& picture, const BoardObservation& observation) {
        return &picture == &measurements.pictures[index] && observation.view.board() == board;
      });
    }
    alarms += findSharedCauses(measurements).empty() ? 0 : 1;
  }
  CHECK(alarms <= 5);
}

TEST_CASE("a missing effect turns no measurement into an outlier") {
  // Proves that the error of a model that lacks an effect holds all of its misfit: the robust fit that the search
  // starts from rejects whole boards here, and none of them is left out of the result. Not that an effect is found.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  SimulationPlan plan = handMadePlan(robot, 14);
  plan.flaw = "hysteresis@LKneePitch";
  plan.flawScale = 2;
  const Measurements measurements = measure(simulate(robot, plan, 1).set, robot);
  const CalibrationResult result = calibrate(measurements, buildModel(measurements));
  CAPTURE(result.sentence);
  std::size_t corners = 0;
  for (const Outlier& outlier : result.outliers) {
    corners += outlier.corners.size();
  }
  CHECK(static_cast<double>(corners) <= 0.005 * static_cast<double>(measurements.cornerCount));
  CHECK(result.rmsPx > 2 * result.noiseFloorPx);
  CHECK(result.verdict != ResultVerdict::good);
  REQUIRE(!result.explanations.empty());
  CHECK(result.explanations.front().effects == std::vector<std::string>{"hysteresis@LKneePitch"});
}

} // namespace naocal

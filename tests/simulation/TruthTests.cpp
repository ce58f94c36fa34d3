#include "RobotV6.hpp"
#include "data/CaptureSetFile.hpp"
#include "simulation/HandMadePoses.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <set>

using namespace naocal;

namespace {

/// Relative placement of `other` in the frame of `own`: x, y, yaw.
Eigen::Vector3d between(const Placement& own, const Placement& other) {
  const Eigen::Isometry3d seen = isometryFromPlacement(own).inverse() * isometryFromPlacement(other);
  return {seen.translation().x(), seen.translation().y(), std::atan2(seen(1, 0), seen(0, 0))};
}

} // namespace

TEST_CASE("the same seed gives the same set and truth, another seed another robot") {
  // Proves repeatability to the last digit, and that `robotSeed` gives several sets of one robot.
  const SimulationPlan plan = handMadePlan(v6(), 3);
  const Simulation one = simulate(v6(), plan, 1), again = simulate(v6(), plan, 1), two = simulate(v6(), plan, 2);
  CHECK(formatCaptureSet(one.set) == formatCaptureSet(again.set));
  CHECK(formatTruth(one.truth) == formatTruth(again.truth));
  CHECK(*one.truth.value("jointOffset", "LKneePitch", "o") != *two.truth.value("jointOffset", "LKneePitch", "o"));
  SimulationPlan sameRobot = plan;
  sameRobot.robotSeed = 1;
  const Simulation elsewhere = simulate(v6(), sameRobot, 2);
  CHECK(*one.truth.value("jointOffset", "LKneePitch", "o") == *elsewhere.truth.value("jointOffset", "LKneePitch", "o"));
  CHECK(one.set.bodyId == elsewhere.set.bodyId);
  CHECK(formatCaptureSet(one.set) != formatCaptureSet(elsewhere.set));
}

TEST_CASE("a robot can be taken up again among its boards") {
  // Proves that robot and board seeds reproduce another set's offsets, mounts, hidden effect and boards, that stances
  // are renumbered with new placements, and that readings are new.
  SimulationPlan plan = handMadePlan(v6());
  plan.hiddenFlaw = true;
  const Simulation first = simulate(v6(), plan, 4);
  plan.robotSeed = plan.boardSeed = 4;
  plan.firstStance = 7;
  const Simulation again = simulate(v6(), plan, 5);
  REQUIRE(again.truth.effects.size() == first.truth.effects.size());
  for (const TrueEffect& effect : first.truth.effects) {
    for (const TrueUnknown& unknown : effect.unknowns) {
      CHECK(again.truth.value(effect.effect, effect.at, unknown.name) == unknown.value);
    }
  }
  for (const auto& [id, placement] : first.truth.ownWorld.boards) {
    CHECK(again.truth.ownWorld.boards.at(id).x == placement.x);
    CHECK(again.truth.ownWorld.boards.at(id).yaw == placement.yaw);
  }
  REQUIRE(again.set.stances.size() == 1);
  CHECK(again.set.stances[0].id == 7);
  CHECK(again.truth.ownWorld.stances.at(7).x != first.truth.ownWorld.stances.at(0).x);
  CHECK(again.set.captures[0].joints.measured != first.set.captures[0].joints.measured);
}

TEST_CASE("the truth names every motor's offset, every camera's rotation and every placement, with units") {
  // Proves completeness against robot and set, and the keys. Of the values only the range is tested.
  const Simulation simulation = simulate(v6(), handMadePlan(v6(), 3), 1);
  const nlohmann::json truth = nlohmann::json::parse(formatTruth(simulation.truth));
  std::set<std::string> offsets, rotations;
  for (const nlohmann::json& effect : truth["effects"]) {
    (effect["effect"] == "jointOffset" ? offsets : rotations).insert(effect["at"].get<std::string>());
    for (const nlohmann::json& unknown : effect["unknowns"]) {
      CHECK(unknown["unit"] == "rad");
      CHECK(std::abs(unknown["value"].get<double>()) <= radians(6.5));
    }
  }
  CHECK(offsets.size() == 23);
  CHECK(offsets.count("RHipYawPitch") == 0);
  CHECK(rotations == std::set<std::string>{"bottom", "top"});
  CHECK(truth["placements"]["boards"].size() == 4);
  CHECK(truth["placements"]["stances"].size() == 1);
  CHECK(truth["placements"]["boards"]["B"].contains("yaw"));
  CHECK(truth["noise"]["pixel"]["value"] == 0.3);
  CHECK(truth["seed"] == 1);
}

TEST_CASE("placements are given in the world of a result: the first board's frame, unless surveyed") {
  // Proves the gauge, and that changing the world frame keeps relative placements. A board that is never seen cannot be
  // the world.
  SimulationPlan plan = handMadePlan(v6(), 12);
  const Truth truth = simulate(v6(), plan, 1).truth;
  CHECK(between({}, truth.placements.boards.at("A")).norm() < 1e-12);
  for (const char* board : {"B", "C", "D"}) {
    CHECK((between(truth.placements.boards.at("A"), truth.placements.boards.at(board)) -
           between(truth.ownWorld.boards.at("A"), truth.ownWorld.boards.at(board)))
              .norm() < 1e-12);
  }
  CHECK((between(truth.placements.boards.at("A"), truth.placements.stances.at(0)) -
         between(truth.ownWorld.boards.at("A"), truth.ownWorld.stances.at(0)))
            .norm() < 1e-12);

  plan.boards[0].placement->x = -5;
  CHECK(between({}, simulate(v6(), plan, 1).truth.placements.boards.at("B")).norm() < 1e-12);

  plan.surveyed = true;
  const Simulation surveyed = simulate(v6(), plan, 1);
  CHECK(between(*surveyed.set.boards[2].placement, surveyed.truth.placements.boards.at("C")).norm() < 1e-12);
  CHECK(between(*surveyed.set.stances[0].placement, surveyed.truth.placements.stances.at(0)).norm() < 1e-12);
}

TEST_CASE("a set says nothing of the truth") {
  // Proves that sets that are not surveyed contain no placements, and that the truth file lies beside the folder.
  const Simulation simulation = simulate(v6(), handMadePlan(v6(), 2), 1);
  for (const Board& board : simulation.set.boards) {
    CHECK_FALSE(board.placement);
  }
  CHECK_FALSE(simulation.set.stances[0].placement);
  CHECK(truthPath("/data/left") == "/data/left.truth.json");
  CHECK(truthPath("/data/left/") == "/data/left.truth.json");
}

TEST_CASE("a written set reads back as it was simulated") {
  // Proves that the reader accepts a simulated set of each kind. Only a part of the content is compared.
  for (const RepeatKind kind : {RepeatKind::rest, RepeatKind::reapproach, RepeatKind::restand}) {
    for (const SupportFoot foot : {SupportFoot::left, SupportFoot::right, SupportFoot::both}) {
      SimulationPlan plan = handMadePlan(v6(), 2, foot);
      plan.repeatKind = kind;
      const Simulation simulation = simulate(v6(), plan, 1);
      const CaptureSet read = parseCaptureSet(formatCaptureSet(simulation.set), "simulated").set;
      REQUIRE(read.captures.size() == 12);
      CHECK(read.captures[7].joints.measured == simulation.set.captures[7].joints.measured);
      CHECK(read.stances.size() == (kind == RepeatKind::restand ? 3 : 1));
    }
  }
}

TEST_CASE("standing anew keeps the pose, changes the stance and comes with a new placement") {
  // Proves the meaning of restand: samples of a pose have the same command, but another stance and placement.
  SimulationPlan plan = handMadePlan(v6(), 2);
  plan.repeatKind = RepeatKind::restand;
  const Simulation simulation = simulate(v6(), plan, 1);
  for (const Capture& capture : simulation.set.captures) {
    CHECK(capture.stance == capture.repeat);
    CHECK(capture.joints.commanded == simulation.set.captures[capture.pose == "P00" ? 0 : 2].joints.commanded);
  }
  const auto& stances = simulation.truth.ownWorld.stances;
  CHECK(between(stances.at(0), stances.at(1)).norm() > 1e-3);
  CHECK(between(stances.at(1), stances.at(2)).norm() > 1e-3);
}

#include "runs/RobotHistory.hpp"

#include "ExampleRuns.hpp"
#include "io/InputError.hpp"
#include "runs/HistoryFile.hpp"
#include "runs/RunWording.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using Catch::Contains;

namespace naocal {

namespace {

RunOffset offset(double value) {
  return {value, 0.001, 20};
}

/// A run with the knee at `knee` and the ankle at zero.
Run kneeRun(const std::string& time, double knee) {
  return exampleRun(time, {{"LKneePitch", offset(knee)}, {"LAnklePitch", offset(0)}});
}

} // namespace

TEST_CASE("a fall between two calibrations stands beside the jump that it caused") {
  // Proves that the jump is found between the right runs, tells the fall, and that sentence, joint and JSON agree.
  const std::vector<Run> runs{kneeRun("2026-03-08", 0.0402), exampleEvent("2026-03-05", fallKind),
                              kneeRun("2026-02-14", 0.0001), kneeRun("2026-03-01", 0), kneeRun("2026-03-15", 0.04)};
  const std::vector<RobotHistory> histories = makeHistories(runs);
  REQUIRE(histories.size() == 1);
  const RobotHistory& history = findRobot(histories, "nao21");
  CHECK(history.runs.size() == 4);
  CHECK(history.falls.size() == 1);
  const auto& knee = history.joints.at("LKneePitch");
  REQUIRE(knee.size() == 4);
  CHECK_FALSE(knee[0].change);
  CHECK_FALSE(knee[1].change->isJump);
  CHECK(knee[2].change->isJump);
  CHECK(knee[2].since == std::size_t{1});
  CHECK(knee[2].afterFall);
  CHECK_FALSE(knee[3].change->isJump);
  CHECK_FALSE(knee[3].afterFall);
  CHECK(
      describeHistory(history) ==
      "nao21: 4 runs from 2026-02-14 to 2026-03-15, 1 fall. One offset jumped: LKneePitch by +2.303° ± 0.081° between "
      "2026-03-01 and 2026-03-08, with a fall in between.");
  CHECK(describeJoint(history, "LKneePitch") ==
        "LKneePitch of nao21: 4 calibrations. It jumped by +2.303° ± 0.081° between 2026-03-01 and 2026-03-08, with a "
        "fall in between.");
  CHECK_THAT(describeJoint(history, "LAnklePitch"), Contains("never changed by more than its uncertainty explains"));
  CHECK_THROWS_WITH(describeJoint(history, "LKneePich"), Contains("near it are LKneePitch"));
  const nlohmann::json json = historyJson(histories, "/runs", {"one is broken"});
  const nlohmann::json& joint = json["robots"][0]["joints"][1];
  CHECK(joint["joint"] == "LKneePitch");
  CHECK(joint["offsets"][2]["change"]["jump"] == true);
  CHECK(joint["offsets"][2]["change"]["since"] == history.runs[1].run.id);
  CHECK(json["broken"][0] == "one is broken");
}

TEST_CASE("what was undone or taken back is shown and not compared") {
  // Proves that a jump is looked for across it, and that an undo marks its run and is no run of its own.
  Run bad = kneeRun("2026-03-01", 0.2), failed = kneeRun("2026-03-02", 0.3);
  failed.outcome = RunOutcome::takenBack;
  Run unneeded = kneeRun("2026-03-04", 0.0005);
  unneeded.outcome = RunOutcome::unneeded;
  const auto histories =
      makeHistories({kneeRun("2026-02-14", 0), bad, failed, exampleEvent("2026-03-03", undoKind, bad.id), unneeded,
                     exampleEvent("2026-03-05", undoKind, "forgotten")});
  const RobotHistory& history = histories.at(0);
  REQUIRE(history.runs.size() == 5);
  CHECK(describeOutcome(history.runs[1]) == "kept, then undone");
  CHECK(history.runs[1].undone == parseTime("2026-03-03"));
  CHECK(describeOutcome(history.runs[2]) == "taken back");
  CHECK(describeOutcome(history.runs[3]) == "not needed");
  CHECK(describeOutcome(history.runs[4]) == "undo");
  const auto& knee = history.joints.at("LKneePitch");
  CHECK_FALSE(knee[1].change);
  CHECK_FALSE(knee[2].change);
  CHECK(knee[3].since == std::size_t{0});
  CHECK_FALSE(knee[3].change->isJump);
}

TEST_CASE("an undo belongs to the run whose offsets were set") {
  // Proves that the last kept run with these offsets is found, none of another robot, with others or undone already.
  const Run first = kneeRun("2026-02-14", 0), second = kneeRun("2026-03-01", 0.01);
  Run other = kneeRun("2026-03-02", 0.01);
  other.robot = {"nao22", "nao22", "P009", "P010"};
  const std::vector<Run> runs{first, second, other};
  CHECK(findRunOf(second.set, first.robot, runs) == second.id);
  CHECK(findRunOf(first.set, first.robot, runs) == first.id);
  CHECK_FALSE(findRunOf({{"LKneePitch", 0.01}}, first.robot, runs));
  std::map<std::string, double> changed = second.set;
  changed["LKneePitch"] += 1e-6;
  CHECK_FALSE(findRunOf(changed, first.robot, runs));
  CHECK_FALSE(findRunOf(second.set, first.robot, {first, second, exampleEvent("2026-03-02", undoKind, second.id)}));
}

TEST_CASE("a robot is known by its body's serial number, or by its name where that is unknown") {
  // Proves that renaming keeps a history together, equal names of two bodies do not mix, and unknown robots are refused
  // with the names near them.
  Run renamed = kneeRun("2026-03-01", 0), other = kneeRun("2026-03-02", 0), named = kneeRun("2026-03-03", 0);
  renamed.robot.body = "Ada";
  other.robot = {"nao21", "", "P555", ""};
  named.robot = {"Ada", "", "", ""};
  const auto histories = makeHistories({kneeRun("2026-02-14", 0), renamed, other, named});
  REQUIRE(histories.size() == 2);
  CHECK(findRobot(histories, "Ada").runs.size() == 3);
  CHECK(findRobot(histories, "P007").robot.body == "Ada");
  CHECK(findRobot(histories, "P555").runs.size() == 1);
  CHECK_THROWS_WITH(findRobot(histories, "Adda"), Contains("found \"Adda\"; near it are Ada"));
  CHECK_THROWS_WITH(findRobot({}, "Ada"), Contains("found no runs at all"));
}

TEST_CASE("a robot with one calibration has nothing to compare yet, and one that only fell no calibration") {
  // Proves both sentences, and the errors of runs with and without held-out corners.
  Run applied = kneeRun("2026-02-14", 0);
  applied.heldOut = false;
  CHECK_THAT(describeHistory(makeHistories({applied})[0]),
             Contains("1 run on 2026-02-14. No joint has two calibrations"));
  CHECK(describeHistory(makeHistories({exampleEvent("2026-02-14", fallKind)})[0]) ==
        "nao21: no calibration yet, 1 fall.");
  CHECK(describeErrors(applied) == "16.2 -> 2.50 px*");
  CHECK(describeErrors(kneeRun("2026-02-14", 0)) == "16.2 -> 2.50 px");
}

} // namespace naocal

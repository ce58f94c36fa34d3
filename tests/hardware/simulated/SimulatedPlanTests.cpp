#include "hardware/simulated/SimulatedPlan.hpp"

#include "RobotV6.hpp"
#include "TemporaryFolder.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"

#include <catch2/catch.hpp>

using namespace naocal;

namespace {

SimulatedPlan read(const std::string& text) {
  const TemporaryFolder folder;
  writeAtomically(folder.path() / "robot.json", text);
  return readSimulatedPlan(folder.path() / "robot.json");
}

} // namespace

// Proves units and values of given keys, and defaults of the others.
TEST_CASE("a simulated robot is described by a file, of which everything may be missing") {
  CHECK(read("{}").offsetRange == SimulatedPlan{}.offsetRange);
  const SimulatedPlan plan = read(R"({"seed": 7, "pace": "quick", "offsetRangeDegrees": 3, "playRangeDegrees": 0.5,
    "periodSeconds": 0.1, "exposureSeconds": 0.02, "lostShare": 0.1,
    "boards": [{"id": "A", "placement": {"x": 0.5, "y": 0, "yaw": 0.1}}]})");
  CHECK(plan.seed == 7);
  CHECK(plan.pace == Pace::quick);
  CHECK(plan.offsetRange == Approx(radians(3)));
  CHECK(plan.playRange == Approx(radians(0.5)));
  CHECK(plan.mountRange == SimulatedPlan{}.mountRange);
  CHECK(plan.cameras.period.count() == 0.1);
  CHECK(plan.cameras.exposure.count() == 0.02);
  CHECK(plan.cameras.lostShare == 0.1);
  CHECK(plan.boards.size() == 1);
  CHECK(plan.boards.front().placement->x == 0.5);
}

// Proves that wrong keys and values are refused by name.
TEST_CASE("a simulated robot's file with a wrong key or value is refused") {
  CHECK_THROWS_WITH(read(R"({"seeds": 7})"), Catch::Contains("seeds"));
  CHECK_THROWS_WITH(read(R"({"offsetRangeDegrees": -1})"), Catch::Contains("offsetRangeDegrees"));
  CHECK_THROWS_WITH(read(R"({"pace": "fast"})"), Catch::Contains("pace"));
  CHECK_THROWS_WITH(read(R"({"periodSeconds": 0})"), Catch::Contains("periodSeconds"));
  CHECK_THROWS_WITH(read(R"({"boards": [{"id": "A"}]})"), Catch::Contains("placement"));
  CHECK_THROWS_AS(read("{"), InputError);
}

// Proves that hidden errors are within their ranges, reproducible by seed, and differ between seeds.
TEST_CASE("a simulated robot's errors are its seed's") {
  SimulatedPlan plan;
  plan.playRange = radians(0.5);
  const SimulatedErrors one = drawErrors(v6(), plan), again = drawErrors(v6(), plan);
  plan.seed = 2;
  const SimulatedErrors other = drawErrors(v6(), plan);
  CHECK(one.robot.jointOffsets == again.robot.jointOffsets);
  CHECK(one.play == again.play);
  CHECK(one.robot.jointOffsets != other.robot.jointOffsets);
  CHECK(one.robot.jointOffsets.cwiseAbs().maxCoeff() <= radians(5));
  for (const double play : one.play) {
    CHECK(play >= 0);
    CHECK(play <= radians(0.5));
  }
  const std::size_t left = *v6().jointIndex("LHipYawPitch"), right = *v6().jointIndex("RHipYawPitch");
  CHECK(one.robot.jointOffsets[Eigen::Index(left)] == one.robot.jointOffsets[Eigen::Index(right)]);
  CHECK(one.play[left] == one.play[right]);
}

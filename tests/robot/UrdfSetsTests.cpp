#include "io/Files.hpp"
#include "robot/RobotOfSet.hpp"

#include <catch2/catch.hpp>

using namespace naocal;

namespace {

const std::string turningArm = R"(<robot name="arm"><link name="base"/><link name="hand"/><link name="heel"/>
<joint name="turn" type="revolute"><parent link="base"/><child link="hand"/><axis xyz="0 0 1"/><limit lower="-1" upper="1" velocity="1" effort="1"/></joint>
<joint name="stand" type="fixed"><parent link="base"/><child link="heel"/></joint></robot>)";

CaptureSet makeSet(const TemporaryFolder& folder, const std::string& name, const std::string& urdf) {
  CaptureSet set;
  set.name = name;
  set.folder = folder.path() / name;
  std::filesystem::create_directories(set.folder);
  writeAtomically(set.folder / "arm.urdf", urdf);
  set.version = 2;
  set.model.clear();
  set.urdf = "arm.urdf";
  set.jointNames = {"turn"};
  set.stances = {{.id = 0, .supportFoot = SupportFoot::none}};
  set.mountings["wrist"] = {.link = "hand", .placement = Placement{.z = 0.05}};
  return set;
}

} // namespace

TEST_CASE("the robot of sets with a URDF has the soles and cameras of all of them") {
  // Proves that the frame of a sole and a camera that only the second set has are there; a camera of both once.
  const TemporaryFolder folder;
  std::vector<CaptureSet> sets{makeSet(folder, "first", turningArm), makeSet(folder, "second", turningArm)};
  sets[1].stances.front().supportLinks = {"heel"};
  sets[1].soles["heel"] = Placement{.z = -0.02};
  sets[1].mountings["eye"] = {.link = "base"};
  const Robot robot = loadRobot(sets);
  REQUIRE(robot.findSole("heel"));
  CHECK(robot.links[robot.findSole("heel")->link].constant.z() == -0.02);
  REQUIRE(robot.cameras.size() == 2);
  CHECK(robot.cameraIndex("eye"));
}

TEST_CASE("sets with other URDFs, bases or mounts are not taken for one robot") {
  // Proves the sentences; a camera in the world may stand elsewhere.
  const TemporaryFolder folder;
  const auto with = [&](const auto& change) {
    std::vector<CaptureSet> sets{makeSet(folder, "first", turningArm), makeSet(folder, "second", turningArm)};
    change(sets[1]);
    return loadRobot(sets);
  };
  CHECK_NOTHROW(with([](CaptureSet&) {}));
  CHECK_THROWS_WITH(with([](CaptureSet& set) { writeAtomically(set.folder / "arm.urdf", turningArm + "\n"); }),
                    Catch::Contains("second: robot: expected the URDF and the base of first"));
  CHECK_THROWS_WITH(with([](CaptureSet& set) { set.base = "hand"; }), Catch::Contains("second: robot: expected"));
  CHECK_THROWS_WITH(with([](CaptureSet& set) { set.mountings["wrist"].placement->z = 0.06; }),
                    Catch::Contains("second: cameras.wrist: expected the link and the placement that first gives"));
  CHECK_NOTHROW(
      with([](CaptureSet& set) { set.mountings["beside"] = {.link = "world", .placement = Placement{.x = 1}}; }));
}

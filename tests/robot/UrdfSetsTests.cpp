#include "io/Files.hpp"
#include "robot/RobotOfSet.hpp"
#include "robot/UrdfContent.hpp"

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
  CHECK_THROWS_WITH(with([](CaptureSet& set) { set.urdf.clear(); }),
                    Catch::Contains("second: robot: expected the URDF and the base of first"));
  CHECK_THROWS_WITH(with([](CaptureSet& set) { set.base = "hand"; }), Catch::Contains("second: robot: expected"));
  CHECK_THROWS_WITH(with([](CaptureSet& set) { set.mountings["wrist"].placement->z = 0.06; }),
                    Catch::Contains("second: cameras.wrist: expected the link and the placement that first gives"));
  CHECK_NOTHROW(
      with([](CaptureSet& set) { set.mountings["beside"] = {.link = "world", .placement = Placement{.x = 1}}; }));
}

TEST_CASE("URDFs of sets are compared by what they say") {
  // Proves that white space, comments, the order of attributes and the way numbers are written do not count; that one
  // number, name, attribute, text or another order of elements does; and that a bad URDF of a later set is said to be
  // one.
  const TemporaryFolder folder;
  const std::string arm =
      "<robot name='arm'><link name='base'/><link name='hand'/>"
      "<joint name='turn' type='revolute'><parent link='base'/><child link='hand'/><origin xyz='0 0 0.1'/>"
      "<limit lower='-1' upper='1' velocity='1' effort='1'/></joint><gazebo>a b</gazebo></robot>";
  const auto load = [&](const std::string& part, const std::string& replacement) {
    CAPTURE(part, replacement);
    std::string other = arm;
    const std::size_t at = other.find(part);
    REQUIRE(at != other.npos);
    other.replace(at, part.size(), replacement);
    return loadRobot(std::vector<CaptureSet>{makeSet(folder, "first", arm), makeSet(folder, "second", other)});
  };
  CHECK_NOTHROW(load("<link name='hand'/>", " <!-- the hand -->\n<link name = \"hand\" ></link>"));
  CHECK_NOTHROW(load("name='turn' type='revolute'", "type='revolute' name='turn'"));
  CHECK_NOTHROW(load("xyz='0 0 0.1'", "xyz=' 0.0 -0  +1.0e-1'"));
  CHECK_NOTHROW(load("a b", "a\n<!-- and --> b"));
  CHECK_NOTHROW(load("<robot", "<?xml version='1.0'?><robot"));

  struct Row {
    const char *part, *replacement;
  };
  for (const Row& row : {Row{"xyz='0 0 0.1'", "xyz='0 0 0.1000001'"}, Row{"xyz='0 0 0.1'", "xyz='0 0.1 0'"},
                         Row{"xyz='0 0 0.1'", "xyz='0 0 0.1' rpy='0 0 0.1'"}, Row{"'arm'", "'leg'"}, Row{"a b", "b a"},
                         Row{"<gazebo>a b</gazebo>", ""}, Row{"<gazebo>a b</gazebo>", "<gazebo><a/>b</gazebo>"},
                         Row{"<link name='base'/><link name='hand'/>", "<link name='hand'/><link name='base'/>"}}) {
    CHECK_THROWS_WITH(load(row.part, row.replacement),
                      "second: robot: expected the URDF and the base of first, found others; sets given together must "
                      "be of one robot");
  }
  CHECK_THROWS_WITH(load("0 0 0.1", "0 0 x"), Catch::Contains("second") && Catch::Contains("expected finite numbers"));
}

TEST_CASE("names that look like numbers are compared as names") {
  // Proves that the links 1 and 1.0 are two.
  CHECK(urdfContent("<robot name='r'><link name='1'/></robot>") !=
        urdfContent("<robot name='r'><link name='1.0'/></robot>"));
  CHECK(urdfContent("<robot name='r'><link name='1'/></robot>") ==
        urdfContent("<robot name='r'> <link name='1'/></robot>"));
}

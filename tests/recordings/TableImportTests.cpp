#include "recordings/table/TableImport.hpp"

#include "data/CaptureSetFile.hpp"
#include "io/Files.hpp"
#include "io/GreyImage.hpp"
#include "io/InputError.hpp"
#include "math/Angles.hpp"
#include "recordings/table/ColumnGuess.hpp"

#include "recordings/TestArm.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace naocal;
using namespace naocal::testing;

namespace {

ImportScene sceneWithLens() {
  ImportScene scene = armScene();
  CameraIntrinsics lens;
  lens.width = 4;
  lens.height = 2;
  lens.fx = lens.fy = 5;
  scene.lens = lens;
  scene.cameraLink = "eye";
  return scene;
}

TableImport import(const std::string& text, const std::filesystem::path& pictures = ".") {
  const ImportScene scene = sceneWithLens();
  const CsvTable table{text, "log.csv"};
  return importTable(table, guessColumns(table, scene.robot).map, scene, pictures);
}

} // namespace

TEST_CASE("a table of joint angles and tracked positions becomes a capture set that reads back") {
  // Proves units, poses, repeats, missing readings, marker links and the round trip through the folder.
  const TemporaryDirectory folder;
  TableImport result = import("t,q1,q2,q3,pose,hand_x_mm,hand_y_mm,hand_z_mm\n"
                              "10,90,0,0.1,A,1000,0,500\n"
                              "11,90,0,0.1,A,1001,0,500\n"
                              "12,45,,0.2,B,900,20,500\n"
                              "13,90.5,0,0.1,A,1000,1,500\n"
                              "14,45,30,0.2,B,,,\n");
  CHECK(result.withoutMeasurement == 1);
  writeImport(result.imported, folder.path() / "set");
  const CaptureSet set = readCaptureSet(folder.path() / "set").set;
  CHECK(set.urdf == "robot.urdf");
  CHECK(readFile(folder.path() / "set" / "robot.urdf") == armUrdf);
  CHECK(set.jointNames == std::vector<std::string>{"shoulder_pan", "shoulder_lift", "slide"});
  REQUIRE(set.captures.size() == 4);
  CHECK(set.captures[0].joints.measured[0] == Approx(radians(90)));
  CHECK(set.captures[0].joints.measured[2] == 0.1);
  CHECK(set.captures[0].points.at(0).xyz == Eigen::Vector3d{1, 0, 0.5});
  CHECK(set.captures[1].repeat == 0);
  CHECK(set.captures[1].time == Seconds{1});
  CHECK(std::isnan(set.captures[2].joints.measured[1]));
  CHECK(set.captures[3].pose == "A");
  CHECK(set.captures[3].repeat == 1);
  CHECK(set.captures[3].repeatKind == RepeatKind::reapproach);
  REQUIRE(set.instruments.markers.size() == 1);
  CHECK(set.instruments.markers[0].link == "eye"); // fixed to the last moved link
}

TEST_CASE("a table may have the temperatures of some joints") {
  // Proves that the set reads back, and that a joint without a column has none.
  const TemporaryDirectory folder;
  const TableImport result = import("t,q1,q2,q3,shoulder_lift_temp,hand_x_mm,hand_y_mm,hand_z_mm\n"
                                    "10,90,0,0.1,31.5,1000,0,500\n"
                                    "11,80,0,0.1,32,1001,0,500\n");
  writeImport(result.imported, folder.path() / "set");
  const JointReadings joints = readCaptureSet(folder.path() / "set").set.captures.at(0).joints;
  REQUIRE(joints.temperature.size() == 3);
  CHECK(std::isnan(joints.temperature[0]));
  CHECK(joints.temperature[1] == 31.5);
  CHECK(std::isnan(joints.temperature[2]));
}

TEST_CASE("a table's rows of one pose are repeats that were approached anew where their angles differ") {
  // A rest gives its pictures the mean of its readings; a joint that moved between two pictures would be misread.
  const TemporaryDirectory folder;
  const std::string where = ",1000,0,500\n";
  const auto repeats = [&](const std::string& table) {
    std::vector<std::pair<int, RepeatKind>> result;
    for (const Capture& capture : import(table, folder.path()).imported.set.captures) {
      result.emplace_back(capture.repeat, capture.repeatKind);
    }
    return result;
  };
  const auto rest = RepeatKind::rest, reapproach = RepeatKind::reapproach;
  using Repeats = std::vector<std::pair<int, RepeatKind>>;
  CHECK(repeats("q1,q2,q3,pose,hand_x_mm,hand_y_mm,hand_z_mm\n0.1,0,0,A" + where + "0.1,0,0,A" + where +
                "0.1003,0,0,A" + where + "0.1003,0,0,A" + where + "0.2,0,0,B,900,0,500\n" + "0.1003,0,0,A" + where) ==
        Repeats{{0, rest}, {0, rest}, {1, reapproach}, {1, reapproach}, {0, rest}, {2, reapproach}});
  CHECK(repeats("q1,q2,q3,pose,trial,hand_x_mm,hand_y_mm,hand_z_mm\n0.1,0,0,A,0" + where + "0.1003,0,0,A,0" + where +
                "0.1003,0,0,A,1" + where + "0.1,0,0,A,2" + where) ==
        Repeats{{0, rest}, {0, rest}, {1, rest}, {2, reapproach}});
}

TEST_CASE("a table's pictures are copied into the set, with lens and mount") {
  const TemporaryDirectory folder;
  writeImage({4, 2, {1, 2, 3, 4, 5, 6, 7, 8}}, folder.path() / "a.png");
  const TableImport result =
      import("q1,q2,q3,file\n0.1,0.2,0.1,a.png\n0.1,0.2,0.1,a.png\n0.3,0.2,0.1,\n", folder.path());
  CHECK(result.withoutMeasurement == 1);
  writeImport(result.imported, folder.path() / "set");
  const CaptureSet set = readCaptureSet(folder.path() / "set").set;
  REQUIRE(set.captures.size() == 2);
  CHECK(set.captures[1].pose == set.captures[0].pose); // equal angles
  CHECK(readImage(pictureFile(set.captures[1], folder.path() / "set")).pixels.back() == 8);
  CHECK(set.mountings.at("wrist").link == "eye");
  CHECK(set.boards.at(0).link == "world");
  CHECK_THROWS_WITH(writeImport(result.imported, folder.path() / "set"), Catch::Contains("a new or an empty folder"));
}

TEST_CASE("a table's bad cells are refused with row and column") {
  struct Broken {
    std::string text, sentence;
  };
  const std::vector<Broken> all{
      {"q1,q2,q3,x,y,z\n1,0,0,1,2,\n",
       "log.csv, row 2, columns \"x\", \"y\", \"z\": expected three coordinates or none, found 2"},
      {"q1_rad,q2,q3,x,y,z\n90,0,0,1,2,3\n", "are these degrees?"},
      {"q1,q2,q3,x_m,y_m,z_m\n1,0,0,1,2,3000\n", "are these millimetres?"},
      {"q1,q2,q3,x,y,z\n1,zero,0,1,2,3\n", "column \"q2\": expected a number, found \"zero\""},
      {"q1,q2,q3,x,y,z,qw,qx,qy,qz\n1,0,0,1,2,3,1,1,0,0\n",
       "expected a quaternion w, x, y, z of length 1, found length 1.414"},
      {"q1,q2,q3,x,y,z,qw,qx,qy,qz\n1,0,0,1,2,3,,1,0,0\n", "expected a quaternion"},
      {"q1,q2,q3,x,y,z,pose\n1,0,0,1,2,3,\n", "expected the name of a pose, found an empty cell"},
      {"q1,q2,q3,x,y,z,pose,repeat\n1,0,0,1,2,3,A,-1\n", "expected a number of a repeat"},
      {"q1,q2,q3,x,y,z,time\n1,0,0,1,2,3,\n", "expected a time, found an empty cell"},
      {"q1,q2,q3\n1,0,0\n", "expected rows with a picture, a measured point or a measured frame, found none"},
      {"q1,q2,q3,file\n1,0,0,none.png\n", "row 2, column \"file\": expected a picture in"},
      {"q1,q2,q3,file\n1,0,0,../../etc/passwd\n", "found no file"},
  };
  for (const Broken& broken : all) {
    CAPTURE(broken.text);
    CHECK_THROWS_WITH(import(broken.text), Catch::Contains(broken.sentence));
  }
  const ImportScene scene = armScene(); // no lens
  const TemporaryDirectory folder;
  writeImage({4, 2, {1, 2, 3, 4, 5, 6, 7, 8}}, folder.path() / "a.png");
  const CsvTable table{"q1,q2,q3,file\n0.1,0.2,0.1,a.png\n", "log.csv"};
  const ColumnMap map = guessColumns(table, scene.robot).map;
  CHECK_THROWS_WITH(importTable(table, map, scene, folder.path()), Catch::Contains("--camera-model"));
  ImportScene lensOnly = sceneWithLens();
  lensOnly.cameraLink = "hand";
  CHECK_THROWS_WITH(importTable(table, map, lensOnly, folder.path()), Catch::Contains("--camera-link"));
}

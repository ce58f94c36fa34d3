#include "recordings/table/ColumnGuess.hpp"

#include "io/InputError.hpp"

#include "recordings/TestArm.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace naocal;
using namespace naocal::testing;

namespace {

ColumnGuess guess(const std::string& text) {
  return guessColumns(CsvTable{text, "log.csv"}, armScene().robot);
}

} // namespace

TEST_CASE("columns are guessed from joints' names and units") {
  const ColumnGuess all = guess("time [ms],Shoulder Pan (deg),shoulder_lift,slide_mm,hand_x_mm,hand_y_mm,hand_z_mm,"
                                "picture,pose,shoulder_lift_temp,operator\n"
                                "1,90,0.5,20,1,2,3,a.png,P1,31,Ann\n");
  const ColumnMap& map = all.map;
  REQUIRE(map.joints.size() == 3);
  CHECK(map.joints.at("shoulder_pan").column == "Shoulder Pan (deg)");
  CHECK(map.joints.at("shoulder_pan").unit == "deg");
  CHECK(map.joints.at("shoulder_lift").unit == "rad");
  CHECK(map.joints.at("slide").unit == "mm");
  REQUIRE(map.points.size() == 1);
  CHECK(map.points[0].marker == "hand");
  CHECK(map.points[0].columns == std::array<std::string, 3>{"hand_x_mm", "hand_y_mm", "hand_z_mm"});
  CHECK(map.points[0].unit == "mm");
  CHECK(map.image == "picture");
  CHECK(map.time == "time [ms]");
  CHECK(map.timeUnit == "ms");
  CHECK(map.pose == "pose");
  CHECK(map.temperature.at("shoulder_lift") == "shoulder_lift_temp");
  CHECK(all.unused == std::vector<std::string>{"operator"});
}

TEST_CASE("numbered columns are the joints in the URDF's order, and large angles are degrees") {
  // Proves numbers from 0 or 1, one unit for all angles, joints that mimic left out, and frames.
  for (const std::string& names : {"q0,q1,q2", "Joint 1,Joint 2,Joint 3"}) {
    const ColumnMap map = guess(names + ",x,y,z,qw,qx,qy,qz\n45,0.1,0.2,1200,0,3,1,0,0,0\n").map;
    REQUIRE(map.joints.size() == 3);
    CHECK(map.joints.at("shoulder_pan").unit == "deg");
    CHECK(map.joints.at("shoulder_lift").unit == "deg");
    CHECK(map.joints.at("slide").unit == "m");
    REQUIRE(map.frames.size() == 1);
    CHECK(map.points.empty());
    CHECK(map.frames[0].unit == "mm");
    CHECK(map.frames[0].quaternion == std::array<std::string, 4>{"qw", "qx", "qy", "qz"});
  }
}

TEST_CASE("turns, forces and torques are no positions") {
  // Proves it for axis-angle columns, wrenches and speeds beside a marker; and that tx, ty, tz alone are a translation.
  const ColumnGuess all = guess("q1,q2,q3,hand_x,hand_y,hand_z,rx,ry,rz,Fx,Fy,Fz,Tx,Ty,Tz,vx,vy,vz,rot_x,rot_y,rot_z\n"
                                "1,0,0,1,2,3,1,0,0,9,9,9,1,1,1,0,0,0,1,0,0\n");
  REQUIRE(all.map.points.size() == 1);
  CHECK(all.map.points[0].marker == "hand");
  CHECK(all.unused.size() == 15);
  CHECK(guess("q1,q2,q3,tx,ty,tz\n1,0,0,1,2,3\n").map.points.size() == 1);
  const ColumnGuess wrench = guess("q1,q2,q3,m_x,m_y,m_z,Fx,Fy,Fz,Mx,My,Mz\n1,0,0,1,2,3,9,9,9,1,1,1\n");
  REQUIRE(wrench.map.points.size() == 1);
  CHECK(wrench.map.points[0].marker == "m");
}

TEST_CASE("a log of a real-time interface is read by its numbered names") {
  // Proves measured joints beside targets and speeds, and the position in a pose of six numbers.
  const ColumnGuess all =
      guess("timestamp target_q_0 target_q_1 target_q_2 actual_q_0 actual_q_1 actual_q_2 actual_qd_0 "
            "actual_TCP_pose_0 actual_TCP_pose_1 actual_TCP_pose_2 actual_TCP_pose_3 "
            "actual_TCP_pose_4 actual_TCP_pose_5\n"
            "0 1 2 0.1 1 2 0.1 0 0.4 0.5 0.6 1 2 3\n");
  CHECK(all.map.joints.at("shoulder_lift").column == "actual_q_1");
  REQUIRE(all.map.points.size() == 1);
  CHECK(all.map.points[0].marker == "tcp_pose");
  CHECK(all.map.points[0].columns[2] == "actual_TCP_pose_2");
  CHECK(all.map.time == "timestamp");
  CHECK(all.unused.size() == 7);
}

TEST_CASE("a name of two columns that are not needed is passed over") {
  const ColumnGuess all = guess("q[0],q[1],q[2],x,y,z,q_d[0],q_d[0]\n1,0,0,1,2,3,5,6\n");
  CHECK(all.map.joints.size() == 3);
  CHECK(all.unused == std::vector<std::string>{"q_d[0]"});
  CHECK_THROWS_WITH(guess("q1,q2,q3,q3,x,y,z\n1,0,0,0,1,2,3\n"), Catch::Contains("\"q3\", as it is used, found two"));
}

TEST_CASE("a column of picture names is found whatever it is called") {
  const ColumnGuess all = guess("A1,A2,A3,note,photo\n10,20,30,a.png too dark,\n10,20,30,,shots/b.JPG\n");
  CHECK(all.map.image == "photo");
  CHECK(all.unused == std::vector<std::string>{"note"});
  CHECK_FALSE(guess("A1,A2,A3,photo\n10,20,30,\n").map.image);
}

TEST_CASE("a table without joints is refused with the names of both sides") {
  CHECK_THROWS_WITH(guess("t,x\n1,2\n"), Catch::Contains("shoulder_pan") && Catch::Contains("found t, x"));
}

TEST_CASE("a column map is read as it was written") {
  const Robot robot = armScene().robot;
  const nlohmann::json json = nlohmann::json::parse(R"({
    "joints": {"shoulder_pan": {"column": "q1", "unit": "deg", "factor": 0.5, "sign": -1}, "slide": {"column": "s", "unit": "mm"}},
    "points": [{"marker": "hand", "tracker": "vicon", "link": "flange", "columns": ["x", "y", "z"], "unit": "mm"}],
    "frames": [{"frame": "tool", "tracker": "vicon", "columns": ["a", "b", "c"], "quaternion": ["w", "i", "j", "k"]}],
    "image": "file", "time": {"column": "t", "unit": "ms"}, "pose": "p", "repeat": "r", "temperature": {"slide": "T"}})");
  const ColumnMap map = parseColumnMap(json, "c.json", robot);
  CHECK(map.joints.at("shoulder_pan").factor == 0.5);
  CHECK(map.joints.at("shoulder_pan").sign == -1);
  CHECK(map.points.at(0).link == "flange");
  CHECK(columnMapJson(map) == columnMapJson(parseColumnMap(columnMapJson(map), "c.json", robot)));
  const ColumnMap contract =
      parseColumnMap(nlohmann::json::parse(
                         R"({"joints": {"shoulder_pan": {"column": "q1", "unit": "deg"}}, "image": "file", "time": "t",
        "points": [{"marker": "hand", "tracker": "vicon", "columns": ["x", "y", "z"], "unit": "mm"}]})"),
                     "c.json", robot);
  CHECK(contract.time == "t");
  CHECK(contract.timeUnit == "s");
}

TEST_CASE("a column map with a mistake is refused with its place") {
  struct Broken {
    std::string json, sentence;
  };
  const std::vector<Broken> all{
      {R"({})", "joints"},
      {R"({"joints": {"shoulder_pam": "q1"}})", "a joint of the URDF: shoulder_pan"},
      {R"({"joints": {"shoulder_pan": {"column": "q1", "unit": "mm"}}})", "rad or deg"},
      {R"({"joints": {"slide": {"column": "q1", "unit": "deg"}}})", "m, cm or mm"},
      {R"({"joints": {"slide": {"column": "q1", "unt": "mm"}}})", "the key unt"},
      {R"({"joints": {"slide": {"column": "q1", "factor": 0}}})", "a factor other than 0"},
      {R"({"joints": {"slide": {"column": "q1", "sign": 0}}})", "1 or -1"},
      {R"({"joints": {"slide": {"unit": "mm"}}})", "column"},
      {R"({"joints": {}, "points": [{"marker": "h", "columns": ["x", "y"]}]})", "3 columns: x, y, z"},
      {R"({"joints": {}, "points": [{"marker": "h", "columns": ["x", "y", "z"], "unit": "inch"}]})", "m, cm or mm"},
      {R"({"joints": {}, "points": [{"marker": "h", "columns": ["x", "y", "z"], "link": "hand"}]})",
       "a link of the URDF"},
      {R"({"joints": {}, "frames": [{"frame": "h", "columns": ["x", "y", "z"], "quaternion": ["w"]}]})",
       "4 columns: w, x, y, z"},
      {R"({"joints": {}, "time": {"column": "t", "unit": "h"}})", "s, ms, us or ns"},
      {R"({"joints": {"slide": "q1"}, "temperature": {"shoulder_pan": "T"}})", "a joint that has a column"},
      {R"({"joints": {"slide": "q1"}, "pictures": "file"})", "the key pictures"},
  };
  for (const Broken& broken : all) {
    CAPTURE(broken.json);
    CHECK_THROWS_WITH(parseColumnMap(nlohmann::json::parse(broken.json), "c.json", armScene().robot),
                      Catch::StartsWith("c.json") && Catch::Contains(broken.sentence));
  }
}

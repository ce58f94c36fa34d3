#include "recordings/table/ColumnMeaning.hpp"

#include "io/InputError.hpp"
#include "recordings/table/ColumnGuess.hpp"

#include "recordings/TestArm.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace naocal;
using namespace naocal::testing;
using Catch::Contains;

namespace {

/// A table with every kind of column, and one that is not used.
const std::string fullTable =
    "t,shoulder_pan_deg,shoulder_lift_deg,slide_mm,hand_x,hand_y,hand_z,tool_x,tool_y,tool_z,tool_qw,tool_qx,tool_qy,"
    "tool_qz,image,pose,repeat,shoulder_pan_temp,note\n"
    "1,10,20,30,1,2,3,1,2,3,1,0,0,0,a.png,P,0,30,dark\n";

ColumnMap fullMap() {
  return guessColumns(CsvTable{fullTable, "log.csv"}, armScene().robot).map;
}

/// The meaning of a column by a map; empty: none.
std::string meaningOf(const ColumnMap& map, const std::string& column) {
  std::string words;
  for (const ColumnMeaning& meaning : columnMeanings(map, armScene().robot)) {
    words += meaning.column == column ? meaning.words + (meaning.unit.empty() ? "" : " in " + meaning.unit) : "";
  }
  return words;
}

void assign(ColumnMap& map, const std::string& column, const std::string& id, const std::string& unit = "") {
  assignColumn(map, armScene().robot, column, id, unit);
}

} // namespace

TEST_CASE("every column of a guessed map has one meaning, in words") {
  // Proves the words of all kinds, their units, and that ids are unique; whether the guess is right is tested with it.
  ColumnMap map =
      guessColumns(CsvTable{"t_ms,shoulder_pan_deg,slide_mm,hand_x,hand_y,hand_z,tool_x,tool_y,tool_z,tool_qw,"
                            "tool_qx,tool_qy,tool_qz,image,pose,repeat,shoulder_pan_temp,note\n"
                            "1,10,30,1,2,3,1,2,3,1,0,0,0,a.png,P,0,30,dark\n",
                            "log.csv"},
                   armScene().robot)
          .map;
  map.joints.at("shoulder_pan").sign = -1;
  CHECK(meaningOf(map, "shoulder_pan_deg") == "angle of joint shoulder_pan, times -1 in deg");
  CHECK(meaningOf(map, "slide_mm") == "position of joint slide in mm");
  CHECK(meaningOf(map, "hand_y") == "y of marker hand, measured by tracker in m");
  CHECK(meaningOf(map, "tool_z") == "z of frame tool, measured by tracker in m");
  CHECK(meaningOf(map, "tool_qw") == "w of the quaternion of frame tool, measured by tracker");
  CHECK(meaningOf(map, "image") == "file name of the picture");
  CHECK(meaningOf(map, "t_ms") == "time in ms");
  CHECK(meaningOf(map, "pose") == "name of the pose");
  CHECK(meaningOf(map, "repeat") == "number of the repeat of a pose");
  CHECK(meaningOf(map, "shoulder_pan_temp") == "temperature of joint shoulder_pan [°C]");
  CHECK(meaningOf(map, "note").empty());
  std::vector<std::string> ids;
  for (const ColumnMeaning& meaning : columnMeanings(map, armScene().robot)) {
    ids.push_back(meaning.id);
  }
  CHECK(std::find(ids.begin(), ids.end(), "joint:shoulder_lift") != ids.end()); // has no column
  CHECK(std::find(ids.begin(), ids.end(), "joint:grip") == ids.end());          // mimics the slide
  std::sort(ids.begin(), ids.end());
  CHECK(std::adjacent_find(ids.begin(), ids.end()) == ids.end());
}

TEST_CASE("a column that gets a meaning loses the one it had") {
  // Proves it for joints with signs, units, temperatures, singles, points and frames; and that the map reads back.
  ColumnMap map = fullMap();
  map.joints.at("shoulder_pan").sign = -1;
  assign(map, "note", "joint:shoulder_pan");
  CHECK(map.joints.at("shoulder_pan").column == "note");
  CHECK(map.joints.at("shoulder_pan").unit == "deg"); // as before
  CHECK(map.joints.at("shoulder_pan").sign == -1);
  CHECK(meaningOf(map, "shoulder_pan_deg").empty());
  assign(map, "shoulder_pan_deg", "pose");
  CHECK(map.pose == "shoulder_pan_deg");
  assign(map, "shoulder_pan_deg", "joint:shoulder_pan", "rad");
  CHECK(map.joints.at("shoulder_pan").column == "shoulder_pan_deg");
  CHECK(map.joints.at("shoulder_pan").unit == "rad");
  CHECK_FALSE(map.pose);
  assign(map, "note", "temperature:shoulder_lift");
  CHECK(map.temperature.at("shoulder_lift") == "note");
  assign(map, "shoulder_lift_deg", "");
  CHECK_FALSE(map.joints.contains("shoulder_lift"));
  CHECK_FALSE(map.temperature.contains("shoulder_lift"));
  assign(map, "shoulder_lift_deg", "joint:shoulder_lift");
  CHECK(map.joints.at("shoulder_lift").unit == "rad"); // that of the other joint that turns
  assign(map, "t", "time", "ms");
  CHECK(map.timeUnit == "ms");
  assign(map, "hand_x", "point:0:x", "mm");
  CHECK(map.points.at(0).unit == "mm");
  assign(map, "tool_x", "frame:0:x", "cm");
  CHECK(map.frames.at(0).unit == "cm");
  CHECK_NOTHROW(parseColumnMap(columnMapJson(map), "columns", armScene().robot));
  assign(map, "hand_y", "");
  CHECK(map.points.empty());
  assign(map, "tool_qw", "image");
  CHECK(map.frames.empty());
  CHECK(map.image == "tool_qw");
  CHECK(meaningOf(map, "image").empty());
}

TEST_CASE("a meaning that a column cannot have is refused, and the map stays as it was") {
  // Proves it for unknown meanings and units, coordinates alone, and the temperature of a joint without a column.
  const ColumnMap before = fullMap();
  const auto refusal = [&](const std::string& column, const std::string& id, const std::string& unit = "") {
    ColumnMap map = before;
    std::string sentence;
    try {
      assign(map, column, id, unit);
    } catch (const InputError& error) {
      sentence = error.what();
    }
    CHECK(columnMapJson(map) == columnMapJson(before));
    return sentence;
  };
  CHECK_THAT(refusal("note", "joint:shoulder_pam"), Contains("such as joint:shoulder_pan"));
  CHECK_THAT(refusal("shoulder_pan_deg", "joint:shoulder_pan", "mm"),
             Contains("expected rad, deg, found the unit \"mm\""));
  CHECK_THAT(refusal("pose", "pose", "s"), Contains("expected no unit"));
  CHECK_THAT(refusal("note", "point:0:x"), Contains("all columns of it together"));
  CHECK_THAT(refusal("hand_x", "point:0:y"), Contains("all columns of it together"));
  CHECK_THAT(refusal("shoulder_pan_deg", "temperature:shoulder_pan"), Contains("found \"temperature:shoulder_pan\""));
  CHECK_THAT(refusal("note", "point:7:x"), Contains("expected a meaning"));
}

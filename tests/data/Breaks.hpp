#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace naocal {

enum class Breaks { file, capture };

/// One modification that invalidates the good set: the value at a JSON pointer is replaced or removed.
struct Break {
  Breaks what;
  std::string place;
  std::string value; // JSON with ' in place of "; empty: removed
  std::vector<std::string> sentence;
};

inline const std::string removed;

/// Modifies the good set's document.
inline void applyBreak(const Break& how, nlohmann::json& document) {
  const nlohmann::json::json_pointer place{how.place};
  if (how.value.empty()) {
    document.at(place.parent_pointer()).erase(place.back());
  } else {
    std::string value = how.value;
    std::replace(value.begin(), value.end(), '\'', '"');
    document[place] = nlohmann::json::parse(value);
  }
}

inline std::vector<Break> breaks() {
  using enum Breaks;
  return {
      {file, "/format", removed, {"top level", "\"format\"", "none"}},
      {file, "/format", "'naocal-result'", {"format: expected \"naocal-captures\"", "found \"naocal-result\""}},
      {file, "/version", removed, {"\"version\""}},
      {file, "/version", "3", {"version: expected", "found 3"}},
      {file, "/version", "'1'", {"version: expected a whole number from 1", "found \"1\""}},
      {file, "/robot", removed, {"\"robot\""}},
      {file, "/robot", "'V6'", {"robot: expected an object", "\"V6\""}},
      {file, "/robot/model", removed, {"robot:", "\"model\""}},
      {file, "/robot/model", "6", {"robot.model: expected a text", "found 6"}},
      {file, "/robot/bodyId", "17", {"robot.bodyId", "17"}},
      {file, "/jointNames", removed, {"\"jointNames\""}},
      {file, "/jointNames", "[]", {"jointNames: expected at least one", "a list of 0"}},
      {file, "/jointNames", "'HeadYaw'", {"jointNames: expected a list"}},
      {file, "/jointNames/1", "'Neck'", {"jointNames[1]", "26 joint names", "\"Neck\""}},
      {file, "/jointNames/1", "'HeadYaw'", {"jointNames[1]", "every joint once", "\"HeadYaw\""}},
      {file, "/jointNames/2", "3", {"jointNames[2]", "found 3"}},
      {file, "/cameras", removed, {"\"cameras\""}},
      {file, "/cameras", "[]", {"cameras: expected an object", "a list of 0"}},
      {file, "/cameras/top/fx", removed, {"cameras.top: expected the key \"fx\""}},
      {file, "/cameras/top/fx", "0", {"cameras.top.fx", "px", "found 0"}},
      {file, "/cameras/top/fy", "'NaN'", {"cameras.top.fy: expected a number", "NaN"}},
      {file, "/cameras/top/cx", "1e300", {"cameras.top.cx", "1e+300"}},
      {file, "/cameras/top/width", "640.5", {"cameras.top.width", "whole number", "640.5"}},
      {file, "/cameras/top/height", "0", {"cameras.top.height", "found 0"}},
      {file, "/cameras/top/distortion", removed, {"cameras.top", "\"distortion\""}},
      {file, "/cameras/top/distortion", "[0, 0, 0, 0]", {"cameras.top.distortion", "5 numbers", "a list of 4"}},
      {file, "/cameras/top/distortion/2", "null", {"cameras.top.distortion[2]", "null"}},
      {file, "/boards", removed, {"\"boards\""}},
      {file, "/boards", "{}", {"boards: expected a list", "an object"}},
      {file, "/boards/0", "5", {"boards[0]: expected an object", "found 5"}},
      {file, "/boards/0/id", removed, {"boards[0]", "\"id\""}},
      {file, "/boards/0/id", "''", {"boards[0].id", "not empty"}},
      {file, "/boards/1/id", "'A'", {"boards[1].id", "no other", "\"A\""}},
      {file, "/boards/0/link", "'left foot'", {"boards[0].link", "name of a link", "\"left foot\""}},
      {file, "/boards/0/dictionary", "'DICT_4X4_99'", {"boards[0].dictionary", "OpenCV", "DICT_4X4_99"}},
      {file, "/boards/0/squaresX", "1", {"boards[0].squaresX", "from 2", "found 1"}},
      {file, "/boards/0/squaresY", "'5'", {"boards[0].squaresY", "whole number", "\"5\""}},
      {file, "/boards/0/squareLength", "-0.08", {"boards[0].squareLength", "-0.08"}},
      {file, "/boards/0/markerLength", "0.08", {"boards[0]", "markerLength below the squareLength", "0.08"}},
      {file, "/boards/0/firstMarkerId", "-1", {"boards[0].firstMarkerId", "-1"}},
      {file, "/boards/0/firstMarkerId", "90", {"boards[0]", "ids below 100", "17 markers", "90"}},
      {file, "/boards/0/legacyPattern", "1", {"boards[0].legacyPattern", "true or false", "found 1"}},
      {file, "/boards/1/dictionary", "'DICT_APRILTAG_25h9'", {"boards[1]", "ids below 35", "12 markers"}},
      {file, "/boards/0/placement/yaw", removed, {"boards[0].placement", "\"yaw\""}},
      {file, "/boards/0/placement/yaw", "90", {"boards[0].placement.yaw", "radians", "90"}},
      {file, "/boards/0/placement/z", "0.1", {"boards[0].placement.z", "x, y and yaw"}},
      {file, "/boards/0/placement", "[1, 2, 3]", {"boards[0].placement", "an object", "a list of 3"}},
      {capture, "/boards/0/points", "[[0, 0, 0], [1, 0, 0]]", {"captures[0].corners[0].ids[2]", "0 to 1", "found 23"}},
      {file, "/boards/1/points", "[[0, 0, 0]]", {"boards[1]", "points", "dictionary"}},
      {file, "/boards/2/points", "[]", {"boards[2].points", "at least one"}},
      {file, "/boards/2/points/0", "[0, 0]", {"boards[2].points[0]", "3 numbers", "a list of 2"}},
      {file, "/boards/2/points/0/1", "'0'", {"boards[2].points[0][1]", "\"0\""}},
      {file, "/boards/1/placementSigma", "0", {"boards[1].placementSigma", "found 0"}},
      {file, "/boards/1/placementSigma/x", "-1", {"boards[1].placementSigma.x", "-1"}},
      {file, "/boards/1/placementGuess", "true", {"boards[1].placementGuess", "an object", "true"}},
      {file, "/boards/3/placement/roll", removed, {"boards[3].placement", "\"roll\""}},
      {file, "/stances", removed, {"\"stances\""}},
      {file, "/stances/0/id", "'0'", {"stances[0].id", "whole number", "\"0\""}},
      {file, "/stances/1/id", "0", {"stances[1].id", "no other", "found 0"}},
      {file, "/stances/0/supportFoot", "'Left'", {"stances[0].supportFoot", "left, right, both, none", "\"Left\""}},
      {file, "/stances/0/placement", "{'x': 1}", {"stances[0].placement", "\"y\""}},
      {file, "/stances/1/placement", "'here'", {"stances[1].placement", "an object"}},
      {file, "/captures", removed, {"\"captures\""}},
      {file, "/captures", "{}", {"captures: expected a list"}},
      {file, "/captures/2", "null", {"captures[2]", "an object", "null"}},
      {file, "/captures/1/id", "0", {"captures[1].id", "no other", "found 0"}},
      {file, "/captures/1/supportFoot", "'left'", {"captures[1].supportFoot", "\"both\"", "stance 7", "\"left\""}},
      {capture, "/captures/0/id", removed, {"captures[0]", "\"id\""}},
      {capture, "/captures/0/id", "1.5", {"captures[0].id", "1.5"}},
      {capture, "/captures/0/pose", removed, {"captures[0] (capture 0)", "\"pose\""}},
      {capture, "/captures/0/pose", "7", {"captures[0].pose", "text"}},
      {capture, "/captures/0/repeat", removed, {"captures[0] (capture 0, pose \"P00\")", "\"repeat\""}},
      {capture, "/captures/0/repeat", "-1", {"captures[0].repeat", "-1"}},
      {capture, "/captures/0/repeatKind", "'again'", {"captures[0].repeatKind", "rest, reapproach, restand"}},
      {capture, "/captures/0/time", removed, {"\"time\""}},
      {capture, "/captures/0/time", "'noon'", {"captures[0].time", "\"noon\""}},
      {capture, "/captures/0/time", "'Infinity'", {"captures[0].time", "Infinity"}},
      {capture, "/captures/0/time", "1.7e18", {"captures[0].time", "1e+12 s", "1.7e+18"}},
      {capture, "/captures/0/camera", removed, {"\"camera\""}},
      {capture, "/captures/0/camera", "'left'", {"captures[0].camera", "`cameras`", "\"left\""}},
      {capture, "/captures/0/supportFoot", removed, {"\"supportFoot\""}},
      {capture, "/captures/0/supportFoot", "0", {"captures[0].supportFoot", "left, right, both, none"}},
      {capture, "/captures/0/stance", "77", {"captures[0].stance", "`stances`", "77"}},
      {capture, "/captures/0/joints", removed, {"\"joints\""}},
      {capture, "/captures/0/joints/measured", removed, {"captures[0].joints", "\"measured\""}},
      {capture, "/captures/0/joints/measured", "null", {"captures[0].joints.measured", "4 numbers", "null"}},
      {capture,
       "/captures/0/joints/measured",
       "[0, 0, 0]",
       {"joints.measured", "4 numbers", "a list of 3", "--skip-bad"}},
      {capture, "/captures/0/joints/measured/1", "'NaN'", {"joints.measured[1]", "a number", "NaN"}},
      {capture, "/captures/0/joints/measured/1", "43.5", {"joints.measured[1]", "radians", "43.5"}},
      {capture, "/captures/0/joints/measured/2", "0.31", {"joints.measured", "one motor", "0.31 and 0.3 rad"}},
      {capture, "/captures/0/joints/commanded", "[0, 0, 0, 0, 0]", {"joints.commanded", "a list of 5"}},
      {capture, "/captures/0/joints/commanded/3", "null", {"joints.commanded[3]", "null"}},
      {capture, "/captures/0/joints/velocity", "[]", {"joints.velocity", "a list of 0"}},
      {capture, "/captures/0/joints/velocity/0", "1e5", {"joints.velocity[0]", "rad/s", "100000"}},
      {capture, "/captures/0/joints/approach/0", "0.5", {"joints.approach[0]", "-1, 0 or +1", "0.5"}},
      {capture, "/captures/0/joints/approach/0", "2", {"joints.approach[0]", "found 2"}},
      {capture, "/captures/0/joints/temperature/0", "'hot'", {"joints.temperature[0]", "hot"}},
      {capture, "/captures/0/joints/current", "{}", {"joints.current", "an object"}},
      {capture, "/captures/0/imu", "[0, 0]", {"captures[0].imu", "an object"}},
      {capture, "/captures/0/imu/angleY", removed, {"captures[0].imu", "\"angleY\""}},
      {capture, "/captures/0/fsr", "[0, 0, 0, 0]", {"captures[0].fsr", "8 numbers", "a list of 4"}},
      {capture, "/captures/0/image", "''", {"captures[0].image", "not empty"}},
      {capture, "/captures/0/image", "'/etc/passwd'", {"captures[0].image", "inside the set's folder"}},
      {capture, "/captures/0/image", "'images/../../x.png'", {"captures[0].image", "inside the set's folder"}},
      {capture, "/captures/0/corners", "null", {"captures[0].corners", "a list", "null"}},
      {capture, "/captures/0/corners/0", "'A'", {"captures[0].corners[0]", "an object"}},
      {capture, "/captures/0/corners/0/board", "'Z'", {"corners[0].board", "`boards`", "\"Z\""}},
      {capture, "/captures/0/corners/1/board", "'A'", {"corners[1].board", "every board once"}},
      {capture, "/captures/0/corners/0/ids", removed, {"corners[0]", "\"ids\""}},
      {capture, "/captures/0/corners/0/ids/2", "24", {"corners[0].ids[2]", "from 0 to 23", "found 24"}},
      {capture, "/captures/0/corners/0/ids/2", "1", {"corners[0].ids[2]", "once", "found 1"}},
      {capture, "/captures/0/corners/0/ids/0", "0.5", {"corners[0].ids[0]", "whole number"}},
      {capture, "/captures/0/corners/0/uv", removed, {"corners[0]", "\"uv\""}},
      {capture, "/captures/0/corners/0/uv", "[[1, 2]]", {"corners[0].uv", "3 pairs", "a list of 1"}},
      {capture, "/captures/0/corners/0/uv/1", "[1, 2, 3]", {"corners[0].uv[1]", "u, v", "a list of 3"}},
      {capture, "/captures/0/corners/0/uv/1/0", "'NaN'", {"corners[0].uv[1][0]", "NaN"}},
      {capture, "/captures/0/corners/0/uv/1/0", "1100", {"corners[0].uv[1][0]", "660 px", "1100"}},
      {capture, "/captures/0/corners/0/uv/1/1", "-25", {"corners[0].uv[1][1]", "-20", "-25"}},
      {capture, "/captures/1/image", removed, {"captures[1]", "`corners`", "`image`", "neither"}},
  };
}

} // namespace naocal

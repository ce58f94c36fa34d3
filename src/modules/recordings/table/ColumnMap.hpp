#pragma once

#include "robot/Robot.hpp"

#include <array>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// A joint's column: angle = sign * factor * cell, in `unit`.
struct JointColumn {
  std::string column;
  std::string unit = "rad"; // "rad" or "deg"; "m", "cm" or "mm" of a prismatic joint
  double factor = 1;
  int sign = 1;
};

/// The columns of a marker's position in a tracker's frame.
struct PointColumns {
  std::string marker, tracker;
  std::string link;                   // that carries the marker; empty: the last link that recorded joints move
  std::array<std::string, 3> columns; // x, y, z
  std::string unit = "m";             // "m", "cm" or "mm"
};

/// The columns of a frame's pose in a tracker's frame.
struct FrameColumns {
  std::string frame, tracker;
  std::string link; // as of a marker
  std::array<std::string, 3> columns;
  std::string unit = "m";
  std::array<std::string, 4> quaternion; // w, x, y, z
};

/// Which columns of a table are joints, measured points and frames, pictures, times, poses and temperatures.
struct ColumnMap {
  std::map<std::string, JointColumn> joints; // by joint of the URDF
  std::vector<PointColumns> points;
  std::vector<FrameColumns> frames;
  std::optional<std::string> image; // name of a picture
  std::optional<std::string> time;
  std::string timeUnit = "s";                     // "s", "ms", "us" or "ns"
  std::optional<std::string> pose, repeat;        // rows of one pose were commanded to the same angles
  std::map<std::string, std::string> temperature; // by joint [degC]
};

/// Factor from a unit of length to metres. Absent for other units.
std::optional<double> metresPer(const std::string& unit);
/// Factor from a unit of time to seconds.
std::optional<double> secondsPer(const std::string& unit);

/// Reads a column map (COLUMNS.json). Throws InputError with file, path, expected and found: unknown keys, joints and
/// links, units that a joint or a point cannot have.
ColumnMap parseColumnMap(const nlohmann::json& document, const std::string& file, const Robot& robot);

/// The map as such a file.
nlohmann::ordered_json columnMapJson(const ColumnMap& map);

} // namespace naocal

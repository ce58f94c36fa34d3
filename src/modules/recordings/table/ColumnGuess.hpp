#pragma once

#include "recordings/table/ColumnMap.hpp"
#include "recordings/table/CsvTable.hpp"

namespace naocal {

/// A guessed column map, and the columns that it leaves out.
struct ColumnGuess {
  ColumnMap map;
  std::vector<std::string> unused;
};

/// Guesses a column map from a table's names and values.
///
/// Joints: columns with a joint's name; if there are none, numbered columns (q1, joint_2, theta3, axis 4, actual_q_0),
/// the n-th for the n-th joint that turns or slides and mimics none. Points: three columns that differ by x, y, z only,
/// but no turns, forces and speeds (rx, Fx, Tx beside Fx, vx); with four more for w, x, y, z of a quaternion (qw, ..) a
/// frame. Without any, the first three numbers of a pose (actual_TCP_pose_0, ..). Pictures, time, pose, repeat,
/// temperature: by their usual names; without one, pictures by cells that end in .png or .jpg. Units: from the name
/// (q1_deg, x [mm]); without one, degrees if an angle exceeds 2 pi, millimetres if a coordinate exceeds 20 m, seconds
/// unless times are so large that they count ms, us or ns since 1970.
///
/// Throws InputError if no column is a joint's.
ColumnGuess guessColumns(const CsvTable& table, const Robot& robot);

} // namespace naocal

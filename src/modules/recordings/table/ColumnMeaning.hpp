#pragma once

#include "recordings/table/ColumnMap.hpp"

#include <string>
#include <vector>

namespace naocal {

/// What a column of a table can be, and the column that is it by a map.
struct ColumnMeaning {
  std::string id;                 // "joint:shoulder_pan", "time", "point:0:x", ...: unique
  std::string words;              // "angle of joint shoulder_pan"
  std::string column;             // empty: none
  std::vector<std::string> units; // to choose from; empty: it has none
  std::string unit;               // by the map; empty without a column
};

/// Everything that a column can be, in the order of a column map: the robot's driven joints, the coordinates of the
/// map's points and frames, pictures, time, poses, repeats, and temperatures of the joints that have a column.
std::vector<ColumnMeaning> columnMeanings(const ColumnMap& map, const Robot& robot);

/// Gives a column a meaning by its id; an empty id: the column is not used. What the column was before, it is no more:
/// a point or a frame that loses a column goes, as does the temperature of a joint. `unit`: one of the meaning's;
/// empty: as before, or that of the other joints. Throws InputError for an unknown meaning or unit, and for a
/// coordinate of a point or a frame that the column is not already: these have their columns together.
void assignColumn(ColumnMap& map, const Robot& robot, const std::string& column, const std::string& id,
                  const std::string& unit = "");

} // namespace naocal

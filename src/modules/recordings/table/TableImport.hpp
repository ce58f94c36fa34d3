#pragma once

#include "recordings/ImportScene.hpp"
#include "recordings/table/ColumnMap.hpp"
#include "recordings/table/CsvTable.hpp"

#include <filesystem>

namespace naocal {

/// A set made of a table, and what it was made of.
struct TableImport {
  ImportedSet imported; // with the column map as "columns.json"
  std::size_t rows = 0;
  std::size_t withoutMeasurement = 0;       // rows that were passed over: no picture, no position
  std::vector<std::size_t> passedOver = {}; // these rows
  std::vector<std::string> guessed = {};    // what the column map does not say: links, times; a sentence each
  std::vector<std::string> failed = {};     // readings that are none (`findFailedReadings`), a sentence each
};

/// One capture for each row with a picture, a measured point or a measured frame.
///
/// Without a column for poses, neighbouring rows with equal angles are one pose, and every other row has its own; with
/// one, a pose's rows are repeats of it where it has no column for repeats: a new one whenever the angles differ from
/// those of the row before. Repeats of other angles were approached anew; those of equal angles in neighbouring rows
/// are one rest. Pictures are looked for in `pictures`. A position whose quaternion is 0, 0, 0, 0 or empty is no
/// reading, nor are those that `findFailedReadings` finds: they are left out.
///
/// Throws InputError with table, row, column, expected and found: missing columns, cells that are no numbers, angles
/// beyond two turns of a limited joint in radians (degrees?), positions beyond 1 km, positions of which a coordinate is
/// missing, quaternions far from unit length, pictures that are missing or none; and without boards for pictures.
TableImport importTable(const CsvTable& table, const ColumnMap& map, const ImportScene& scene,
                        const std::filesystem::path& pictures);

/// What became of the rows, a clause each: "50 rows, 48 captures".
std::vector<std::string> summarize(const TableImport& result);

} // namespace naocal

#include "recordings/table/TableImport.hpp"

#include "data/CaptureSetFile.hpp"
#include "fuzz/driver/Reader.hpp"
#include "recordings/TestArm.hpp"
#include "recordings/table/ColumnGuess.hpp"

namespace naocal {
namespace {

/// A table whose columns are guessed; the set that it becomes is written and read.
void readTable(std::string_view bytes) {
  static const ImportScene scene = testing::armScene();
  const CsvTable table{std::string{bytes}, "log.csv"};
  const ColumnMap map = guessColumns(table, scene.robot).map;
  const TableImport result = importTable(table, map, scene, "/nonexistent");
  parseCaptureSet(formatCaptureSet(result.imported.set), "set");
}

const Reader tableReader{"table", readTable};

} // namespace
} // namespace naocal

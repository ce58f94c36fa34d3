#include "TemporaryFolder.hpp"
#include "fuzz/driver/Reader.hpp"
#include "robot/Robot.hpp"

#include <fstream>

namespace naocal {
namespace {

/// A drawing beside NaoV5.json, which it may name as its base.
void readDrawing(std::string_view bytes) {
  static const TemporaryFolder folder;
  static const bool copied =
      std::filesystem::copy_file(configurationDirectory() / "drawings" / "NaoV5.json", folder.path() / "NaoV5.json");
  const auto file = folder.path() / "Drawing.json";
  std::ofstream{file, std::ios::binary | std::ios::trunc}.write(bytes.data(), std::streamsize(copied * bytes.size()));
  loadRobot(file);
}

const Reader drawingReader{"drawing", readDrawing};

} // namespace
} // namespace naocal

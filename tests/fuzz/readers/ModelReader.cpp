#include "estimation/ModelFile.hpp"
#include "fuzz/driver/MemoryFile.hpp"
#include "fuzz/driver/Reader.hpp"
#include "robot/Robot.hpp"

#include <nlohmann/json.hpp>

namespace naocal {
namespace {

void readModelText(std::string_view bytes) {
  static const Robot robot = loadRobot(configurationDirectory(), "V6");
  readModelFile(MemoryFile{bytes}.path(), robot);
}

const Reader modelReader{"model", readModelText};

} // namespace
} // namespace naocal

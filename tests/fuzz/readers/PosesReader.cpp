#include "fuzz/driver/MemoryFile.hpp"
#include "fuzz/driver/Reader.hpp"
#include "io/InputError.hpp"
#include "poses/PoseFile.hpp"
#include "robot/Robot.hpp"

namespace naocal {
namespace {

/// POSES.json, and a .pose file of 26 angles.
void readPoses(std::string_view bytes) {
  static const Robot robot = loadRobot(configurationDirectory(), "V6");
  const MemoryFile file{bytes};
  try {
    readAnglesFile(file.path(), robot);
    return;
  } catch (const InputError&) { // it may still be the other format
  }
  readPoseFile(file.path(), robot);
}

const Reader posesReader{"poses", readPoses};

} // namespace
} // namespace naocal

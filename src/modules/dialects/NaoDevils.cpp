#include "dialects/NaoDevils.hpp"

#include "dialects/BHuman.hpp"
#include "dialects/MapCalibration.hpp"

namespace naocal {

std::vector<DialectFile> writeNaoDevils(const RobotCalibration& calibration, const Robot& robot) {
  std::vector<DialectFile> files = writeOlderBHuman(calibration, robot);
  if (!calibration.offsets.empty()) {
    files.front().text = jointsWithLimits(calibration, robot, "", "57.2958deg");
  }
  return files;
}

ParsedCalibration parseNaoDevils(const std::string& text, const std::string& file, const Robot&) {
  return parseMapCalibration(text, file);
}

} // namespace naocal

#include "dialects/HeadExamples.hpp"
#include "dialects/heads/HeadDialects.hpp"
#include "fuzz/driver/Reader.hpp"
#include "io/InputError.hpp"

#include <stdexcept>

namespace naocal {
namespace {

const std::string fileName = "robot.file";

/// A dialect with a robot that it is made for.
struct MadeFor {
  const HeadDialect& dialect;
  Robot robot;
  HeadCamera drawn, turned;
};

std::vector<MadeFor> everyDialect() {
  RobotCalibration calibration;
  calibration.offsets = {{"yaw", 0.03}, {"pitch", -0.02}};
  calibration.cameras["left"].rotation = Eigen::Vector3d{0.01, -0.02, 0.03};
  std::vector<MadeFor> all;
  for (const HeadExample& example : headExamples()) {
    all.push_back({*findHeadDialect(example.dialect), example.robot, describeHeadCamera(example.robot, "", {}),
                   describeHeadCamera(example.robot, "", calibration)});
  }
  return all;
}

/// The input as a file of every dialect of heads. What is accepted is written, read again, and written the same.
/// Refused if all refuse it.
void readAsHeads(std::string_view bytes) {
  static const std::vector<MadeFor> all = everyDialect();
  const std::string text{bytes};
  bool isRead = false;
  for (const auto& [dialect, robot, drawn, turned] : all) {
    std::string written;
    try {
      (void)dialect.parse(text, fileName, robot, drawn);
      written = dialect.write(text, fileName, robot, turned);
    } catch (const InputError&) { // refused; another dialect may read it
      continue;
    }
    isRead = true;
    try {
      (void)dialect.parse(written, fileName, robot, drawn);
    } catch (const InputError& error) {
      throw std::logic_error{std::string{"written, then refused: "} + error.what()};
    }
    if (dialect.write(written, fileName, robot, turned) != written) {
      throw std::logic_error{"written twice, not the same"};
    }
  }
  if (!isRead) {
    throw InputError{"expected a file of a head, found none that a dialect reads"};
  }
}

const Reader headsReader{"heads", readAsHeads};

} // namespace
} // namespace naocal

#include "commands/plan/OtherRobot.hpp"

#include "io/InputError.hpp"
#include "robot/LegKinematics.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fmt/format.h>

namespace naocal {

namespace {

bool isUrdf(const std::string& robot) {
  return std::filesystem::path{robot}.extension() == ".urdf";
}

} // namespace

bool isOtherRobot(const std::string& robot) {
  return isUrdf(robot) || !hasPlannableLegs(loadRobot(configurationDirectory(), robot));
}

void refuseNaoOptions(const CLI::App& command, const std::string& robot, std::span<const NaoOption> options) {
  for (const NaoOption& option : options) {
    if (command.get_option(option.name)->count() > 0) {
      throw InputError{fmt::format("{}: {}; leave it out for {}", option.name, option.why, robot)};
    }
  }
  if (isUrdf(robot) && command.get_option("--support")->count() > 0) {
    throw InputError{
        fmt::format("--support: a scene's `supportLinks` say what a robot with a URDF stands on (--scene); "
                    "leave it out for {}",
                    robot)};
  }
}

RobotScene loadScene(const std::string& robot, const std::string& file, const std::string& support,
                     std::uint64_t seed) {
  if (support == "both") {
    throw InputError{fmt::format("--support: expected left or right for {}, found both", robot)};
  }
  const CaptureSet robotOnly = makeRobotOnly(robot, support == "right" ? SupportFoot::right : SupportFoot::left);
  return file.empty() ? makeDefaultScene(robotOnly, seed) : readRobotScene(file, robotOnly);
}

} // namespace naocal

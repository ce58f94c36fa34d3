#include "commands/plan/SimulateRobot.hpp"

#include "io/Files.hpp"
#include "io/Folders.hpp"
#include "io/InputError.hpp"
#include "robot/LegKinematics.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <fmt/format.h>

namespace naocal {

namespace {

bool isUrdf(const std::string& robot) {
  return std::filesystem::path{robot}.extension() == ".urdf";
}

struct NaoOption {
  const char *name, *why;
};
constexpr const char* ofPictures = "pictures are rendered for NAOs only";
constexpr NaoOption naoOptions[]{{"--boards", "a scene says which boards there are (--scene)"},
                                 {"--repeat-kind", "other robots rest between the samples of a pose"},
                                 {"--hidden-flaw", "name the flaw of another robot with --flaw"},
                                 {"--surveyed", "a scene says what the set places (--scene)"},
                                 {"--displaced-board", "boards stay where they are before other robots"},
                                 {"--approach-stiction-degrees", "other robots rest between the samples of a pose"},
                                 {"--images", ofPictures},
                                 {"--size", "a scene says how large pictures are (--scene)"},
                                 {"--blur", ofPictures},
                                 {"--grey-noise", ofPictures},
                                 {"--vignetting", ofPictures},
                                 {"--jpeg-quality", ofPictures}};

} // namespace

std::size_t parsePoseCount(const std::string& poses, const std::string& remark) {
  constexpr std::size_t most = 1000;
  std::size_t count = 0;
  const char* const end = poses.data() + poses.size();
  const auto [rest, error] = std::from_chars(poses.data(), end, count);
  if (rest != end || error != std::errc{} || count < 1 || count > most) {
    throw InputError{fmt::format("--poses: expected a whole number, 1 to {}, {}, found \"{}\"", most, remark, poses)};
  }
  return count;
}

bool isOtherRobot(const std::string& robot) {
  return isUrdf(robot) || !hasPlannableLegs(loadRobot(configurationDirectory(), robot));
}

void refuseNaoOptions(const CLI::App& simulator, const std::string& robot) {
  for (const NaoOption& option : naoOptions) {
    if (simulator.get_option(option.name)->count() > 0) {
      throw InputError{fmt::format("{}: {}; leave it out for {}", option.name, option.why, robot)};
    }
  }
  if (isUrdf(robot) && simulator.get_option("--support")->count() > 0) {
    throw InputError{
        fmt::format("--support: a scene's `supportLinks` say what a robot with a URDF stands on (--scene); "
                    "leave it out for {}",
                    robot)};
  }
}

SceneSimulation simulateRobot(RobotSimulation asked) {
  if (asked.support == "both") {
    throw InputError{fmt::format("--support: expected left or right for {}, found both", asked.robot)};
  }
  const CaptureSet robot =
      makeRobotOnly(asked.robot, asked.support == "right" ? SupportFoot::right : SupportFoot::left);
  asked.plan.poses = parsePoseCount(asked.poses, "for a robot that is no NAO");
  RobotScene scene =
      asked.scene.empty() ? makeDefaultScene(robot, asked.plan.seed) : readRobotScene(asked.scene, robot);
  if (asked.hasPixelNoise) {
    scene.noise.pixel = asked.pixelNoise;
  }
  if (asked.poseNoise > 0) {
    scene.noise.pose = asked.poseNoise;
  }
  return simulateScene(scene, asked.plan);
}

void copyUrdf(const std::string& folder, CaptureSet& set) {
  if (set.urdf.empty()) {
    return;
  }
  constexpr const char* name = "robot.urdf";
  const std::string text = readFile(set.folder / set.urdf);
  createFolders(folder);
  writeAtomically(std::filesystem::path{folder} / name, text);
  set.urdf = name;
  set.folder = folder;
}

} // namespace naocal

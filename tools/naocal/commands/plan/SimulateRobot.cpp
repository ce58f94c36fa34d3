#include "commands/plan/SimulateRobot.hpp"

#include "io/Files.hpp"
#include "io/Folders.hpp"
#include "io/InputError.hpp"
#include "poses/PoseFile.hpp"
#include "robot/RobotOfSet.hpp"
#include "robot/Urdf.hpp"

#include <charconv>
#include <fmt/format.h>

namespace naocal {

namespace {

constexpr NaoOption naoOptions[]{{"--boards", "a scene says which boards there are (--scene)"},
                                 {"--hidden-flaw", "name the flaw of another robot with --flaw"},
                                 {"--surveyed", "a scene says what the set places (--scene)"},
                                 {"--displaced-board", "boards stay where they are before other robots"},
                                 {"--size", "a scene says how large pictures are (--scene)"}};

/// Sets the poses of a plan: a number of random ones, or those of a file for the scene's robot on the same foot, in the
/// file's stance.
void setPoses(const std::string& poses, RobotScene& scene, ScenePlan& plan) {
  if (const auto count = parsePoseCount(poses)) {
    plan.poses = *count;
    return;
  }
  PoseFile file = readPoseFile(poses, loadRobot(scene.set));
  plan.given = std::move(file.poses);
  scene.set.stances.front().id = file.firstStance;
  for (const PlayablePose& pose : plan.given) {
    if (pose.supportFoot != scene.set.stances.front().supportFoot) {
      throw InputError{fmt::format("{}: expected poses on what the robot stands on here, found {} on another; give the "
                                   "--support or the --scene that they were planned with",
                                   poses, pose.id)};
    }
  }
}

} // namespace

std::optional<std::size_t> parsePoseCount(const std::string& poses) {
  constexpr std::size_t most = 1000;
  const bool isNegative = poses.starts_with('-');
  if (poses.find_first_not_of("0123456789", isNegative ? 1 : 0) != std::string::npos) {
    return std::nullopt;
  }
  std::size_t count = 0;
  const char* const end = poses.data() + poses.size();
  const auto [rest, error] = std::from_chars(poses.data(), end, count);
  if (rest != end || error != std::errc{} || count < 1 || count > most) {
    throw InputError{
        fmt::format("--poses: expected a whole number, 1 to {}, or a pose file, found \"{}\"", most, poses)};
  }
  return count;
}

std::span<const NaoOption> naoOptionsOfSimulate() {
  return naoOptions;
}

SceneSimulation simulateRobot(RobotSimulation asked) {
  RobotScene scene = loadScene(asked.robot, asked.scene, asked.support, asked.plan.seed);
  setPoses(asked.poses, scene, asked.plan);
  if (asked.hasPixelNoise) {
    scene.noise.pixel = asked.pixelNoise;
  }
  if (asked.poseNoise > 0) {
    scene.noise.pose = asked.poseNoise;
  }
  if (asked.approachNoise > 0) {
    scene.noise.approach = asked.approachNoise;
  }
  return simulateScene(scene, asked.plan);
}

void copyUrdf(const std::string& folder, CaptureSet& set) {
  if (set.urdf.empty()) {
    return;
  }
  constexpr const char* name = "robot.urdf";
  const std::string text = readUrdf(set.folder / set.urdf);
  createFolders(folder);
  writeAtomically(std::filesystem::path{folder} / name, text);
  set.urdf = name;
  set.folder = folder;
}

} // namespace naocal

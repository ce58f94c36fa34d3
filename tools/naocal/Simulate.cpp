#include "Commands.hpp"
#include "Sets.hpp"

#include "captures/CaptureSetFile.hpp"
#include "captures/Files.hpp"
#include "captures/InputError.hpp"
#include "geometry/Angles.hpp"
#include "synthetic/Pictures.hpp"
#include "synthetic/StandingPoses.hpp"

#include <CLI/CLI.hpp>
#include <csignal>
#include <fmt/core.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace naocal {

namespace {

struct SimulateCommand {
  std::string output, robot = "V6", size = "640x480", json;
  SupportFoot supportFoot = SupportFoot::left;
  std::size_t poses = 24;
  std::uint64_t seed = 1;
  double offsetDegrees = 6.5, mountDegrees = 2, mountMillimetres = 0, poseDegrees = 0, approachDegrees = 0;
  bool displacedBoard = false;
  SimulationPlan plan;
  Appearance appearance;
};

volatile std::sig_atomic_t interrupted = 0;

const std::map<std::string, SupportFoot> feet{
    {"left", SupportFoot::left}, {"right", SupportFoot::right}, {"both", SupportFoot::both}};
const std::map<std::string, RepeatKind> kinds{
    {"rest", RepeatKind::rest}, {"reapproach", RepeatKind::reapproach}, {"restand", RepeatKind::restand}};

/// Only an empty folder, or a set that was simulated before, may be written over.
void refuseForeignFolder(const std::filesystem::path& folder) {
  if (!std::filesystem::exists(folder)) {
    return;
  }
  if (!std::filesystem::is_directory(folder)) {
    throw InputError{fmt::format("{}: expected a folder or nothing there, found a file", folder.string())};
  }
  if (std::filesystem::is_empty(folder)) {
    return;
  }
  bool simulated = false;
  try {
    simulated = readCaptureSet(folder, BadCaptures::skip).set.bodyId.starts_with(syntheticId);
  } catch (const InputError&) { // no capture set, or a broken one
  }
  if (!simulated) {
    throw InputError{fmt::format(
        "{}: the folder holds something else than a simulated set and is left alone; name a new one", folder.string())};
  }
}

std::map<std::string, CameraIntrinsics> cameras(const std::string& size) {
  int width = 0, height = 0;
  char end = 0;
  if (std::sscanf(size.c_str(), "%dx%d%c", &width, &height, &end) != 2 || width < 64 || height < 48 || width > 8192 ||
      height > 8192) {
    throw InputError{fmt::format("--size: expected WIDTHxHEIGHT in pixels such as 640x480, found {}", size)};
  }
  return drawnCameras(width, height);
}

/// The plan with the options that are given in other units than it holds.
SimulationPlan planOf(const SimulateCommand& command) {
  SimulationPlan plan = command.plan;
  plan.offsetRange = radians(command.offsetDegrees);
  plan.mountRange = radians(command.mountDegrees);
  plan.mountShiftRange = command.mountMillimetres / 1000;
  plan.mechanics.poseScatter = radians(command.poseDegrees);
  plan.mechanics.approachScatter = radians(command.approachDegrees);
  plan.corners.displacedBoard = command.displacedBoard ? 0.03 : 0;
  plan.cameras = cameras(command.size);
  return plan;
}

/// Takes the pictures; after Ctrl-C the set keeps the captures whose picture was taken.
void takePictures(const SimulateCommand& command, Simulation& simulation) {
  const bool onTerminal = isatty(STDERR_FILENO) != 0;
  const std::size_t all = simulation.set.captures.size();
  std::size_t taken = 0;
  std::signal(SIGINT, [](int) { interrupted = 1; });
  takePictures(simulation, command.appearance, command.seed, command.output, [&](std::size_t count) {
    taken = count;
    if (onTerminal) {
      fmt::print(stderr, "\r{} of {} pictures{}", taken, all, taken == all ? "\n" : "");
    }
    return interrupted == 0;
  });
  std::signal(SIGINT, SIG_DFL);
  simulation.set.captures.resize(taken);
}

std::size_t cornerCount(const CaptureSet& set) {
  std::size_t count = 0;
  for (const Capture& capture : set.captures) {
    for (const BoardCorners& board : capture.corners.value_or(std::vector<BoardCorners>{})) {
      count += board.ids.size();
    }
  }
  return count;
}

void simulateSet(const SimulateCommand& command) {
  refuseForeignFolder(command.output);
  const Robot robot = loadRobot(configurationDirectory(), command.robot);
  SimulationPlan plan = planOf(command);
  plan.poses = standingPoses(robot, plan, command.supportFoot, command.poses, command.seed);
  Simulation simulation = simulate(robot, plan, command.seed);
  if (plan.images) {
    takePictures(command, simulation);
  }
  const std::filesystem::path truth = truthFile(command.output);
  writeCaptureSet(simulation.set, command.output);
  writeAtomically(truth, truthText(simulation.truth));
  if (!command.json.empty()) {
    writeJson({{"format", "naocal-simulation"},
               {"version", 1},
               {"set", command.output},
               {"truth", truth.string()},
               {"captures", simulation.set.captures.size()},
               {"corners", cornerCount(simulation.set)},
               {"seed", command.seed}},
              command.json);
  }
  if (command.json != "-") {
    fmt::print("{}: {} captures of {} poses in {} stance{}, {}\n", robot.model, simulation.set.captures.size(),
               plan.poses.size(), simulation.set.stances.size(), simulation.set.stances.size() == 1 ? "" : "s",
               plan.images ? "with pictures (naocal detect finds their corners)"
                           : fmt::format("{} corners", cornerCount(simulation.set)));
    fmt::print("set:   {}\ntruth: {}\n", command.output, truth.string());
    if (interrupted != 0) {
      fmt::print("stopped: the set holds the captures whose picture was taken\n");
    }
  }
}

void addNoise(CLI::App& simulator, SimulateCommand& command) {
  simulator.add_option("--offset-degrees", command.offsetDegrees, "joint offsets lie within this, both ways")
      ->check(CLI::Range(0.0, 45.0))
      ->capture_default_str();
  simulator.add_option("--mount-degrees", command.mountDegrees, "camera rotations, per axis")
      ->check(CLI::Range(0.0, 45.0))
      ->capture_default_str();
  simulator.add_option("--mount-millimetres", command.mountMillimetres, "camera shifts, per axis")
      ->check(CLI::Range(0.0, 100.0))
      ->capture_default_str();
  simulator.add_option("--pixel-noise", command.plan.corners.pixel, "of corners, per axis [px]")
      ->check(CLI::Range(0.0, 100.0))
      ->capture_default_str();
  simulator.add_flag("--heavy-tails", command.plan.corners.heavyTails, "corner noise after Student's t4, not normal");
  simulator.add_option("--gross-share", command.plan.corners.grossShare, "of corners that are grossly wrong")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  simulator.add_option("--gross-pixels", command.plan.corners.grossSize, "how wrong those are [px]")
      ->check(CLI::Range(0.0, 1000.0))
      ->capture_default_str();
  simulator.add_flag("--displaced-board", command.displacedBoard, "a board lies 3 cm off its place in one picture");
  simulator.add_option("--stiction-degrees", command.poseDegrees, "gears stick differently in every pose (1 sigma)")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str();
  simulator.add_option("--approach-stiction-degrees", command.approachDegrees, "and differently at every approach")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str();
}

void addPictures(CLI::App& simulator, SimulateCommand& command) {
  simulator.add_flag("--images", command.plan.images, "render pictures instead of giving corners");
  simulator.add_option("--size", command.size, "of the pictures, WIDTHxHEIGHT [px]")->capture_default_str();
  simulator.add_option("--blur", command.appearance.blur, "of the pictures (sigma) [px]")
      ->check(CLI::Range(0.0, 20.0))
      ->capture_default_str();
  simulator.add_option("--grey-noise", command.appearance.noise, "of the pictures (sigma) [grey levels]")
      ->check(CLI::Range(0.0, 100.0))
      ->capture_default_str();
  simulator.add_option("--vignetting", command.appearance.vignetting, "share of light lost in the corners")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  simulator.add_option("--jpeg-quality", command.appearance.jpegQuality, "compress with losses, 1 to 100")
      ->check(CLI::Range(1, 100));
}

} // namespace

void addSimulate(CLI::App& app) {
  auto command = std::make_shared<SimulateCommand>();
  CLI::App* simulator =
      app.add_subcommand("simulate", "writes a synthetic robot's captures; the truth lies beside them");
  simulator->footer("Example: naocal simulate captures/left --poses 24 --images");
  simulator->add_option("OUT", command->output, "the folder to write; the truth goes to OUT/../<name>.truth.json")
      ->required();
  simulator->add_option("--robot", command->robot, "its model")->capture_default_str();
  simulator->add_option("--support", command->supportFoot, "foot it stands on: left, right or both")
      ->transform(CLI::CheckedTransformer(feet));
  simulator->add_option("--poses", command->poses, "how many")->check(CLI::Range(1, 1000))->capture_default_str();
  simulator->add_option("--samples", command->plan.samples, "per pose")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  simulator->add_option("--repeat-kind", command->plan.repeatKind, "between samples: rest, reapproach or restand")
      ->transform(CLI::CheckedTransformer(kinds));
  simulator->add_flag("--surveyed", command->plan.surveyed, "the set states where boards and feet are");
  simulator->add_option("--seed", command->seed, "the same seed gives the same set")->capture_default_str();
  simulator->add_option("--robot-seed", command->plan.robotSeed, "takes the robot of another set, by that set's seed");
  simulator->add_option("--json", command->json, "what was written, as JSON to a file or - for standard output");
  addNoise(*simulator, *command);
  addPictures(*simulator, *command);
  simulator->callback([command] { simulateSet(*command); });
}

} // namespace naocal

#include "command-line/OptionChecks.hpp"
#include "commands/Commands.hpp"
#include "commands/plan/SimulateRobot.hpp"
#include "console/CommandLine.hpp"
#include "console/OutputFiles.hpp"
#include "console/Progress.hpp"
#include "console/print/PrintText.hpp"
#include "data/BoardListFile.hpp"
#include "data/CaptureSetFile.hpp"
#include "io/FileVersion.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "math/Angles.hpp"
#include "poses/PoseFile.hpp"
#include "simulation/Renderer.hpp"
#include "simulation/SimulatedPictures.hpp"
#include "simulation/SimulationPlan.hpp"
#include "simulation/StandingPoses.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fmt/core.h>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <thread>

namespace naocal {

namespace {

/// Options of `naocal simulate`, in degrees and millimetres.
struct SimulateOptions {
  std::string output, robot = "V6", support = "left", repeatKind = "rest", size = "640x480", json, boards, scene;
  std::string poses = "24"; // number of poses, or a pose file
  std::uint64_t seed = 1;
  double offsetDegrees = 6.5, mountDegrees = 2, mountMillimetres = 0, poseDegrees = 0, approachDegrees = 0;
  bool displacedBoard = false, samePlace = false, force = false;
  SimulationPlan plan;
  Appearance appearance;
};

const std::map<std::string, SupportFoot> feet{
    {"left", SupportFoot::left}, {"right", SupportFoot::right}, {"both", SupportFoot::both}};
const std::map<std::string, RepeatKind> kinds{
    {"rest", RepeatKind::rest}, {"reapproach", RepeatKind::reapproach}, {"restand", RepeatKind::restand}};

std::map<std::string, CameraIntrinsics> cameras(const std::string& size) {
  int width = 0, height = 0;
  char end = 0;
  if (std::sscanf(size.c_str(), "%dx%d%c", &width, &height, &end) != 2 || width < 64 || height < 48 || width > 8192 ||
      height > 8192) {
    throw InputError{fmt::format("--size: expected WIDTHxHEIGHT in pixels such as 640x480, found {}", size)};
  }
  return nominalCameras(width, height);
}

/// Adds poses: the requested number, or those of a file.
void addPoses(const SimulateOptions& options, const Robot& robot, SimulationPlan& plan) {
  if (const auto count = parsePoseCount(options.poses)) {
    plan.poses = planStandingPoses(robot, plan, feet.at(options.support), *count, options.seed);
    return;
  }
  PoseFile file = readPoseFile(options.poses, robot);
  plan.firstStance = file.firstStance;
  for (PlayablePose& pose : file.poses) {
    plan.poses.push_back({std::move(pose.id), pose.supportFoot, std::move(pose.angles), std::move(pose.approach)});
  }
}

/// ChArUco boards of a boards file or a capture set, about where it says they lie. Throws InputError for a board
/// without pattern or placement.
std::vector<Board> simulatedBoards(const std::string& place) {
  std::vector<Board> boards = readFloorBoards(place);
  for (const Board& board : boards) {
    if (!board.pattern || !board.placement) {
      throw InputError{fmt::format("{}: board {}: expected a ChArUco board with its placement or placementGuess, to be "
                                   "simulated, found none",
                                   place, board.id)};
    }
  }
  return boards;
}

void addNoise(CLI::App& simulator, SimulateOptions& options) {
  simulator.add_option("--offset-degrees", options.offsetDegrees, "joint offsets lie within this, both ways")
      ->group(expertOptions)
      ->check(number(0.0, 45.0))
      ->capture_default_str();
  simulator.add_option("--mount-degrees", options.mountDegrees, "camera rotations, per axis")
      ->group(expertOptions)
      ->check(number(0.0, 45.0))
      ->capture_default_str();
  simulator.add_option("--mount-millimetres", options.mountMillimetres, "camera shifts, per axis")
      ->group(expertOptions)
      ->check(number(0.0, 100.0))
      ->capture_default_str();
  simulator.add_option("--pixel-noise", options.plan.corners.pixel, "standard deviation of a corner, per axis [px]")
      ->group(expertOptions)
      ->check(number(0.0, 100.0))
      ->capture_default_str();
  simulator.add_flag("--heavy-tails", options.plan.corners.heavyTails, "corner noise after Student's t4, not normal")
      ->group(expertOptions);
  simulator.add_option("--gross-share", options.plan.corners.grossShare, "share of grossly wrong corners")
      ->group(expertOptions)
      ->check(number(0.0, 1.0))
      ->capture_default_str();
  simulator.add_option("--gross-pixels", options.plan.corners.grossSize, "how wrong those are [px]")
      ->group(expertOptions)
      ->check(number(0.0, 1000.0))
      ->capture_default_str();
  simulator.add_flag("--displaced-board", options.displacedBoard, "a board lies 3 cm off its place in one picture")
      ->group(expertOptions);
  simulator
      .add_option("--stiction-degrees", options.poseDegrees,
                  "deflection of the gears, drawn anew in every pose (1 sigma)")
      ->group(expertOptions)
      ->check(number(0.0, 10.0))
      ->capture_default_str();
  simulator
      .add_option("--approach-stiction-degrees", options.approachDegrees,
                  "further deflection, drawn anew at every approach (1 sigma)")
      ->group(expertOptions)
      ->check(number(0.0, 10.0))
      ->capture_default_str();
}

void addPictures(CLI::App& simulator, SimulateOptions& options) {
  simulator.add_flag("--images", options.plan.images, "render pictures instead of giving corners");
  simulator.add_option("--size", options.size, "of the pictures, WIDTHxHEIGHT [px]")
      ->type_name("WIDTHxHEIGHT")
      ->capture_default_str();
  simulator.add_option("--blur", options.appearance.blur, "blur of the pictures, sigma [px]")
      ->group(expertOptions)
      ->check(number(0.0, 20.0))
      ->capture_default_str();
  simulator.add_option("--grey-noise", options.appearance.noise, "grey noise, sigma [grey levels]")
      ->group(expertOptions)
      ->check(number(0.0, 100.0))
      ->capture_default_str();
  simulator.add_option("--vignetting", options.appearance.vignetting, "share of light lost in the corners")
      ->group(expertOptions)
      ->check(number(0.0, 1.0))
      ->capture_default_str();
  simulator.add_option("--jpeg-quality", options.appearance.jpegQuality, "compress with losses; default: without")
      ->group(expertOptions)
      ->check(wholeNumber(1, 100));
}

void addOptions(CLI::App& simulator, SimulateOptions& options) {
  simulator.add_option("OUT", options.output, "folder to write; the truth goes beside it, into OUT.truth.json")
      ->type_name("FOLDER")
      ->required();
  simulator.add_option("--robot", options.robot, "its model, or the URDF of any robot")
      ->type_name("MODEL|URDF")
      ->capture_default_str();
  simulator
      .add_option("--scene", options.scene,
                  "what measures a robot that is no NAO: cameras, boards, trackers, markers, places to touch; default: "
                  "what suits it")
      ->type_name("FILE");
  simulator.add_option("--support", options.support, "the foot it stands on")
      ->check(oneOf(std::vector<std::string>{"left", "right", "both"}))
      ->capture_default_str();
  simulator.add_option("--poses", options.poses, "how many, 1 to 1000, or a pose file to play")
      ->type_name("N|FILE")
      ->capture_default_str();
  simulator.add_option("--samples", options.plan.samples, "captures of each camera per pose")
      ->check(wholeNumber(1, 1000))
      ->capture_default_str();
  simulator
      .add_option("--boards", options.boards,
                  "boards file, or capture set, with the boards on the floor; default: four A2 boards")
      ->type_name("FILE");
  simulator.add_option("--repeat-kind", options.repeatKind, "what happens between the samples of a pose")
      ->group(expertOptions)
      ->check(oneOf(std::vector<std::string>{"rest", "reapproach", "restand"}))
      ->capture_default_str();
  simulator.add_flag("--hidden-flaw", options.plan.hiddenFlaw,
                     "a part of the leg is not as drawn; which one, only the truth file tells");
  simulator
      .add_option(
          "--flaw", options.plan.flaw,
          "hidden effect, such as gearPlay@LKneePitch: elasticity (a spring), hysteresis or gearPlay at a joint, "
          "linkLength at a length; of other robots than NAOs any effect, or several with commas")
      ->type_name("EFFECT@PLACE");
  simulator.add_option("--flaw-scale", options.plan.flawScale, "size of the hidden effect: 1 is its usual size")
      ->group(expertOptions)
      ->check(number(0.01, 10.0))
      ->capture_default_str();
  simulator.add_flag("--surveyed", options.plan.surveyed, "the set states where boards and feet are")
      ->group(expertOptions);
  simulator.add_option("--seed", options.seed, "the same seed gives the same set")->capture_default_str();
  CLI::Option* other = simulator.add_option("--robot-seed", options.plan.robotSeed,
                                            "takes the robot of another set, by that set's seed");
  simulator.add_flag("--same-place", options.samePlace, "use the board placements of the set with that --robot-seed")
      ->needs(other);
  simulator.add_flag("--force", options.force, "replace the captures that OUT holds, and their pictures");
  simulator
      .add_option("--json", options.json, "write what was simulated as JSON to this file, or - for standard output")
      ->type_name("FILE")
      ->check(replaceableFile("naocal-simulation"));
  addNoise(simulator, options);
  addPictures(simulator, options);
}

/// The simulation plan for the options, with its poses. Throws InputError for an invalid image size, number of poses or
/// pose file.
SimulationPlan makePlan(const SimulateOptions& options, const Robot& robot) {
  SimulationPlan plan = options.plan;
  if (options.samePlace) {
    plan.boardSeed = plan.robotSeed;
  }
  plan.repeatKind = kinds.at(options.repeatKind);
  plan.offsetRange = radians(options.offsetDegrees);
  plan.mountRange = radians(options.mountDegrees);
  plan.mountShiftRange = options.mountMillimetres / 1000;
  plan.mechanics.poseScatter = radians(options.poseDegrees);
  plan.mechanics.approachScatter = radians(options.approachDegrees);
  plan.corners.displacedBoard = options.displacedBoard ? 0.03 : 0;
  plan.cameras = cameras(options.size);
  if (!options.boards.empty()) {
    plan.boards = simulatedBoards(options.boards);
  }
  addPoses(options, robot, plan);
  return plan;
}

/// Throws InputError unless the folder is absent, empty, or holds a set and `force` is given.
void refuseWhatIsThere(const std::filesystem::path& folder, bool force) {
  if (folder.empty()) {
    throw InputError{"OUT: expected the name of a folder, found nothing"};
  }
  requireSameKind(truthPath(folder), "naocal-truth");
  if (!std::filesystem::exists(folder)) {
    return;
  }
  if (!std::filesystem::is_directory(folder)) {
    throw InputError{fmt::format("{}: expected a folder or nothing there, found a file", folder.string())};
  }
  if (std::filesystem::is_empty(folder)) {
    return;
  }
  if (!std::filesystem::exists(folder / "captures.json")) {
    throw InputError{fmt::format("{}: expected an empty folder, found one with something else than captures; it is "
                                 "left alone, name another one",
                                 folder.string())};
  }
  if (!force) {
    throw InputError{fmt::format("{}: expected an empty folder, found one with captures; they are left alone, name "
                                 "another folder, or replace them with --force",
                                 folder.string())};
  }
}

/// Image files inside a set's folder that its captures name; empty if the set cannot be read.
std::set<std::filesystem::path> picturesIn(const std::filesystem::path& folder) {
  std::set<std::filesystem::path> pictures;
  try {
    for (const Capture& capture : readCaptureSet(folder, BadCapturePolicy::skip).set.captures) {
      const auto picture = std::filesystem::path{capture.image}.lexically_normal();
      if (!capture.image.empty() && picture.is_relative() && *picture.begin() != "..") {
        pictures.insert(folder / picture);
      }
    }
  } catch (const InputError&) { // no set, or a broken one
  }
  return pictures;
}

/// Removes images of a replaced set that the new set does not use.
void removePictures(const std::set<std::filesystem::path>& before, const std::filesystem::path& folder) {
  const auto now = picturesIn(folder);
  for (const auto& picture : before) {
    if (!now.contains(picture)) {
      std::error_code ignored; // may not exist
      std::filesystem::remove(picture, ignored);
    }
  }
}

/// Renders the images; after Ctrl-C the set keeps the captures with an image.
void takePictures(const SimulateOptions& options, const PictureSource& source, CaptureSet& set) {
  const Progress progress{"pictures"};
  const std::size_t all = set.captures.size();
  const std::size_t threads = std::max(1U, std::thread::hardware_concurrency());
  const auto proceed = [&](std::size_t done) { return progress(done, all); };
  set.captures.resize(renderPictures(source, options.appearance, options.seed, options.output, threads, proceed));
}

/// The sum of a count over all captures.
template <typename Count> std::size_t sumOverCaptures(const CaptureSet& set, Count count) {
  std::size_t sum = 0;
  for (const Capture& capture : set.captures) {
    sum += count(capture);
  }
  return sum;
}

std::size_t cornerCount(const CaptureSet& set) {
  return sumOverCaptures(set, [](const Capture& capture) {
    std::size_t corners = 0;
    for (const BoardCorners& board : capture.corners.value_or(std::vector<BoardCorners>{})) {
      corners += board.ids.size();
    }
    return corners;
  });
}

std::size_t readingCount(const CaptureSet& set) {
  return sumOverCaptures(set, [](const Capture& capture) { return capture.points.size() + capture.frames.size(); });
}

std::size_t touchCount(const CaptureSet& set) {
  return sumOverCaptures(set, [](const Capture& capture) { return capture.contacts.size(); });
}

std::size_t poseCount(const CaptureSet& set) {
  std::set<std::string> poses;
  for (const Capture& capture : set.captures) {
    poses.insert(capture.pose);
  }
  return poses.size();
}

std::string cornersOrPictures(const SimulateOptions& options, std::size_t corners) {
  return options.plan.images ? "with pictures (naocal detect finds their corners)" : fmt::format("{} corners", corners);
}

void printPlaces(const SimulateOptions& options, const std::filesystem::path& truth) {
  printText("set:   {}\ntruth: {}\n", options.output, truth.string());
  if (Progress::wasInterrupted()) {
    printText("stopped: the set holds the captures whose picture was taken\n");
  }
}

std::vector<std::string> splitAtCommas(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream words{text};
  for (std::string part; std::getline(words, part, ',');) {
    parts.push_back(part);
  }
  return parts;
}

RobotSimulation describeRobot(const SimulateOptions& options, bool hasPixelNoise) {
  const SimulationPlan& plan = options.plan;
  return {.robot = options.robot,
          .scene = options.scene,
          .support = options.support,
          .poses = options.poses,
          .hasPixelNoise = hasPixelNoise,
          .pixelNoise = plan.corners.pixel,
          .poseNoise = radians(options.poseDegrees),
          .approachNoise = radians(options.approachDegrees),
          .plan = {.samples = plan.samples,
                   .repeatKind = kinds.at(options.repeatKind),
                   .offsetRange = radians(options.offsetDegrees),
                   .mountRange = radians(options.mountDegrees),
                   .mountShiftRange = options.mountMillimetres / 1000,
                   .flaws = splitAtCommas(plan.flaw),
                   .flawScale = plan.flawScale,
                   .images = plan.images,
                   .heavyTails = plan.corners.heavyTails,
                   .grossShare = plan.corners.grossShare,
                   .grossSize = plan.corners.grossSize,
                   .seed = options.seed,
                   .robotSeed = plan.robotSeed,
                   .sceneSeed = options.samePlace ? plan.robotSeed : std::nullopt}};
}

/// Simulates a robot that is no NAO.
void simulateOtherRobot(const SimulateOptions& options, const CLI::App& simulator) {
  refuseNaoOptions(simulator, options.robot, naoOptionsOfSimulate());
  const auto before = picturesIn(options.output);
  const bool hasPixelNoise = simulator.get_option("--pixel-noise")->count() > 0;
  SceneSimulation simulation = simulateRobot(describeRobot(options, hasPixelNoise));
  if (options.plan.images) {
    const auto sceneAt = [&](std::size_t capture) { return simulation.scenes[capture]; };
    takePictures(options, {simulation.set, simulation.lenses, sceneAt}, simulation.set);
  }
  const std::filesystem::path truth = truthPath(options.output);
  copyUrdf(options.output, simulation.set);
  writeCaptureSet(simulation.set, options.output);
  writeAtomically(truth, formatTruth(simulation.truth));
  removePictures(before, options.output);
  const std::size_t captures = simulation.set.captures.size(), corners = cornerCount(simulation.set),
                    readings = readingCount(simulation.set), touches = touchCount(simulation.set);
  if (!options.json.empty()) {
    writeJson(withFormat("naocal-simulation", {{"set", options.output},
                                               {"truth", truth.string()},
                                               {"captures", captures},
                                               {"corners", corners},
                                               {"readings", readings},
                                               {"touches", touches},
                                               {"seed", options.seed}}),
              options.json);
  }
  if (options.json != "-") {
    printText("{}: {} captures of {} poses, {}, {} tracker readings{}\n", options.robot, captures,
              poseCount(simulation.set), cornersOrPictures(options, corners), readings,
              touches > 0 ? fmt::format(", {} touches", touches) : "");
    printText("self-collision: {} of {} links have a shape to collide with\n", simulation.shapedLinks,
              simulation.links);
    printPlaces(options, truth);
  }
}

void simulateSet(const SimulateOptions& options, const CLI::App& simulator) {
  refuseWhatIsThere(options.output, options.force);
  if (isOtherRobot(options.robot)) {
    simulateOtherRobot(options, simulator);
    return;
  }
  if (!options.scene.empty()) {
    throw InputError{
        fmt::format("--scene: a {} is measured by its own cameras; name its boards with --boards", options.robot)};
  }
  const auto before = picturesIn(options.output);
  const Robot robot = loadRobot(configurationDirectory(), options.robot);
  const SimulationPlan plan = makePlan(options, robot);
  Simulation simulation = simulate(robot, plan, options.seed);
  if (plan.images) {
    takePictures(options, picturesOf(simulation), simulation.set);
  }
  const std::filesystem::path truth = truthPath(options.output);
  writeCaptureSet(simulation.set, options.output);
  writeAtomically(truth, formatTruth(simulation.truth));
  removePictures(before, options.output);
  if (!options.json.empty()) {
    writeJson(withFormat("naocal-simulation", {{"set", options.output},
                                               {"truth", truth.string()},
                                               {"captures", simulation.set.captures.size()},
                                               {"corners", cornerCount(simulation.set)},
                                               {"seed", options.seed}}),
              options.json);
  }
  if (options.json != "-") {
    printText("{}: {} captures of {} poses in {} stance{}, {}\n", robot.model, simulation.set.captures.size(),
              plan.poses.size(), simulation.set.stances.size(), simulation.set.stances.size() == 1 ? "" : "s",
              cornersOrPictures(options, cornerCount(simulation.set)));
    printPlaces(options, truth);
  }
}

} // namespace

void addSimulate(CLI::App& app) {
  auto options = std::make_shared<SimulateOptions>();
  CLI::App* simulator = app.get_subcommand("simulate");
  simulator->footer("Example: naocal simulate simulated/left --poses 24 --images\n"
                    "A robot with a URDF: naocal simulate simulated/arm --robot arm.urdf --flaw elasticity@elbow\n"
                    "The same robot in further poses, its other flags repeated:\n"
                    "  naocal simulate simulated/more --poses poses.json --seed 2 --robot-seed 1 --same-place");
  addOptions(*simulator, *options);
  simulator->callback([options, simulator] { simulateSet(*options, *simulator); });
}

} // namespace naocal

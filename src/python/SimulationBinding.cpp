#include "python/Bindings.hpp"
#include "python/Documents.hpp"
#include "python/Keywords.hpp"
#include "python/LongCall.hpp"
#include "python/SharedCaptures.hpp"

#include "data/BoardListFile.hpp"
#include "data/CaptureSetFile.hpp"
#include "io/FileKind.hpp"
#include "io/Files.hpp"
#include "math/Angles.hpp"
#include "poses/PoseFile.hpp"
#include "robot/Robot.hpp"
#include "simulation/Simulation.hpp"
#include "simulation/SimulationPlan.hpp"
#include "simulation/StandingPoses.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace naocal {

namespace py = pybind11;
using namespace pybind11::literals;

namespace {

/// A simulated set and its truth: Python's `Simulation`.
struct Simulated {
  CaptureSet set;
  std::string truth; // JSON
  SharedCaptures captures;
};

/// The value of a word of the list, such as supportFootWords. Throws InputError for another word.
template <class Word>
Word takeWord(const Keywords& given, const char* name, const std::vector<std::string_view>& words, Word usual) {
  std::string word{words[static_cast<std::size_t>(usual)]};
  given.take(name, word);
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) {
    throw InputError{fmt::format("{}: expected {}, found '{}'", name, fmt::join(words, ", "), word)};
  }
  return static_cast<Word>(found - words.begin());
}

void takeRobot(const Keywords& given, SimulationPlan& plan) {
  double offset = degrees(plan.offsetRange), mount = degrees(plan.mountRange), shift = 1000 * plan.mountShiftRange;
  given.take("offset_degrees", offset, 0.0, 45.0);
  given.take("mount_degrees", mount, 0.0, 45.0);
  given.take("mount_millimetres", shift, 0.0, 100.0);
  plan.offsetRange = given.has("offset_degrees") ? radians(offset) : plan.offsetRange;
  plan.mountRange = given.has("mount_degrees") ? radians(mount) : plan.mountRange;
  plan.mountShiftRange = shift / 1000;
  given.take("flaw", plan.flaw);
  given.take("flaw_scale", plan.flawScale, 0.01, 10.0);
  given.take("hidden_flaw", plan.hiddenFlaw);
  if (given.has("robot_seed")) {
    given.take("robot_seed", plan.robotSeed.emplace());
  }
}

void takeNoise(const Keywords& given, SimulationPlan& plan) {
  double stiction = 0, approach = 0;
  given.take("stiction_degrees", stiction, 0.0, 10.0);
  given.take("approach_stiction_degrees", approach, 0.0, 10.0);
  plan.mechanics.poseScatter = radians(stiction);
  plan.mechanics.approachScatter = radians(approach);
  given.take("pixel_noise", plan.corners.pixel, 0.0, 100.0);
  given.take("heavy_tails", plan.corners.heavyTails);
  given.take("gross_share", plan.corners.grossShare, 0.0, 1.0);
  given.take("gross_pixels", plan.corners.grossSize, 0.0, 1000.0);
  bool displaced = false;
  given.take("displaced_board", displaced);
  plan.corners.displacedBoard = displaced ? 0.03 : 0;
}

/// The poses to take: a number of them, or a pose file.
struct AskedPoses {
  std::size_t count = 24;
  SupportFoot foot = SupportFoot::left;
  std::filesystem::path file; // if not empty
};

AskedPoses readPoses(const Keywords& given) {
  AskedPoses asked;
  const py::object poses = given.object("poses");
  if (py::isinstance<py::int_>(poses) || poses.is_none()) {
    given.take("poses", asked.count, std::size_t{1}, std::size_t{1000});
    const std::vector<std::string_view> feet{supportFootWords.begin(), supportFootWords.end() - 1}; // not `none`
    asked.foot = takeWord(given, "support", feet, asked.foot);
  } else {
    given.take("poses", asked.file);
  }
  return asked;
}

void addPoses(const AskedPoses& asked, const Robot& robot, std::uint64_t seed, SimulationPlan& plan) {
  if (asked.file.empty()) {
    plan.poses = planStandingPoses(robot, plan, asked.foot, asked.count, seed);
    return;
  }
  PoseFile file = readPoseFile(asked.file, robot);
  plan.firstStance = file.firstStance;
  for (PlayablePose& pose : file.poses) {
    plan.poses.push_back({std::move(pose.id), pose.supportFoot, std::move(pose.angles), std::move(pose.approach)});
  }
}

SimulationPlan readPlan(const Keywords& given) {
  SimulationPlan plan;
  given.take("samples", plan.samples, 1, 1000);
  given.take("surveyed", plan.surveyed);
  plan.repeatKind = takeWord(given, "repeat_kind", repeatKindWords, RepeatKind::rest);
  takeRobot(given, plan);
  takeNoise(given, plan);
  bool samePlace = false;
  given.take("same_place", samePlace);
  plan.boardSeed = samePlace ? plan.robotSeed : std::nullopt;
  return plan;
}

std::shared_ptr<Simulated> simulateCaptures(const py::kwargs& keywords) {
  const Keywords given{keywords};
  std::string model = "V6", name = "simulated";
  std::uint64_t seed = 1;
  given.take("robot", model);
  given.take("seed", seed);
  given.take("name", name);
  std::optional<std::filesystem::path> configuration;
  if (given.has("configuration")) {
    given.take("configuration", configuration.emplace());
  }
  const AskedPoses poses = readPoses(given);
  SimulationPlan plan = readPlan(given);
  return LongCall{}.run([&] {
    const Robot robot = loadRobot(findConfiguration(configuration), model);
    addPoses(poses, robot, seed, plan);
    Simulation simulation = simulate(robot, plan, seed);
    SharedCaptures captures = parseCaptures(formatCaptureSet(simulation.set), name, robot);
    return std::make_shared<Simulated>(
        Simulated{std::move(simulation.set), formatTruth(simulation.truth), std::move(captures)});
  });
}

/// Writes the set and, beside it, its truth. Throws InputError unless the folder is absent or empty.
void writeSet(const Simulated& simulated, const std::filesystem::path& folder) {
  if (folder.empty()) {
    throw InputError{"folder: expected the name of a folder, found nothing"};
  }
  if (std::filesystem::exists(folder) &&
      !(std::filesystem::is_directory(folder) && std::filesystem::is_empty(folder))) {
    throw InputError{fmt::format("{}: expected no such folder or an empty one, found something there; it is left "
                                 "alone, name another folder",
                                 folder.string())};
  }
  const std::filesystem::path truth = truthPath(folder);
  requireSameKind(truth, "naocal-truth");
  writeCaptureSet(simulated.set, folder);
  writeAtomically(truth, simulated.truth);
}

} // namespace

void bindSimulation(py::module_& module) {
  py::class_<Simulated, std::shared_ptr<Simulated>>(module, "Simulation",
                                                    "A simulated robot's captures, and the truth about it.")
      .def_property_readonly(
          "captures", [](const Simulated& self) { return std::const_pointer_cast<Captures>(self.captures); },
          "Captures.")
      .def_property_readonly(
          "truth", [](const Simulated& self) { return parseDocument(self.truth); },
          "The truth file of 'naocal simulate', as a dictionary.")
      .def("write", writeSet, "folder"_a,
           "Writes captures.json into the folder, and the truth beside it into FOLDER.truth.json, as 'naocal simulate' "
           "does. InputError unless the folder is absent or empty.")
      .def("__repr__", [](const Simulated& self) {
        return fmt::format("<naocal.Simulation: {} captures>", self.set.captures.size());
      });
  module.def("simulate", simulateCaptures);
}

} // namespace naocal

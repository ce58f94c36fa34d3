#include "Commands.hpp"
#include "Outputs.hpp"
#include "Progress.hpp"
#include "Sets.hpp"
#include "SimulateOptions.hpp"

#include "data/CaptureSetFile.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "simulation/SimulatedPictures.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

namespace naocal {

namespace {

/// Only an empty folder is written into unasked; with --force a set is replaced, but nothing else is.
void refuseWhatIsThere(const std::filesystem::path& folder, bool force) {
  if (folder.empty()) {
    throw InputError{"OUT: expected the name of a folder, found nothing"};
  }
  refuseAnotherKind(truthFile(folder), "naocal-truth");
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

/// The pictures inside a set's folder that its captures name; none where the set cannot be read.
std::set<std::filesystem::path> picturesIn(const std::filesystem::path& folder) {
  std::set<std::filesystem::path> pictures;
  try {
    for (const Capture& capture : readCaptureSet(folder, BadCaptures::skip).set.captures) {
      const auto picture = std::filesystem::path{capture.image}.lexically_normal();
      if (!capture.image.empty() && picture.is_relative() && *picture.begin() != "..") {
        pictures.insert(folder / picture);
      }
    }
  } catch (const InputError&) { // there is no set, or a broken one
  }
  return pictures;
}

/// Else the pictures of the set that was replaced would lie among the others and belong to nothing.
void removePictures(const std::set<std::filesystem::path>& before, const std::filesystem::path& folder) {
  const auto now = picturesIn(folder);
  for (const auto& picture : before) {
    if (!now.contains(picture)) {
      std::error_code ignored; // it may be gone
      std::filesystem::remove(picture, ignored);
    }
  }
}

/// Takes the pictures; after Ctrl-C the set keeps the captures whose picture was taken.
void takePictures(const SimulateOptions& options, Simulation& simulation) {
  const Progress progress{"pictures"};
  const std::size_t all = simulation.set.captures.size();
  const std::size_t threads = std::max(1U, std::thread::hardware_concurrency());
  const auto proceed = [&](std::size_t done) { return progress(done, all); };
  simulation.set.captures.resize(
      takePictures(simulation, options.appearance, options.seed, options.output, threads, proceed));
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

void simulateSet(const SimulateOptions& options) {
  refuseWhatIsThere(options.output, options.force);
  const auto before = picturesIn(options.output);
  const Robot robot = loadRobot(configurationDirectory(), options.robot);
  const SimulationPlan plan = planOf(options, robot);
  Simulation simulation = simulate(robot, plan, options.seed);
  if (plan.images) {
    takePictures(options, simulation);
  }
  const std::filesystem::path truth = truthFile(options.output);
  writeCaptureSet(simulation.set, options.output);
  writeAtomically(truth, truthText(simulation.truth));
  removePictures(before, options.output);
  if (!options.json.empty()) {
    writeJson({{"format", "naocal-simulation"},
               {"version", 1},
               {"set", options.output},
               {"truth", truth.string()},
               {"captures", simulation.set.captures.size()},
               {"corners", cornerCount(simulation.set)},
               {"seed", options.seed}},
              options.json);
  }
  if (options.json != "-") {
    fmt::print("{}: {} captures of {} poses in {} stance{}, {}\n", robot.model, simulation.set.captures.size(),
               plan.poses.size(), simulation.set.stances.size(), simulation.set.stances.size() == 1 ? "" : "s",
               plan.images ? "with pictures (naocal detect finds their corners)"
                           : fmt::format("{} corners", cornerCount(simulation.set)));
    fmt::print("set:   {}\ntruth: {}\n", options.output, truth.string());
    if (Progress::interrupted()) {
      fmt::print("stopped: the set holds the captures whose picture was taken\n");
    }
  }
}

} // namespace

void addSimulate(CLI::App& app) {
  auto options = std::make_shared<SimulateOptions>();
  CLI::App* simulator =
      app.add_subcommand("simulate", "writes a synthetic robot's captures; the truth lies beside them");
  simulator->footer("Example: naocal simulate simulated/left --poses 24 --images\n"
                    "The same robot in further poses, its other flags repeated:\n"
                    "  naocal simulate simulated/more --poses poses.json --seed 2 --robot-seed 1 --same-place");
  addOptions(*simulator, *options);
  simulator->callback([options] { simulateSet(*options); });
}

} // namespace naocal

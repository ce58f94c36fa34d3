#include "Commands.hpp"
#include "Progress.hpp"
#include "Sets.hpp"
#include "SimulateOptions.hpp"

#include "captures/CaptureSetFile.hpp"
#include "captures/Files.hpp"
#include "captures/InputError.hpp"
#include "synthetic/Pictures.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>
#include <thread>

namespace naocal {

namespace {

/// Only an empty folder, or a set that was simulated before, may be written over.
void refuseForeignFolder(const std::filesystem::path& folder) {
  if (folder.empty()) {
    throw InputError{"OUT: expected the name of a folder, found nothing"};
  }
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
  refuseForeignFolder(options.output);
  const Robot robot = loadRobot(configurationDirectory(), options.robot);
  const SimulationPlan plan = planOf(options, robot);
  Simulation simulation = simulate(robot, plan, options.seed);
  if (plan.images) {
    takePictures(options, simulation);
  }
  const std::filesystem::path truth = truthFile(options.output);
  writeCaptureSet(simulation.set, options.output);
  writeAtomically(truth, truthText(simulation.truth));
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
  simulator->footer("Example: naocal simulate captures/left --poses 24 --images\n"
                    "The same robot in further poses, its other flags repeated:\n"
                    "  naocal simulate captures/more --poses poses.json --seed 2 --robot-seed 1 --same-place");
  addOptions(*simulator, *options);
  simulator->callback([options] { simulateSet(*options); });
}

} // namespace naocal

#include "Commands.hpp"
#include "captures/Files.hpp"
#include "geometry/Angles.hpp"
#include "poses/BoardPlaces.hpp"
#include "poses/PlanFile.hpp"
#include "synthetic/SimulationPlan.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/core.h>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

const std::map<std::string, Criterion> criteria{
    {"D", Criterion::determinant}, {"A", Criterion::trace}, {"E", Criterion::eigenvalue}, {"worst", Criterion::worst}};
const std::map<std::string, SupportFoot> feet{{"left", SupportFoot::left}, {"right", SupportFoot::right}};
const std::map<std::string, Sampling> samplings{
    {"even", Sampling::even}, {"grid", Sampling::grid}, {"random", Sampling::random}};

void printSieve(const Sieve& sieve) {
  fmt::print("\n{:>10} attitudes drawn\n{:>10} the legs reach them, clear of the joints' limits\n"
             "{:>10} no part touches another\n{:>10} stand, with joint errors too\n{:>10} see a board\n\n",
             sieve.generated, sieve.reachable, sieve.collisionFree, sieve.stable, sieve.seeing);
}

void printSigmas(const PosePlan& plan) {
  double worst = 0;
  for (const auto& [joint, sigma] : plan.sigma) {
    worst = std::max(worst, sigma);
  }
  fmt::print("how well these {} poses tell the offsets (1 sigma, one picture of each camera per pose):\n",
             plan.poses.size());
  fmt::print("  {:<14} {:>11}    {:>9}    {}\n", "", "as drawn", "worn", "cameras and boards known");
  for (const auto& [joint, sigma] : plan.sigma) {
    std::string bar;
    for (int i = 0; i < static_cast<int>(std::lround(20 * sigma / worst)); ++i) {
      bar += "█";
    }
    fmt::print("  {:<14} {:>9.3f} °    {:>7.3f} °    {:>5.3f} °  {}\n", joint, degrees(sigma),
               degrees(plan.sigmaOfRobots.at(joint)), degrees(plan.sigmaKnown.at(joint)), bar);
  }
}

/// The floor from above, the robot looks up: a character is 6 cm wide and 12 cm high.
void printFloor(const PosePlan& plan) {
  constexpr int rows = 14, columns = 45, ahead = 11; // rows before the robot
  std::vector<std::string> floor(rows, std::string(columns, '.'));
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      for (const Board& board : plan.boards) {
        if (depthInside(sheet(board), {0.12 * (ahead - row), 0.06 * (columns / 2 - column)}) >= 0) {
          floor[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = board.id.front();
        }
      }
    }
  }
  floor[ahead][columns / 2] = '^';
  fmt::print("\nwhere to lay the boards (^ the foot it stands on, looking up; a dot is 6 cm by 12 cm):\n");
  for (const std::string& row : floor) {
    fmt::print("  {}\n", row);
  }
  for (const Board& board : plan.boards) {
    const Placement& place = *board.placement;
    fmt::print("  {}: its corner {:5.2f} m ahead, {:5.2f} m to the {}, turned by {:4.0f} °\n", board.id, place.x,
               std::abs(place.y), place.y >= 0 ? "left " : "right", degrees(place.yaw));
  }
}

void printWay(const PosePlan& plan) {
  double seconds = 0;
  std::size_t missing = 0, round = 0;
  for (std::size_t i = 1; i < plan.ways.size(); ++i) {
    seconds += plan.ways[i] ? plan.ways[i]->seconds : 0;
    missing += plan.ways[i] ? 0 : 1;
    round += plan.ways[i] && !plan.ways[i]->via.empty() ? 1 : 0;
  }
  fmt::print("\n{:.0f} s on the way from pose to pose; {} of {} ways lead straight on", seconds,
             plan.ways.size() - 1 - missing - round, plan.ways.size() - 1);
  if (round > 0) {
    fmt::print(", {} by other postures (\"via\")", round);
  }
  if (missing > 0) {
    fmt::print(", {} are not safe: stand on both feet in between", missing);
  }
  fmt::print("\n");
}

struct PosesCommand {
  std::string robot = "V6", output, poseFiles;
  double jointErrorDegrees = 6.5;
  PlanOptions plan;

  void run() {
    const Robot drawn = loadRobot(configurationDirectory(), robot);
    plan.poses.limitMargin = plan.poses.stability.jointError = radians(jointErrorDegrees);
    const SimulationPlan scene;
    const PosePlan result = posePlan(drawn, scene.boards, scene.cameras, plan,
                                     [](const std::string& what) { fmt::print(stderr, "{}\n", what); });
    printSieve(result.sieve);
    printSigmas(result);
    printFloor(result);
    printWay(result);
    writeAtomically(output, planJson(result, drawn).dump(1) + "\n");
    fmt::print("{} holds the poses and where the boards are\n", output);
    if (!poseFiles.empty()) {
      writePoseFiles(result, drawn, poseFiles);
      fmt::print("{} holds a .pose file for each\n", poseFiles);
    }
  }
};

} // namespace

void addPoses(CLI::App& app) {
  const auto command = std::make_shared<PosesCommand>();
  PlanOptions& plan = command->plan;
  plan.poses.count = 8;
  plan.poses.tries = 1'000'000;
  plan.poses.sampling = Sampling::even;
  CLI::App* const poses = app.add_subcommand("poses", "plans poses worth taking, and where to lay the boards");
  poses->add_option("-o,--output", command->output, "POSES.json, to be written")->required();
  poses->add_option("--pose-files", command->poseFiles, "a folder for HULKs' .pose files too");
  poses->add_option("--robot", command->robot, "its model")->capture_default_str();
  poses->add_option("--support", plan.poses.supportFoot, "the foot to stand on")
      ->transform(CLI::CheckedTransformer(feet, CLI::ignore_case));
  poses->add_option("--candidates", plan.poses.tries, "attitudes to draw and sieve")
      ->capture_default_str()
      ->check(CLI::Range(1, 100'000'000));
  poses->add_option("--sampling", plan.poses.sampling, "how their ranges are filled")
      ->transform(CLI::CheckedTransformer(samplings, CLI::ignore_case));
  poses->add_option("--select", plan.poses.count, "poses to plan")->capture_default_str()->check(CLI::Range(1, 1000));
  poses->add_option("--criterion", plan.criterion, "what to make small: volume, mean, worst direction or worst joint")
      ->transform(CLI::CheckedTransformer(criteria));
  poses->add_flag("--known", plan.known, "plan for cameras and boards whose places are known");
  poses->add_flag("!--fixed-boards", plan.moveBoards, "the boards remain where they are drawn");
  poses->add_option("--joint-error", command->jointErrorDegrees, "how far joints may be off, each way [degrees]")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 20.0));
  poses->add_option("--seed", plan.poses.seed, "the same seed plans the same")->capture_default_str();
  poses->callback([command] { command->run(); });
  poses->footer("Example: naocal poses -o poses.json --select 8, then naocal simulate set --poses poses.json");
}

} // namespace naocal

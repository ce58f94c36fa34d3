#include "Commands.hpp"
#include "PlanStory.hpp"
#include "captures/Files.hpp"
#include "geometry/Angles.hpp"
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

const std::map<std::string, SupportFoot> feet{{"left", SupportFoot::left}, {"right", SupportFoot::right}};
const std::map<std::string, Sampling> samplings{
    {"even", Sampling::even}, {"grid", Sampling::grid}, {"random", Sampling::random}};

std::map<std::string, Criterion> criteria() {
  std::map<std::string, Criterion> result;
  for (std::size_t i = 0; i < criterionNames.size(); ++i) {
    result[std::string{criterionNames[i]}] = static_cast<Criterion>(i);
  }
  return result;
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
    printPlan(result);
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
  poses
      ->add_option(
          "--criterion", plan.criterion,
          "what to make small: D volume, A mean, E worst direction, the worst joint; thesis: what looks alike to "
          "the cameras, poses selected only")
      ->transform(CLI::CheckedTransformer(criteria()));
  poses->add_flag("--compare", plan.compare, "what every criterion selects among the same candidates");
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

#include "Commands.hpp"
#include "Outputs.hpp"
#include "PlanInputs.hpp"
#include "PlanStory.hpp"
#include "Sets.hpp"
#include "io/InputError.hpp"
#include "math/Angles.hpp"
#include "poses/PoseFile.hpp"
#include "poses/criteria/PlanOptions.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

const std::map<std::string, SupportFoot> supportFeet{
    {"left", SupportFoot::left}, {"right", SupportFoot::right}, {"both", SupportFoot::both}};
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
  std::string robot = "V6", output, poseFiles, boards, extend;
  double jointErrorDegrees = 6.5, sigmaDegrees = 0.2;
  std::vector<std::string> weights;
  PlanOptions plan;

  void run() {
    const Robot drawn = loadRobot(configurationDirectory(), robot);
    if (plan.mirrored && plan.poses.supportFoot == SupportFoot::both) {
      throw InputError{"--mirror: expected --support left or right, found both; poses on both feet look at both legs"};
    }
    if (plan.criterion == Criterion::discriminate && plan.effects.empty()) {
      throw InputError{"--criterion discriminate: expected --effects with two effects to tell apart, found none"};
    }
    plan.poses.limitMargin = plan.poses.stability.jointError = radians(jointErrorDegrees);
    plan.sigma = radians(sigmaDegrees);
    plan.weights = readWeights(weights);
    PlannedScene scene = boards.empty() ? plannedScene() : plannedScene(boards);
    if (!extend.empty()) {
      extendPlan(extend, drawn, scene.boards, plan);
    }
    const PosePlan result = posePlan(drawn, scene.boards, scene.cameras, plan,
                                     [](const std::string& what) { fmt::print(stderr, "{}\n", what); });
    printPlan(result);
    writeJson(planJson(result, drawn), output);
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
  poses->add_option("-o,--output", command->output, "POSES.json, to be written")
      ->required()
      ->check(replaces("naocal-poses"));
  poses->add_option("--pose-files", command->poseFiles, "a folder for HULKs' .pose files too");
  poses->add_option("--robot", command->robot, "its model")->capture_default_str();
  poses->add_option("--support", plan.poses.supportFoot, "the foot to stand on: left, right or both")
      ->transform(CLI::CheckedTransformer(supportFeet, CLI::ignore_case));
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
          "the cameras, poses selected only; discriminate: which of two effects is there; time: seconds to play")
      ->transform(CLI::CheckedTransformer(criteria()));
  poses->add_option("--sigma", command->sigmaDegrees, "that --criterion time must reach for every offset [degrees]")
      ->capture_default_str()
      ->check(CLI::Range(0.001, 10.0));
  poses
      ->add_option("--effects", plan.effects,
                   "two, such as elasticity@LKneePitch,backlash@LKneePitch: how well the poses "
                   "tell them apart")
      ->delimiter(',')
      ->expected(2);
  poses->add_option("--weight", command->weights,
                    "NAME=NUMBER: how much a joint or camera counts in the thesis's criterion; 1 if not given");
  poses->add_flag("--mirror", plan.mirrored,
                  "boards lie alike to the left and right, and every pose's mirror image is added for the other leg");
  poses->add_option("--extend", command->extend, "POSES.json: its poses stay, --select as many more; boards stay, too")
      ->excludes("--mirror");
  poses->add_option(
      "--boards", command->boards,
      "a capture set whose boards and cameras to plan for, placements seen from the sole; else four A2 boards");
  poses->add_flag("--whole-boards", plan.poses.sight.wholeBoards,
                  "a board counts only where it is wholly in the picture");
  poses->add_option("--worn", plan.wornRobots, "robots with joint errors that poses and boards are refined for besides")
      ->capture_default_str()
      ->check(CLI::Range(0, 100));
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

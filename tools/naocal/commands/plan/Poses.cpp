#include "command-line/OptionChecks.hpp"
#include "commands/Commands.hpp"
#include "commands/plan/PosesOfRobot.hpp"
#include "console/CommandLine.hpp"
#include "console/OutputFiles.hpp"
#include "console/PdfFiles.hpp"
#include "console/print/PrintPlan.hpp"
#include "console/print/PrintText.hpp"
#include "data/BoardListFile.hpp"
#include "data/CaptureSetFile.hpp"
#include "io/InputError.hpp"
#include "math/Angles.hpp"
#include "poses/PoseFile.hpp"
#include "poses/PosePlan.hpp"
#include "poses/criteria/PlanOptions.hpp"
#include "print/FloorPlan.hpp"
#include "simulation/SimulationPlan.hpp"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <fmt/core.h>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace naocal {

namespace {

/// Four A2 boards around the robot, nominal cameras.
PlanInputs defaultPlanInputs() {
  const SimulationPlan usual;
  return {usual.boards, usual.cameras};
}

/// Boards on the floor of a boards file, with nominal cameras, or of a capture set, with its own; guessed placements
/// serve as starting values. Throws InputError if no board lies on the floor.
PlanInputs readPlanInputs(const std::string& place) {
  const bool isSet = std::filesystem::is_directory(place);
  return {readFloorBoards(place),
          isSet ? readCaptureSet(place, BadCapturePolicy::skip).set.cameras : defaultPlanInputs().cameras};
}

/// Keeps the poses and board placements of an earlier plan. Throws InputError if the boards differ, or its poses are on
/// another foot.
void extendPlan(const std::string& earlier, const Robot& robot, std::vector<Board>& boards, PlanOptions& plan) {
  const PoseFile file = readPoseFile(earlier, robot);
  for (const PlayablePose& pose : file.poses) {
    if (pose.supportFoot != plan.poses.supportFoot) {
      throw InputError{fmt::format("{}: expected poses on the foot of --support, found {} on another; extend a plan of "
                                   "one foot",
                                   earlier, pose.id)};
    }
    plan.kept.push_back(pose.angles);
  }
  for (Board& board : boards) {
    const auto place = file.boards.find(board.id);
    if (place == file.boards.end()) {
      throw InputError{fmt::format("{}: expected where board {} lies, found nothing; name the set that has the plan's "
                                   "boards with --boards",
                                   earlier, board.id)};
    }
    board.placement = place->second;
  }
  plan.moveBoards = false;
}

/// Parses NAME=NUMBER, NAME being a joint or camera of the robot. Throws InputError for anything else.
std::map<std::string, double> readWeights(const std::vector<std::string>& texts, const Robot& robot) {
  std::map<std::string, double> result;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    char* end = nullptr;
    const double weight = equals == std::string::npos ? -1 : std::strtod(text.c_str() + equals + 1, &end);
    if (!(weight >= 0) || *end != '\0' || end == text.c_str() + equals + 1) {
      throw InputError{fmt::format("--weight: expected NAME=NUMBER such as LKneePitch=2, found {}", text)};
    }
    const std::string name = text.substr(0, equals);
    if (!robot.jointIndex(name) && !robot.cameraIndex(name)) {
      throw InputError{fmt::format("--weight: expected the name of a joint or camera of the robot, found {}", name)};
    }
    result[name] = weight;
  }
  return result;
}

const std::map<std::string, SupportFoot> supportFeet{
    {"left", SupportFoot::left}, {"right", SupportFoot::right}, {"both", SupportFoot::both}};
const std::map<std::string, SamplingMethod> samplings{
    {"even", SamplingMethod::even}, {"grid", SamplingMethod::grid}, {"random", SamplingMethod::random}};

std::map<std::string, Criterion> criteria() {
  std::map<std::string, Criterion> result;
  for (std::size_t i = 0; i < criterionNames.size(); ++i) {
    result[std::string{criterionNames[i]}] = static_cast<Criterion>(i);
  }
  return result;
}

struct PosesCommand {
  std::string robot = "V6", scene, output, poseFiles, boards, extend, floor;
  double jointErrorDegrees = 6.5, sigmaDegrees = 0.2;
  std::vector<std::string> weights;
  PlanOptions plan;

  void run(const CLI::App& poses) {
    if (isOtherRobot(robot)) {
      runOtherRobot(poses);
      return;
    }
    if (!scene.empty()) {
      throw InputError{
          fmt::format("--scene: a {} is measured by its own cameras; name its boards with --boards", robot)};
    }
    if (!plan.effects.empty() && plan.effects.size() != 2) {
      throw InputError{
          fmt::format("--effects: expected two effects to tell apart for a NAO, found {}", plan.effects.size())};
    }
    const Robot drawn = loadRobot(configurationDirectory(), robot);
    if (plan.mirrored && plan.poses.supportFoot == SupportFoot::both) {
      throw InputError{"--mirror: expected --support left or right, found both; poses on both feet look at both legs"};
    }
    if (plan.criterion == Criterion::discriminate && plan.effects.empty()) {
      throw InputError{"--criterion discriminate: expected --effects with two effects to tell apart, found none"};
    }
    plan.poses.limitMargin = plan.poses.stability.jointError = radians(jointErrorDegrees);
    plan.sigma = radians(sigmaDegrees);
    plan.weights = readWeights(weights, drawn);
    PlanInputs inputs = boards.empty() ? defaultPlanInputs() : readPlanInputs(boards);
    if (!extend.empty()) {
      extendPlan(extend, drawn, inputs.boards, plan);
    }
    const PosePlan result =
        planPoses(drawn, std::move(inputs), plan, [](const std::string& what) { printText(stderr, "{}\n", what); });
    printPlan(result);
    writeJson(planJson(result, drawn), output);
    printText("{} holds the poses and where the boards are\n", output);
    if (!floor.empty()) {
      PdfDocument pdf{floorPdfCreator, "Floor plan of naocal poses"};
      addFloorPlan(pdf, result, drawn);
      writePdf(floor, pdf.finish(), floorPdfCreator);
      printText("{} shows where to lay the boards, to print\n", floor);
    }
    if (!poseFiles.empty()) {
      writePoseFiles(result, drawn, poseFiles);
      printText("{} holds a .pose file for each\n", poseFiles);
    }
  }

  void runOtherRobot(const CLI::App& poses) const {
    refuseNaoOptions(poses, robot, naoOptionsOfPoses());
    PosesOfRobot asked{.robot = robot,
                       .scene = scene,
                       .support = std::string{supportFootWords[static_cast<std::size_t>(plan.poses.supportFoot)]},
                       .output = output,
                       .plan = {.count = plan.poses.count, .criterion = plan.criterion, .effects = plan.effects},
                       .candidates = {.seed = plan.poses.seed}};
    if (poses.get_option("--candidates")->count() > 0) {
      asked.candidates.draws = plan.poses.maxAttempts;
    }
    planPosesOfRobot(asked);
  }
};

} // namespace

void addPoses(CLI::App& app) {
  const auto command = std::make_shared<PosesCommand>();
  PlanOptions& plan = command->plan;
  plan.poses.count = 8;
  plan.poses.maxAttempts = 1'000'000;
  plan.poses.sampling = SamplingMethod::even;
  CLI::App* const poses = app.get_subcommand("poses");
  poses->add_option("-o,--output", command->output, "POSES.json, to be written")
      ->type_name("FILE")
      ->required()
      ->check(replaceableFile("naocal-poses"));
  poses->add_option("--pose-files", command->poseFiles, "a folder for HULKs' .pose files too")->type_name("FOLDER");
  poses
      ->add_option("--floor", command->floor,
                   "PLAN.pdf, to be written: the floor with boards, feet and distances, to print")
      ->type_name("FILE")
      ->check(replaceablePdf(floorPdfCreator));
  poses->add_option("--robot", command->robot, "its model, or the URDF of any robot")
      ->type_name("MODEL|URDF")
      ->capture_default_str();
  poses
      ->add_option("--scene", command->scene,
                   "what measures a robot that is no NAO: cameras, boards, trackers, markers; default: what suits it")
      ->type_name("FILE");
  poses->add_option("--support", plan.poses.supportFoot, "the foot to stand on")
      ->transform(oneOf(supportFeet))
      ->default_str("left");
  poses
      ->add_option("--candidates", plan.poses.maxAttempts,
                   "candidate poses to sample and filter; of robots other than NAOs at most 100000 unless given")
      ->group(expertOptions)
      ->capture_default_str()
      ->check(wholeNumber(1, 100'000'000));
  poses->add_option("--sampling", plan.poses.sampling, "how the ranges of poses are sampled")
      ->group(expertOptions)
      ->transform(oneOf(samplings))
      ->default_str("even");
  poses->add_option("--select", plan.poses.count, "poses to plan")->capture_default_str()->check(wholeNumber(1, 1000));
  poses
      ->add_option(
          "--criterion", plan.criterion,
          "what to minimise. Of the offsets' covariance: D its determinant, A its trace, E its largest eigenvalue, "
          "worst the largest variance of a joint. thesis: the thesis's measure of joints that look alike (selects "
          "poses, does not refine). discriminate: confusion of the two --effects. time: seconds to play, down to "
          "--sigma")
      ->type_name("NAME")
      ->group(expertOptions)
      ->transform(oneOf(criteria()))
      ->default_str("worst");
  poses->add_option("--sigma", command->sigmaDegrees, "that --criterion time must reach for every offset [degrees]")
      ->group(expertOptions)
      ->capture_default_str()
      ->check(number(0.001, 10.0));
  poses
      ->add_option("--effects", plan.effects,
                   "two effects, such as elasticity@LKneePitch,backlash@LKneePitch; reports how well the "
                   "poses distinguish them. Of other robots than NAOs: effects that the poses tell as well")
      ->type_name("EFFECT@PLACE")
      ->group(expertOptions)
      ->delimiter(',');
  poses
      ->add_option(
          "--weight", command->weights,
          "NAME=NUMBER: weight of a joint or camera in --criterion thesis; 1 if not given, ignored by other criteria")
      ->type_name("NAME=NUMBER")
      ->group(expertOptions);
  poses->add_flag("--mirror", plan.mirrored,
                  "boards lie alike to the left and right, and every pose's mirror image is added for the other leg");
  poses
      ->add_option("--extend", command->extend,
                   "POSES.json, the plan to extend: its poses and boards stay, --select more poses are added")
      ->type_name("FILE")
      ->excludes("--mirror");
  poses
      ->add_option("--boards", command->boards,
                   "boards file, or capture set, with the boards (of a set also the cameras) to plan for, placements "
                   "in the frame of "
                   "the support sole; default: four A2 boards")
      ->type_name("FILE");
  poses
      ->add_flag("--whole-boards", plan.poses.sight.wholeBoards,
                 "a board counts only where it is wholly in the picture")
      ->group(expertOptions);
  poses
      ->add_option("--worn", plan.perturbedRobots,
                   "number of robots with random joint errors for which the plan must also hold")
      ->group(expertOptions)
      ->capture_default_str()
      ->check(wholeNumber(0, 100));
  poses->add_flag("--compare", plan.compare, "also show what every criterion selects among the same candidates")
      ->group(expertOptions);
  poses->add_flag("--known", plan.known, "assume camera mounts and board placements are known")->group(expertOptions);
  poses->add_flag("!--fixed-boards", plan.moveBoards, "keep the boards where they are")->group(expertOptions);
  poses->add_option("--joint-error", command->jointErrorDegrees, "largest joint error, both ways [degrees]")
      ->group(expertOptions)
      ->capture_default_str()
      ->check(number(0.0, 20.0));
  poses->add_option("--seed", plan.poses.seed, "the same seed plans the same")
      ->group(expertOptions)
      ->capture_default_str();
  poses->callback([command, poses] { command->run(*poses); });
  poses->footer("Example: naocal poses -o poses.json --select 8, then naocal simulate set --poses poses.json\n"
                "A robot with a URDF: naocal poses -o poses.json --robot arm.urdf --select 16, then\n"
                "  naocal simulate set --robot arm.urdf --poses poses.json");
}

} // namespace naocal

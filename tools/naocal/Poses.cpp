#include "Commands.hpp"
#include "PlanStory.hpp"
#include "captures/CaptureSetFile.hpp"
#include "captures/Files.hpp"
#include "captures/InputError.hpp"
#include "geometry/Angles.hpp"
#include "poses/PlanFile.hpp"
#include "poses/PoseFile.hpp"
#include "synthetic/SimulationPlan.hpp"

#include <CLI/CLI.hpp>
#include <cstdlib>
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
  std::string robot = "V6", output, poseFiles, boards, extend;
  double jointErrorDegrees = 6.5, sigmaDegrees = 0.2;
  std::vector<std::string> weights;
  PlanOptions plan;

  void run() {
    const Robot drawn = loadRobot(configurationDirectory(), robot);
    plan.poses.limitMargin = plan.poses.stability.jointError = radians(jointErrorDegrees);
    plan.sigma = radians(sigmaDegrees);
    plan.weights = readWeights();
    Surveyed scene = boards.empty() ? Surveyed{SimulationPlan{}.boards, SimulationPlan{}.cameras} : surveyed();
    if (!extend.empty()) {
      keep(drawn, scene.boards);
    }
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

private:
  struct Surveyed {
    std::vector<Board> boards;
    std::map<std::string, CameraIntrinsics> cameras;
  };

  /// Boards and cameras of a capture set; placements that are only guessed are where planning begins.
  Surveyed surveyed() const {
    const CaptureSet set = readCaptureSet(boards, BadCaptures::skip).set;
    Surveyed result{{}, set.cameras};
    for (Board board : set.boards) {
      if (board.link == "floor") {
        board.placement = board.placement || !board.hasGuess ? board.placement : board.placementGuess;
        result.boards.push_back(board);
      }
    }
    if (result.boards.empty()) {
      throw InputError{fmt::format("{}: expected a board on the floor, found none", boards)};
    }
    return result;
  }

  /// Poses of an earlier plan stay, and its boards where they are.
  void keep(const Robot& drawn, std::vector<Board>& known) {
    const PoseFile earlier = readPoseFile(extend, drawn);
    for (const PlayablePose& pose : earlier.poses) {
      if (pose.supportFoot != plan.poses.supportFoot) {
        throw InputError{fmt::format("{}: expected poses on the foot of --support, found {} on another; extend a plan "
                                     "of one foot",
                                     extend, pose.id)};
      }
      plan.kept.push_back(pose.angles);
    }
    for (Board& board : known) {
      const auto place = earlier.boards.find(board.id);
      if (place == earlier.boards.end()) {
        throw InputError{fmt::format("{}: expected where board {} lies, found nothing; name the set that has the "
                                     "plan's boards with --boards",
                                     extend, board.id)};
      }
      board.placement = place->second;
    }
    plan.moveBoards = false;
  }

  std::map<std::string, double> readWeights() const {
    std::map<std::string, double> result;
    for (const std::string& text : weights) {
      const std::size_t equals = text.find('=');
      char* end = nullptr;
      const double weight = equals == std::string::npos ? -1 : std::strtod(text.c_str() + equals + 1, &end);
      if (!(weight >= 0) || *end != '\0' || end == text.c_str() + equals + 1) {
        throw InputError{fmt::format("--weight: expected NAME=NUMBER such as LKneePitch=2, found {}", text)};
      }
      result[text.substr(0, equals)] = weight;
    }
    return result;
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
  poses->add_option("--support", plan.poses.supportFoot, "the foot to stand on: left or right")
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
  poses->add_option("--sigma", command->sigmaDegrees, "that --criterion time must reach for every offset [degrees]")
      ->capture_default_str()
      ->check(CLI::Range(0.001, 10.0));
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

#include "commands/plan/PosesOfRobot.hpp"

#include "console/OutputFiles.hpp"
#include "console/print/PrintPlan.hpp"
#include "console/print/PrintText.hpp"
#include "poses/PoseFile.hpp"
#include "robot/RobotOfSet.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

constexpr const char* ofScene = "a scene says which boards there are (--scene)";
constexpr const char* ofLegs = "it plans standing NAOs";
constexpr NaoOption naosAlone[]{{"--pose-files", ".pose files are for NAOs"},
                                {"--floor", "floor plans are drawn for NAOs"},
                                {"--sampling", ofLegs},
                                {"--sigma", ofLegs},
                                {"--weight", ofLegs},
                                {"--mirror", ofLegs},
                                {"--extend", ofLegs},
                                {"--boards", ofScene},
                                {"--whole-boards", ofScene},
                                {"--worn", ofLegs},
                                {"--compare", ofLegs},
                                {"--known", "a scene says what is known (--scene)"},
                                {"--fixed-boards", "boards stay where the scene lays them"},
                                {"--joint-error", ofLegs}};

} // namespace

std::span<const NaoOption> naoOptionsOfPoses() {
  return naosAlone;
}

void planPosesOfRobot(const PosesOfRobot& asked) {
  const RobotScene scene = loadScene(asked.robot, asked.scene, asked.support, asked.candidates.seed);
  printText(stderr, "drawing candidate poses\n");
  constexpr std::size_t choice = 4; // candidates per pose to select
  SceneCandidatesOptions wanted = asked.candidates;
  wanted.count = std::max(wanted.count, choice * asked.plan.count);
  const CandidateCaptures candidates = drawCandidates(scene, wanted);
  printText(stderr, "selecting among {} of them\n", candidates.poses.size());
  const CapturePlan plan = planCaptures(candidates, asked.plan);
  printPlan(plan);
  writeJson(planJson(plan, loadRobot(scene.set)), asked.output);
  printText("{} holds the poses\n", asked.output);
}

} // namespace naocal

#include "synthetic/Simulation.hpp"

#include "synthetic/CornerMeasurement.hpp"

#include <cassert>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace naocal {

namespace {

/// Where the boards really lie: drawn about their planned places.
std::vector<Placement> drawnBoards(const SimulationPlan& plan, Randomness chance) {
  std::vector<Placement> placements;
  for (const Board& board : plan.boards) {
    assert(board.placement);
    Placement placement = *board.placement;
    placement.x += chance.within(plan.boardShiftRange);
    placement.y += chance.within(plan.boardShiftRange);
    placement.yaw += chance.within(plan.boardTurnRange);
    placements.push_back(placement);
  }
  return placements;
}

/// The same place on the floor in another world: x, y, yaw.
Placement seenFrom(const Placement& otherWorld, const Placement& placement) {
  const Eigen::Isometry3d otherFromFrame = isometry(otherWorld).inverse() * isometry(placement);
  Placement result;
  result.x = otherFromFrame.translation().x();
  result.y = otherFromFrame.translation().y();
  result.yaw = std::atan2(otherFromFrame(1, 0), otherFromFrame(0, 0));
  return result;
}

TruePlacements seenFrom(const Placement& otherWorld, TruePlacements placements) {
  for (auto& [id, placement] : placements.boards) {
    placement = seenFrom(otherWorld, placement);
  }
  for (auto& [id, placement] : placements.stances) {
    placement = seenFrom(otherWorld, placement);
  }
  return placements;
}

/// The world of a result: as surveyed, else the frame of the first board in the list that any picture shows.
Placement resultWorld(const SimulationPlan& plan, const std::vector<Placement>& boards,
                      const std::vector<std::vector<BoardCorners>>& seen) {
  for (std::size_t board = 0; board < boards.size() && !plan.surveyed; ++board) {
    for (const std::vector<BoardCorners>& picture : seen) {
      for (const BoardCorners& corners : picture) {
        if (corners.board == plan.boards[board].id) {
          return boards[board];
        }
      }
    }
  }
  return {};
}

std::map<std::string, TrueUnknown> noiseLevels(const SimulationPlan& plan) {
  std::map<std::string, TrueUnknown> levels;
  const auto add = [&](const std::string& name, double value, const std::string& unit) {
    levels[name] = {name, value, unit};
  };
  const double step = 2 * std::numbers::pi / plan.mechanics.encoderSteps; // [rad]
  add("encoder", std::hypot(plan.mechanics.encoderDither, step / std::sqrt(12.0)), "rad");
  add("pose", plan.mechanics.poseScatter, "rad");
  add("approach", plan.mechanics.approachScatter, "rad");
  if (!plan.images) { // else it is what a detector makes of the pictures
    add("pixel", plan.corners.pixel, "px");
    add("grossShare", plan.corners.grossShare, "1");
  }
  return levels;
}

CaptureSet emptySet(const Robot& drawing, const SimulationPlan& plan, std::uint64_t robotSeed) {
  CaptureSet set;
  set.name = "simulated";
  set.model = drawing.model;
  set.bodyId = set.headId = fmt::format("{}{}", syntheticId, robotSeed);
  for (const Joint& joint : drawing.joints) {
    set.jointNames.push_back(joint.name);
  }
  set.cameras = plan.cameras;
  set.boards = plan.boards;
  return set;
}

} // namespace

Simulation simulate(const Robot& drawing, const SimulationPlan& plan, std::uint64_t seed) {
  const std::uint64_t robotSeed = plan.robotSeed.value_or(seed);
  Randomness errorChance{robotSeed, "errors"}, displacementChance{seed, "displacement"}, noiseChance{seed, "corners"};
  RobotErrors errors = drawnErrors(drawing, plan.offsetRange, plan.mountRange, plan.mountShiftRange, errorChance);
  if (!plan.flaw.empty()) {
    errors.flaw = namedFlaw(drawing, plan.flaw).scaled(plan.flawScale);
  } else if (plan.hiddenFlaw && !plan.poses.empty()) {
    Randomness flawChance{robotSeed, "flaw"};
    errors.flaw = drawnFlaw(drawing, plan.poses.front().supportFoot, flawChance).scaled(plan.flawScale);
  }
  const std::vector<Placement> boards = drawnBoards(plan, Randomness{plan.boardSeed.value_or(seed), "boards"});
  Walk taken = walk(SyntheticRobot{drawing, errors, plan.mechanics}, plan, boards, seed);

  Simulation result{emptySet(drawing, plan, robotSeed), {}, {}};
  Truth& truth = result.truth;
  if (plan.corners.displacedBoard > 0) {
    if (const auto displaced = displaceOneBoard(taken, plan, plan.corners.displacedBoard, displacementChance)) {
      truth.displacedBoards.push_back(*displaced);
    }
  }
  const std::vector<std::vector<BoardCorners>> seen = cornersInView(taken, plan);
  for (std::size_t capture = 0; capture < seen.size(); ++capture) {
    if (plan.images) {
      taken.captures[capture].image = fmt::format("images/{:04}.png", capture);
    } else {
      taken.captures[capture].corners = seen[capture];
    }
  }
  if (!plan.images) {
    truth.grossCorners = spoil(taken.captures, plan.corners, noiseChance);
  }

  truth.seed = seed;
  truth.effects = trueEffects(drawing, errors);
  truth.noise = noiseLevels(plan);
  for (std::size_t board = 0; board < boards.size(); ++board) {
    truth.ownWorld.boards[plan.boards[board].id] = boards[board];
    result.set.boards[board].placement = plan.surveyed ? std::optional{boards[board]} : std::nullopt;
  }
  for (Stance& stance : taken.stances) {
    truth.ownWorld.stances[stance.id] = *stance.placement;
    stance.placement = plan.surveyed ? stance.placement : std::nullopt;
  }
  truth.placements = seenFrom(resultWorld(plan, boards, seen), truth.ownWorld);
  result.set.stances = std::move(taken.stances);
  result.set.captures = std::move(taken.captures);
  result.exposures = std::move(taken.exposures);
  return result;
}

} // namespace naocal

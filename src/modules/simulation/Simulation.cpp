#include "simulation/Simulation.hpp"

#include "simulation/SimulationPlan.hpp"
#include "simulation/SyntheticRobot.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace naocal {

/// The noiseless corners in all captures: one list of boards per capture.
std::vector<std::vector<BoardCorners>> observeCorners(const CaptureSequence& walk, const SimulationPlan& plan);

/// Moves one board in one image's exposure by `distance` [m] in a random direction. Before and after, the image shows
/// at least eight of its corners, and at least two other images do too; otherwise the displacement would be
/// undetectable. Absent if there is no such image.
std::optional<DisplacedBoard> displaceOneBoard(CaptureSequence& walk, const SimulationPlan& plan, double distance,
                                               RandomStream& chance);

/// Adds detector noise and gross errors; returns the corners with gross errors.
std::vector<GrossCorner> addCornerNoise(std::vector<Capture>& captures, const CornerNoise& noise, RandomStream& chance);

namespace {

std::vector<BoardCorners> observeCorners(const Capture& capture, const Exposure& exposure, const SimulationPlan& plan) {
  std::vector<BoardCorners> seen;
  for (std::size_t board = 0; board < plan.boards.size(); ++board) {
    BoardCorners corners = visibleCorners(plan.cameras.at(capture.camera), plan.boards[board],
                                          exposure.worldFromCamera.inverse() * exposure.worldFromBoard[board]);
    if (!corners.ids.empty()) {
      seen.push_back(std::move(corners));
    }
  }
  return seen;
}

/// A board with enough visible corners in an image to determine its pose.
struct Appearance {
  std::size_t capture, board;
};

std::vector<Appearance> goodSights(const CaptureSequence& walk, const SimulationPlan& plan) {
  constexpr std::size_t enough = 8; // corners
  std::vector<Appearance> sights;
  for (std::size_t capture = 0; capture < walk.captures.size(); ++capture) {
    for (const BoardCorners& corners : observeCorners(walk.captures[capture], walk.exposures[capture], plan)) {
      const auto board = std::find_if(plan.boards.begin(), plan.boards.end(),
                                      [&](const Board& candidate) { return candidate.id == corners.board; });
      if (corners.ids.size() >= enough) {
        sights.push_back({capture, static_cast<std::size_t>(board - plan.boards.begin())});
      }
    }
  }
  return sights;
}

} // namespace

std::vector<std::vector<BoardCorners>> observeCorners(const CaptureSequence& walk, const SimulationPlan& plan) {
  std::vector<std::vector<BoardCorners>> corners;
  for (std::size_t capture = 0; capture < walk.captures.size(); ++capture) {
    corners.push_back(observeCorners(walk.captures[capture], walk.exposures[capture], plan));
  }
  return corners;
}

std::optional<DisplacedBoard> displaceOneBoard(CaptureSequence& walk, const SimulationPlan& plan, double distance,
                                               RandomStream& chance) {
  std::vector<Appearance> candidates = goodSights(walk, plan);
  while (!candidates.empty()) {
    const auto chosen = candidates.begin() + static_cast<std::ptrdiff_t>(chance.uniformBelow(candidates.size()));
    const Appearance sight = *chosen;
    candidates.erase(chosen);
    const Eigen::Vector2d shift = chance.randomDirection(distance);
    Eigen::Isometry3d& worldFromBoard = walk.exposures[sight.capture].worldFromBoard[sight.board];
    const Eigen::Isometry3d before = worldFromBoard;
    worldFromBoard.translate(Eigen::Vector3d{shift.x(), shift.y(), 0});
    const std::vector<Appearance> after = goodSights(walk, plan);
    const auto others = std::count_if(after.begin(), after.end(), [&](const Appearance& other) {
      return other.board == sight.board && other.capture != sight.capture;
    });
    const bool stillSeen = std::any_of(after.begin(), after.end(), [&](const Appearance& other) {
      return other.board == sight.board && other.capture == sight.capture;
    });
    if (stillSeen && others >= 2) {
      return DisplacedBoard{walk.captures[sight.capture].id, plan.boards[sight.board].id, shift.x(), shift.y()};
    }
    worldFromBoard = before;
  }
  return std::nullopt;
}

std::vector<GrossCorner> addCornerNoise(std::vector<Capture>& captures, const CornerNoise& noise,
                                        RandomStream& chance) {
  std::vector<GrossCorner> gross;
  const auto error = [&] { return noise.heavyTails ? chance.studentT4(noise.pixel) : chance.normal(noise.pixel); };
  for (Capture& capture : captures) {
    for (BoardCorners& board : *capture.corners) {
      for (std::size_t i = 0; i < board.ids.size(); ++i) {
        const double errorU = error(), errorV = error();
        board.uv[i] += Eigen::Vector2d{errorU, errorV};
        if (chance.bernoulli(noise.grossShare)) {
          board.uv[i] += chance.randomDirection(noise.grossSize);
          gross.push_back({capture.id, board.board, board.ids[i]});
        }
      }
    }
  }
  return gross;
}

namespace {

/// True board placements: planned ones plus random shifts and turns.
std::vector<Placement> placeBoards(const SimulationPlan& plan, RandomStream chance) {
  std::vector<Placement> placements;
  for (const Board& board : plan.boards) {
    assert(board.placement);
    Placement placement = *board.placement;
    placement.x += chance.uniformWithin(plan.boardShiftRange);
    placement.y += chance.uniformWithin(plan.boardShiftRange);
    placement.yaw += chance.uniformWithin(plan.boardTurnRange);
    placements.push_back(placement);
  }
  return placements;
}

/// Placement on the floor relative to another one: x, y, yaw.
Placement seenFrom(const Placement& otherWorld, const Placement& placement) {
  const Eigen::Isometry3d otherFromFrame =
      isometryFromPlacement(otherWorld).inverse() * isometryFromPlacement(placement);
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

/// World frame of a result: as surveyed, otherwise the first board in the list visible in any image.
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

std::map<std::string, TrueUnknown> trueNoiseLevels(const SimulationPlan& plan) {
  std::map<std::string, TrueUnknown> levels;
  const auto add = [&](const std::string& name, double value, const std::string& unit) {
    levels[name] = {name, value, unit};
  };
  const double step = 2 * std::numbers::pi / plan.mechanics.encoderSteps; // [rad]
  add("encoder", std::hypot(plan.mechanics.encoderDither, step / std::sqrt(12.0)), "rad");
  add("pose", plan.mechanics.poseScatter, "rad");
  add("approach", plan.mechanics.approachScatter, "rad");
  if (!plan.images) { // otherwise the detector determines it
    add("pixel", plan.corners.pixel, "px");
    add("grossShare", plan.corners.grossShare, "1");
  }
  return levels;
}

/// Errors of the planned ranges, with the plan's flaw.
RobotErrors drawPlannedErrors(const Robot& drawing, const SimulationPlan& plan, std::uint64_t robotSeed) {
  RandomStream errorChance{robotSeed, "errors"};
  RobotErrors errors = drawErrors(drawing, plan.offsetRange, plan.mountRange, plan.mountShiftRange, errorChance);
  if (!plan.flaw.empty()) {
    errors.flaw = namedFlaw(drawing, plan.flaw).scaledBy(plan.flawScale);
  } else if (plan.hiddenFlaw && !plan.poses.empty()) {
    RandomStream flawChance{robotSeed, "flaw"};
    errors.flaw = drawInjectedEffect(drawing, plan.poses.front().supportFoot, flawChance).scaledBy(plan.flawScale);
  }
  return errors;
}

CaptureSet emptySet(const Robot& drawing, const SimulationPlan& plan, std::uint64_t robotSeed) {
  CaptureSet set;
  set.name = "simulated";
  set.model = drawing.model;
  set.bodyId = set.headId = fmt::format("{}{}", syntheticIdPrefix, robotSeed);
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
  RandomStream displacementChance{seed, "displacement"}, noiseChance{seed, "corners"};
  const RobotErrors errors = drawPlannedErrors(drawing, plan, robotSeed);
  const std::vector<Placement> boards = placeBoards(plan, RandomStream{plan.boardSeed.value_or(seed), "boards"});
  CaptureSequence taken = recordCaptures(SyntheticRobot{drawing, errors, plan.mechanics}, plan, boards, seed);

  Simulation result{emptySet(drawing, plan, robotSeed), {}, {}};
  Truth& truth = result.truth;
  if (plan.corners.displacedBoard > 0) {
    if (const auto displaced = displaceOneBoard(taken, plan, plan.corners.displacedBoard, displacementChance)) {
      truth.displacedBoards.push_back(*displaced);
    }
  }
  const std::vector<std::vector<BoardCorners>> seen = observeCorners(taken, plan);
  for (std::size_t capture = 0; capture < seen.size(); ++capture) {
    if (plan.images) {
      taken.captures[capture].image = fmt::format("images/{:04}.png", capture);
    } else {
      taken.captures[capture].corners = seen[capture];
    }
  }
  if (!plan.images) {
    truth.grossCorners = addCornerNoise(taken.captures, plan.corners, noiseChance);
  }

  truth.seed = seed;
  truth.effects = listTrueEffects(drawing, errors);
  truth.noise = trueNoiseLevels(plan);
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

namespace {

using namespace std::chrono_literals;

std::vector<double> list(const Eigen::VectorXd& values) {
  return {values.begin(), values.end()};
}

/// State of the robot during a simulation: stance, last motion, temperatures.
class Walker {
public:
  Walker(const SyntheticRobot& robot, const SimulationPlan& plan, const std::vector<Placement>& boards,
         std::uint64_t seed)
      : robot_{robot}, plan_{plan}, stanceChance_{seed, "stances"}, motion_{seed, "motion"}, sensors_{seed, "sensors"} {
    const auto joints = static_cast<Eigen::Index>(robot.drawing().joints.size());
    commanded_ = approach_ = Eigen::VectorXd::Zero(joints);
    temperatures_ = Eigen::VectorXd::Constant(joints, plan.mechanics.ambientTemperature);
    for (const Placement& board : boards) {
      worldFromBoard_.push_back(isometryFromPlacement(board));
    }
    for (std::size_t pose = 0; pose < plan.poses.size(); ++pose) {
      poseDeflections_.push_back(robot.drawScatter(plan.mechanics.poseScatter, motion_));
    }
  }

  CaptureSequence run() {
    const bool restands = plan_.repeatKind == RepeatKind::restand;
    for (int round = 0; round < (restands ? plan_.samples : 1); ++round) {
      stance_ = {};
      for (std::size_t pose = 0; pose < plan_.poses.size(); ++pose) {
        standOn(plan_.poses[pose].supportFoot);
        if (restands) {
          comeTo(pose, 3s);
          record(plan_.poses[pose], round);
        } else {
          takePose(pose);
        }
      }
    }
    return std::move(walk_);
  }

private:
  void takePose(std::size_t pose) {
    for (int repeat = 0; repeat < plan_.samples; ++repeat) {
      if (repeat == 0 || plan_.repeatKind == RepeatKind::reapproach) {
        comeTo(pose, 3s);
      } else {
        wait(0.4s);
      }
      record(plan_.poses[pose], repeat);
    }
  }

  /// Consecutive poses on the same foot share a stance.
  void standOn(SupportFoot foot) {
    if (stance_ && stance_->supportFoot == foot) {
      return;
    }
    const double y = foot == SupportFoot::right ? -halfFootDistance : halfFootDistance;
    stance_ = Stance{plan_.firstStance + static_cast<int>(walk_.stances.size()), foot, Placement{}};
    Placement& placement = *stance_->placement;
    placement.x = stanceChance_.uniformWithin(plan_.stanceShiftRange);
    placement.y = y + stanceChance_.uniformWithin(plan_.stanceShiftRange);
    placement.yaw = stanceChance_.uniformWithin(plan_.stanceTurnRange);
    walk_.stances.push_back(*stance_);
    wait(20s);
  }

  void comeTo(std::size_t pose, Seconds duration) {
    const CommandedPose& target = plan_.poses[pose];
    Eigen::VectorXd commanded = target.angles;
    for (std::size_t joint = 0; joint < robot_.drawing().joints.size(); ++joint) {
      const auto motor = static_cast<Eigen::Index>(robot_.drawing().joints[joint].motor);
      commanded[static_cast<Eigen::Index>(joint)] = target.angles[motor];
    }
    for (Eigen::Index joint = 0; joint < commanded.size(); ++joint) {
      const double way = commanded[joint] - commanded_[joint];
      const double asked = target.approach.size() > 0 ? target.approach[joint] : 0;
      approach_[joint] = asked != 0 ? asked : way == 0 ? approach_[joint] : std::copysign(1, way);
    }
    commanded_ = commanded;
    taken_ = robot_.moveTo(commanded, approach_, target.supportFoot, poseDeflections_[pose], motion_);
    wait(duration);
  }

  void wait(Seconds duration) {
    time_ += duration;
    if (taken_) {
      robot_.heatMotors(temperatures_, taken_->torques, duration);
    }
  }

  void record(const CommandedPose& pose, int repeat) {
    const Seconds start = time_;
    const std::vector<CameraMount>& cameras = robot_.drawing().cameras;
    for (std::size_t camera = 0; camera < cameras.size(); ++camera) {
      Capture capture;
      capture.id = static_cast<int>(walk_.captures.size());
      capture.pose = pose.name;
      capture.repeat = repeat;
      capture.repeatKind = plan_.repeatKind;
      capture.time = time_;
      capture.camera = cameras[camera].name;
      capture.supportFoot = pose.supportFoot;
      capture.stance = stance_->id;
      expose(capture, camera, time_ - start);
      wait(0.03s);
    }
  }

  void expose(Capture& capture, std::size_t camera, Seconds since) {
    Exposure exposure{robot_.trueJointAngles(*taken_, since), {}, worldFromBoard_};
    const Eigen::Isometry3d worldFromTorso =
        isometryFromPlacement(*stance_->placement) * robot_.soleFromTorso(exposure.joints, capture.supportFoot);
    exposure.worldFromCamera = worldFromTorso * robot_.torsoFromCamera(camera, exposure.joints);
    capture.joints = {list(robot_.readEncoders(*taken_, since, sensors_)),
                      list(commanded_),
                      list(taken_->velocity),
                      list(approach_),
                      list(temperatures_),
                      list(robot_.readCurrents(*taken_, sensors_))};
    capture.imu = robot_.readImu(worldFromTorso.linear(), sensors_);
    capture.fsr = robot_.readForces(*taken_, sensors_);
    walk_.captures.push_back(std::move(capture));
    walk_.exposures.push_back(std::move(exposure));
  }

  const SyntheticRobot& robot_;
  const SimulationPlan& plan_;
  RandomStream stanceChance_, motion_, sensors_;
  std::vector<Eigen::Isometry3d> worldFromBoard_;
  std::vector<Eigen::VectorXd> poseDeflections_;
  Eigen::VectorXd commanded_, approach_, temperatures_;
  std::optional<Stance> stance_;
  std::optional<SettledPose> taken_;
  Seconds time_{0};
  CaptureSequence walk_;
};

} // namespace

CaptureSequence recordCaptures(const SyntheticRobot& robot, const SimulationPlan& plan,
                               const std::vector<Placement>& boards, std::uint64_t seed) {
  return Walker{robot, plan, boards, seed}.run();
}

} // namespace naocal

#include "scenes/SceneCandidates.hpp"

#include "io/InputError.hpp"
#include "math/Checkpoints.hpp"
#include "math/LinearAlgebra.hpp"
#include "robot/RobotOfSet.hpp"
#include "scenes/TrueRobot.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace naocal {

namespace {

/// Noise of the captures of a scene, as `solve` describes it: encoders whose steps nobody tells scatter with the poses.
Noise assumedNoise(const RobotScene& scene) {
  const CaptureSet& set = scene.set;
  const bool hasUnknownSteps =
      !set.urdf.empty() && std::any_of(set.jointNames.begin(), set.jointNames.end(),
                                       [&](const std::string& joint) { return !set.encoderSteps.contains(joint); });
  Noise noise;
  noise.pixel = scene.noise.pixel;
  noise.pose = std::hypot(scene.noise.pose, hasUnknownSteps ? scene.noise.encoder : 0);
  return noise;
}

/// The scene's set, with noise levels of trackers that tell none.
CaptureSet withTrackerNoise(const RobotScene& scene) {
  CaptureSet set = scene.set;
  for (Tracker& tracker : set.instruments.trackers) {
    tracker.sigma = tracker.sigma.value_or(scene.noise.tracker);
    tracker.sigmaRotation = tracker.sigmaRotation.value_or(scene.noise.trackerRotation);
  }
  return set;
}

/// Appends what is read in a pose.
void addCandidate(const Robot& robot, const std::vector<Capture>& sights, const ProposedPose& pose,
                  CandidateCaptures& candidates) {
  CaptureSet& set = candidates.set;
  for (Capture capture : sights) {
    if (!showsAnything(capture)) {
      continue;
    }
    capture.id = static_cast<int>(set.captures.size());
    capture.pose = plannedPoseName(candidates.poses.size());
    for (const std::string& name : set.jointNames) {
      const Eigen::Index joint = eigenIndex(*robot.jointIndex(name));
      capture.joints.measured.push_back(pose.pose.angles[joint]);
      capture.joints.approach.push_back(pose.approach[joint]);
    }
    set.captures.push_back(std::move(capture));
  }
  candidates.poses.push_back(pose);
}

} // namespace

PlannedPose describeSight(const CaptureSet& set, const std::vector<Capture>& captures, const Eigen::VectorXd& angles) {
  PlannedPose pose{set.stances.front().supportFoot, angles, {}};
  std::set<std::string> tracked;
  for (const Capture& capture : captures) {
    for (const BoardCorners& seen : capture.corners.value_or(std::vector<BoardCorners>{})) {
      pose.sights.push_back({capture.camera, seen.board, seen.ids});
    }
    for (const PointReading& point : capture.points) {
      tracked.insert(point.marker);
    }
    for (const FrameReading& frame : capture.frames) {
      tracked.insert(frame.frame);
    }
  }
  pose.tracked.assign(tracked.begin(), tracked.end());
  return pose;
}

bool showsAnything(const Capture& capture) {
  return (capture.corners && !capture.corners->empty()) || !capture.points.empty() || !capture.frames.empty();
}

CandidateCaptures drawCandidates(const RobotScene& scene, const SceneCandidatesOptions& options) {
  ScenePlan still{.given = {}, .seed = options.seed, .robotSeed = {}, .sceneSeed = {}, .spread = 0};
  if (scene.set.cameras.empty() && scene.set.instruments.trackers.empty()) {
    throw InputError{"expected a scene with cameras or trackers, found neither; touches are not planned"};
  }
  TrueRobot robot{scene, still};
  CandidateCaptures result{.set = withTrackerNoise(scene), .noise = assumedNoise(scene)};
  std::mt19937_64 random{options.seed};
  robot.poses().takeCounts(); // of the poses that the robot was built with
  for (std::size_t draw = 0; draw < options.draws && result.poses.size() < options.count; ++draw) {
    Checkpoints::reach();
    const auto angles = robot.poses().draw();
    if (!angles) {
      continue;
    }
    const Eigen::VectorXd approach = drawApproach(robot.robot(), random);
    const TrueRobot::Sight sight = robot.look({*angles, approach, Seconds{0}, Eigen::VectorXd::Zero(angles->size())});
    if (sight.isEnough) {
      addCandidate(robot.robot(), sight.captures, {describeSight(scene.set, sight.captures, *angles), approach},
                   result);
    }
  }
  result.sieve = robot.poses().takeCounts();
  result.sieve.seeing = result.poses.size();
  if (result.poses.empty()) {
    throw InputError{fmt::format("{}: in none of {} poses that were drawn {}; place things nearer, or give `ranges` of "
                                 "joints in the scene",
                                 robot.robot().model, result.sieve.generated, sufficientSight(scene))};
  }
  result.isOnSole = robot.isOnSole();
  if (result.isOnSole) {
    result.boards = robot.set().boards;
    std::erase_if(result.boards, [](const Board& board) { return board.link != "floor"; });
  }
  return result;
}

} // namespace naocal

#include "scenes/SceneSimulation.hpp"

#include "io/InputError.hpp"
#include "math/LinearAlgebra.hpp"
#include "measurements/Noise.hpp"
#include "scenes/TouchPoses.hpp"
#include "scenes/TrueRobot.hpp"
#include "setups/Catalogue.hpp"
#include "simulation/Simulation.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace naocal {

namespace {

Placement placementBy(const RigidTransform& transform) {
  const Eigen::Matrix<double, 6, 1> p = placementFromTransform(transform);
  return {p[0], p[1], p[2], p[3], p[4], p[5]};
}

/// Adds what encoders, cameras and trackers add to true readings.
class ReadingSpoiler {
public:
  ReadingSpoiler(const RobotScene& scene, const ScenePlan& plan)
      : scene_{scene}, plan_{plan}, encoders_{plan.seed, "encoders"}, corners_{plan.seed, "corners"}, trackers_{
                                                                                                          plan.seed,
                                                                                                          "trackers"} {}

  /// The lists of a capture, in the order of the set's joints.
  JointReadings readJoints(const Robot& robot, const Eigen::VectorXd& recorded, const Eigen::VectorXd& approach) {
    JointReadings readings;
    for (const std::string& name : scene_.set.jointNames) {
      const Eigen::Index joint = eigenIndex(*robot.jointIndex(name));
      const double sign = hasFlaw(reversedJoint().labelAt(name)) ? -1 : 1;
      const double slip = hasFlaw(countSlip().labelAt(name)) ? scene_.set.slipSteps.at(name) : 0;
      const double shown = sign * (recorded[joint] + encoders_.normal(scene_.noise.encoder)) + slip;
      const double step = stepOf(name);
      readings.measured.push_back(step > 0 ? step * std::round(shown / step) : shown);
      readings.approach.push_back(sign * approach[joint]);
    }
    return readings;
  }

  void spoil(Capture& capture, std::vector<GrossCorner>& gross) {
    if (capture.corners) {
      for (BoardCorners& board : *capture.corners) {
        spoilCorners(capture.id, board, gross);
      }
    }
    for (PointReading& point : capture.points) {
      point.xyz += drawThree(sigmaOf(point.tracker));
    }
    for (FrameReading& frame : capture.frames) {
      frame.xyz += drawThree(sigmaOf(frame.tracker));
      const double sigma = findTracker(scene_.set, frame.tracker).sigmaRotation.value_or(scene_.noise.trackerRotation);
      frame.rotation = Eigen::Quaterniond{rotationAbout(drawThree(sigma))} * frame.rotation;
    }
  }

private:
  bool hasFlaw(const std::string& flaw) const {
    return std::find(plan_.flaws.begin(), plan_.flaws.end(), flaw) != plan_.flaws.end();
  }

  double stepOf(const std::string& joint) const {
    const auto step = scene_.set.encoderSteps.find(joint);
    return step != scene_.set.encoderSteps.end() ? step->second : scene_.set.urdf.empty() ? encoderStep : 0;
  }

  void spoilCorners(int capture, BoardCorners& board, std::vector<GrossCorner>& gross) {
    const double pixel = scene_.noise.pixel;
    const auto error = [&] { return plan_.heavyTails ? corners_.studentT4(pixel) : corners_.normal(pixel); };
    for (std::size_t i = 0; i < board.ids.size(); ++i) {
      const double errorU = error(), errorV = error();
      board.uv[i] += Eigen::Vector2d{errorU, errorV};
      if (corners_.bernoulli(plan_.grossShare)) {
        board.uv[i] += corners_.randomDirection(plan_.grossSize);
        gross.push_back({capture, board.board, board.ids[i]});
      }
    }
  }

  double sigmaOf(const std::string& tracker) const {
    return findTracker(scene_.set, tracker).sigma.value_or(scene_.noise.tracker);
  }
  Eigen::Vector3d drawThree(double sigma) {
    const double x = trackers_.normal(sigma), y = trackers_.normal(sigma), z = trackers_.normal(sigma);
    return {x, y, z};
  }

  const RobotScene& scene_;
  const ScenePlan& plan_;
  RandomStream encoders_, corners_, trackers_;
};

double contactSigmaOf(const RobotScene& scene) {
  return scene.set.instruments.contactSigma.value_or(scene.noise.contact);
}

/// resultFromWorld: a result's world is the simulator's, but the frame of the first floor board that was seen if the
/// robot stands on a sole and the set places no floor board.
RigidTransform resultWorld(const RobotScene& scene, const TrueRobot& robot, const std::vector<Capture>& captures) {
  const std::vector<Board>& boards = robot.set().boards;
  const bool isSurveyed = std::any_of(scene.set.boards.begin(), scene.set.boards.end(), [](const Board& board) {
    return board.link == "floor" && board.placement.has_value();
  });
  for (std::size_t i = 0; robot.isOnSole() && !isSurveyed && i < boards.size(); ++i) {
    const bool isSeen = std::any_of(captures.begin(), captures.end(), [&](const Capture& capture) {
      return capture.corners && std::any_of(capture.corners->begin(), capture.corners->end(),
                                            [&](const BoardCorners& seen) { return seen.board == boards[i].id; });
    });
    if (boards[i].link == "floor" && isSeen) {
      return transformFromPlacement(boards[i].placement->numbers()).inverse();
    }
  }
  return {};
}

TrueScene listTrueScene(const CaptureSet& placed, const RigidTransform& resultFromWorld) {
  TrueScene scene;
  const auto inResult = [&](const Placement& placement) {
    return placementBy(resultFromWorld * transformFromPlacement(placement.numbers()));
  };
  for (const Board& board : placed.boards) {
    const bool isInWorld = board.link == "floor" || board.link == "world";
    scene.placements["boards"][board.id] = isInWorld ? inResult(*board.placement) : *board.placement;
  }
  for (const auto& [name, mounting] : placed.mountings) {
    if (mounting.link == "world") {
      scene.placements["cameras"][name] = inResult(*mounting.placement);
    }
  }
  for (const Tracker& tracker : placed.instruments.trackers) {
    scene.placements["trackers"][tracker.id] = inResult(*tracker.placement);
  }
  for (const TrackedFrame& frame : placed.instruments.frames) {
    scene.placements["frames"][frame.id] = *frame.placement;
  }
  for (const TrackedMarker& marker : placed.instruments.markers) {
    scene.markers[marker.id] = *marker.point;
  }
  for (const ContactPlace& place : placed.instruments.places) {
    scene.places[place.id] = resultFromWorld * *place.point;
  }
  const Stance& stance = placed.stances.front();
  scene.placements["stances"][std::to_string(stance.id)] = inResult(stance.placement.value_or(Placement{}));
  return scene;
}

std::map<std::string, TrueUnknown> listNoise(const RobotScene& scene, const ScenePlan& plan) {
  std::map<std::string, TrueUnknown> levels;
  const auto add = [&](const std::string& name, double value, const std::string& unit) {
    levels[name] = {name, value, unit};
  };
  add("encoder", scene.noise.encoder, "rad");
  add("pose", scene.noise.pose, "rad");
  add("approach", scene.noise.approach, "rad");
  if (!scene.set.instruments.places.empty()) {
    add("contact", contactSigmaOf(scene), "m");
  }
  if (!scene.set.cameras.empty()) {
    add("pixel", scene.noise.pixel, "px");
    add("grossShare", plan.grossShare, "1");
  }
  for (const Tracker& tracker : scene.set.instruments.trackers) {
    add(tracker.id, tracker.sigma.value_or(scene.noise.tracker), "m");
    if (!scene.set.instruments.frames.empty()) {
      add(tracker.id + " rotation", tracker.sigmaRotation.value_or(scene.noise.trackerRotation), "rad");
    }
  }
  return levels;
}

/// Distances between the true places as they are measured.
std::vector<PlaceDistance> measureDistances(const RobotScene& scene, const CaptureSet& placed, std::uint64_t seed) {
  RandomStream chance{seed, "distances"};
  const auto pointOf = [&](const std::string& id) {
    const auto& places = placed.instruments.places;
    return *std::find_if(places.begin(), places.end(), [&](const ContactPlace& place) {
              return place.id == id;
            })->point;
  };
  std::vector<PlaceDistance> distances = scene.set.instruments.distances;
  for (PlaceDistance& distance : distances) {
    distance.metres =
        (pointOf(distance.between[0]) - pointOf(distance.between[1])).norm() + chance.normal(distance.sigma);
  }
  return distances;
}

/// Takes poses one after the other and reads all instruments in them.
class CaptureTaker {
public:
  CaptureTaker(TrueRobot& robot, const RobotScene& scene, const ScenePlan& plan)
      : robot_{robot}, scene_{scene}, plan_{plan}, motion_{plan.seed, "deflections"},
        approaches_{plan.seed, "approaches"}, contacts_{plan.seed, "contacts"}, spoiler_{scene, plan},
        touchPoses_{robot}, last_{Eigen::VectorXd::Zero(eigenIndex(robot.robot().joints.size()))} {}

  void takeRandomPoses() {
    for (std::size_t tries = 0; taken_ < plan_.poses; ++tries) {
      if (tries == mostTries * plan_.poses) {
        throw InputError{fmt::format("only {} of {} poses were found in {} draws in which {}; place things nearer, or "
                                     "give `ranges` of joints in the scene",
                                     taken_, plan_.poses, tries, sufficientSight(scene_))};
      }
      if (const auto angles = robot_.poses().draw()) {
        const Eigen::VectorXd recorded = robot_.recordedAt(*angles);
        take(fmt::format("P{:02}", taken_), recorded, (recorded - last_).cwiseSign(), false);
      }
    }
  }

  void takeGivenPoses() {
    bool isAnySeen = false;
    for (const PlayablePose& pose : plan_.given) {
      const Eigen::VectorXd moved = (pose.angles - last_).cwiseSign();
      isAnySeen |= take(pose.id, pose.angles, (pose.approach.array() != 0).select(pose.approach, moved), true);
    }
    if (!isAnySeen) {
      throw InputError{fmt::format("in none of the {} given poses {}; plan poses for this scene", plan_.given.size(),
                                   sufficientSight(scene_))};
    }
  }

  void takeTouches() {
    const std::size_t wanted = plan_.given.empty() ? plan_.poses : plan_.given.size();
    for (std::size_t i = 0; i < wanted; ++i) {
      takeTouch(fmt::format("T{:02}", i), i % robot_.touches().size());
    }
  }

  std::vector<Capture> captures;
  std::vector<RenderedScene> scenes; // with `ScenePlan::images`: per capture
  std::vector<GrossCorner> gross;

private:
  /// Comes to a pose as often as its samples ask. `recorded`: what the encoders read without noise [rad]. Returns
  /// whether enough is seen; if not, takes nothing unless `isGiven`.
  bool take(const std::string& name, const Eigen::VectorXd& recorded, const Eigen::VectorXd& approach, bool isGiven) {
    const Eigen::VectorXd scatter = drawScatter(motion_, scene_.noise.pose);
    TrueRobot::Pose pose{recorded, approach, clock_, scatter + drawScatter(approaches_, scene_.noise.approach)};
    TrueRobot::Sight sight = robot_.look(pose);
    if (!sight.isEnough && !isGiven) {
      return false;
    }
    const bool isEnough = sight.isEnough;
    const int samples = comesBack() ? 1 : plan_.samples;
    record(name, 0, samples, pose, sight);
    for (int repeat = 1; comesBack() && repeat < plan_.samples; ++repeat) {
      pose.time = clock_;
      pose.deflection = scatter + drawScatter(approaches_, scene_.noise.approach);
      record(name, repeat, 1, pose, robot_.look(pose));
    }
    ++taken_;
    return isEnough;
  }

  /// Touches a place, once at rest, else as often as the samples ask.
  void takeTouch(const std::string& name, std::size_t touch) {
    const Eigen::VectorXd scatter = drawScatter(motion_, scene_.noise.pose);
    TrueRobot::Pose pose{last_, last_, clock_, scatter + drawScatter(approaches_, scene_.noise.approach)};
    pose = touchPoses_.find(touch, pose, last_, drawMiss());
    recordTouch(name, 0, pose, touch);
    for (int repeat = 1; comesBack() && repeat < plan_.samples; ++repeat) {
      pose.time = clock_;
      pose.deflection = scatter + drawScatter(approaches_, scene_.noise.approach);
      if (const auto again = touchPoses_.findNear(touch, pose, drawMiss())) { // absent at a limit of the joints
        recordTouch(name, repeat, *again, touch);
      }
    }
    ++taken_;
  }

  void recordTouch(const std::string& name, int repeat, const TrueRobot::Pose& pose, std::size_t touch) {
    TrueRobot::Sight seen = robot_.look(pose);
    seen.captures.push_back(robot_.touches()[touch]);
    seen.scenes.resize(plan_.images ? seen.captures.size() : 0);
    record(name, repeat, 1, pose, seen);
  }

  /// Adds samples of one approach.
  void record(const std::string& name, int firstRepeat, int samples, const TrueRobot::Pose& pose,
              const TrueRobot::Sight& seen) {
    for (int sample = 0; sample < samples; ++sample) {
      const JointReadings readings = spoiler_.readJoints(robot_.robot(), pose.recorded, pose.approach);
      for (std::size_t i = 0; i < seen.captures.size(); ++i) {
        Capture capture = seen.captures[i];
        if (capture.camera.empty() && capture.points.empty() && capture.frames.empty() && capture.contacts.empty()) {
          continue;
        }
        capture.id = static_cast<int>(captures.size());
        capture.pose = name;
        capture.repeat = firstRepeat + sample;
        capture.repeatKind = plan_.repeatKind;
        capture.time = clock_ + Seconds{0.4 * sample};
        capture.joints = readings;
        spoiler_.spoil(capture, gross);
        captures.push_back(std::move(capture));
        if (plan_.images) {
          scenes.push_back(seen.scenes[i]);
        }
      }
    }
    last_ = pose.recorded;
    clock_ += Seconds{10};
  }

  bool comesBack() const { return plan_.repeatKind == RepeatKind::reapproach; }

  /// One normal deflection per joint [rad].
  Eigen::VectorXd drawScatter(RandomStream& chance, double sigma) const {
    Eigen::VectorXd scatter(last_.size());
    for (double& one : scatter) {
      one = chance.normal(sigma);
    }
    return scatter;
  }

  /// By how much a touch misses its place [m].
  Eigen::Vector3d drawMiss() {
    const double sigma = contactSigmaOf(scene_);
    const double x = contacts_.normal(sigma), y = contacts_.normal(sigma), z = contacts_.normal(sigma);
    return {x, y, z};
  }

  TrueRobot& robot_;
  const RobotScene& scene_;
  const ScenePlan& plan_;
  RandomStream motion_, approaches_, contacts_;
  ReadingSpoiler spoiler_;
  TouchPoses touchPoses_;
  Eigen::VectorXd last_; // recorded in the pose before
  Seconds clock_{0};
  std::size_t taken_ = 0;
};

/// Lets pictures stand for the corners that they show.
void replaceCorners(std::vector<Capture>& captures) {
  for (Capture& capture : captures) {
    if (!capture.camera.empty()) {
      capture.image = fmt::format("images/{:04}.png", capture.id);
      capture.corners.reset();
    }
  }
}

} // namespace

SceneSimulation simulateScene(const RobotScene& scene, const ScenePlan& plan) {
  if (plan.repeatKind == RepeatKind::restand) {
    throw InputError{"repeats: expected rest or reapproach, found restand: this robot is simulated where it stands and "
                     "is not put down anew; choose one of the two, or simulate several sets with the same robot seed"};
  }
  TrueRobot robot{scene, plan};
  SceneSimulation result{.set = scene.set, .truth = {}};
  result.set.bodyId = fmt::format("{}{}", syntheticIdPrefix, plan.robotSeed.value_or(plan.seed));
  result.set.headId = scene.set.urdf.empty() ? result.set.bodyId : "";
  CaptureTaker taker{robot, scene, plan};
  const bool hasSight = !scene.set.cameras.empty() || !scene.set.instruments.trackers.empty();
  if (!plan.given.empty() && !hasSight) {
    throw InputError{"expected a scene with cameras or trackers, to take given poses in, found places alone; give a "
                     "number of poses, and the robot touches the places as often"};
  }
  if (!plan.given.empty()) {
    taker.takeGivenPoses();
  } else if (hasSight) {
    taker.takeRandomPoses();
  }
  if (!robot.touches().empty()) {
    taker.takeTouches();
  }
  result.set.instruments.distances = measureDistances(scene, robot.set(), plan.sceneSeed.value_or(plan.seed));
  result.set.captures = std::move(taker.captures);
  result.scenes = std::move(taker.scenes);
  result.truth.seed = plan.seed;
  result.truth.effects = robot.listEffects();
  result.truth.noise = listNoise(scene, plan);
  result.truth.scene = listTrueScene(robot.set(), resultWorld(scene, robot, result.set.captures));
  if (plan.images) {
    replaceCorners(result.set.captures);
    result.lenses = robot.lenses();
  } else {
    result.truth.grossCorners = std::move(taker.gross);
  }
  const Robot& drawn = robot.robot();
  result.links = drawn.links.size();
  for (std::size_t link = 0; link < drawn.links.size(); ++link) {
    result.shapedLinks += std::any_of(drawn.collisionCapsules.begin(), drawn.collisionCapsules.end(),
                                      [&](const Capsule& capsule) { return capsule.link == link; })
                              ? 1
                              : 0;
  }
  return result;
}

} // namespace naocal

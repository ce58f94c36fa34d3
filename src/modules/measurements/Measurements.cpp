#include "measurements/Measurements.hpp"

#include "io/InputError.hpp"
#include "measurements/EncoderReadings.hpp"
#include "measurements/FrameRegistry.hpp"
#include "measurements/InitialPlacements.hpp"
#include "measurements/Noise.hpp"
#include "measurements/WitnessSource.hpp"
#include "robot/Kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <vector>

namespace naocal {

namespace {

/// One rest: readings without any motion in between, within tolerance.
struct Rest {
  int stance = 0, approach = 0;
  Eigen::VectorXd first;             // angles of the first reading [rad]
  std::vector<std::size_t> readings; // indices within the pose
};

/// Largest difference between readings of one rest, per joint [rad]; beyond it the robot moved.
using Tolerance = Eigen::ArrayXd;

/// Before jitter is known: one degree. Afterwards: 1.5 steps plus what jitter exceeds once in a million readings.
constexpr double mostJitter = 12 * encoderStep;

Tolerance toleranceFor(const std::vector<double>& jitter) {
  const Eigen::Map<const Eigen::ArrayXd> sigmas{jitter.data(), static_cast<Eigen::Index>(jitter.size())};
  return (1.5 * encoderStep + 7 * sigmas).min(mostJitter); // 5 sigma of a difference of two readings: 5 sqrt(2)
}

/// Groups a pose's pictures into readings (same stance, repeat and measured angles) and readings into rests. Readings
/// of one rest share each joint's encoder error: at rest a joint keeps its position and rounding error.
std::vector<Rest> groupPose(const Measurements& measurements, const std::vector<std::size_t>& members,
                            const Tolerance& tolerance, PoseGroup& pose) {
  std::vector<Rest> rests;
  std::set<int> stances;
  std::size_t approaches = 0;
  const ImageObservation* previous = nullptr;
  for (std::size_t index : members) {
    const ImageObservation& picture = measurements.pictures[index];
    const Capture& capture = measurements.captureOf(picture);
    const Capture* last = previous ? &measurements.captureOf(*previous) : nullptr;
    const bool sameReading = last && last->stance == capture.stance && last->repeat == capture.repeat &&
                             previous->instant.q == picture.instant.q;
    previous = &picture;
    if (sameReading) {
      pose.readings.back().pictures.push_back(index);
      continue;
    }
    const bool anew = last && last->repeat != capture.repeat && capture.repeatKind != RepeatKind::rest;
    pose.repeated |= anew;
    stances.insert(capture.stance);
    approaches += !last || anew ? 1 : 0;
    // Rest repeats get an error separate from their approach, although the encoder error is the same: it models errors
    // common to the corners of a picture. Sharing it would double the false alarms with biased pictures.
    const int approach = capture.repeatKind == RepeatKind::rest ? -1 : capture.repeat;
    auto rest = std::find_if(rests.begin(), rests.end(), [&](const Rest& other) {
      return other.stance == capture.stance && other.approach == approach &&
             ((other.first - picture.instant.q).array().abs() < tolerance).all();
    });
    if (rest == rests.end()) {
      rests.push_back({capture.stance, approach, picture.instant.q, {}});
      rest = rests.end() - 1;
    }
    rest->readings.push_back(pose.readings.size());
    pose.readings.push_back({.pictures = {index}, .encoderError = {}});
  }
  pose.restood = stances.size() > 1 && approaches > stances.size();
  return rests;
}

/// A joint's angles within one rest, one per reading.
RestReadings readingsOf(const Rest& rest, std::size_t joint, const PoseGroup& pose,
                        const std::vector<ImageObservation>& pictures) {
  std::vector<double> angles;
  for (const std::size_t reading : rest.readings) {
    angles.push_back(pictures[pose.readings[reading].pictures.front()].instant.q[static_cast<Eigen::Index>(joint)]);
  }
  return RestReadings{angles};
}

/// Readings of all rests per joint, pose by pose.
std::vector<std::vector<RestReadings>> collectReadings(const std::vector<std::vector<Rest>>& restsOf,
                                                       const Measurements& measurements) {
  const std::size_t joints = measurements.robot.joints.size();
  std::vector<std::vector<RestReadings>> readings(joints);
  for (std::size_t pose = 0; pose < measurements.poses.size(); ++pose) {
    for (const Rest& rest : restsOf[pose]) {
      for (std::size_t joint = 0; joint < joints; ++joint) {
        readings[joint].push_back(readingsOf(rest, joint, measurements.poses[pose], measurements.pictures));
      }
    }
  }
  return readings;
}

/// Encoder jitter of each joint. Excludes unrecorded joints, which always read zero; joints of one motor share its
/// encoder.
std::vector<double> jitterOf(std::vector<std::vector<RestReadings>> readings, const Measurements& measurements) {
  const auto isRecorded = [&](std::size_t joint) {
    return std::binary_search(measurements.recordedMotors.begin(), measurements.recordedMotors.end(), joint);
  };
  for (std::size_t joint = 0; joint < readings.size(); ++joint) {
    if (!isRecorded(joint)) {
      readings[joint].clear();
    }
  }
  const std::vector<double> ofMotors = estimateEncoderJitter(readings);
  std::vector<double> result;
  for (const Joint& joint : measurements.robot.joints) {
    result.push_back(isRecorded(joint.motor) ? ofMotors[joint.motor] : 0.0);
  }
  return result;
}

/// Step of a joint's encoder [rad]; 0 where the set of a robot with a URDF does not tell it.
double stepOf(const Measurements& measurements, std::size_t joint) {
  const CaptureSet& set = measurements.sets->front();
  if (set.urdf.empty()) {
    return encoderStep;
  }
  const auto step = set.encoderSteps.find(measurements.robot.joints[joint].name);
  return step == set.encoderSteps.end() ? 0 : step->second;
}

/// Assigns each joint of each rest its encoder error, and its most likely angle to all pictures of the rest.
void placeJoints(const std::vector<std::vector<Rest>>& restsOf, const std::vector<std::vector<RestReadings>>& readings,
                 Measurements& measurements) {
  const std::size_t joints = measurements.robot.joints.size();
  const double rounding = encoderStep / std::sqrt(12.0);
  std::size_t next = 0;
  for (std::size_t number = 0; number < measurements.poses.size(); ++number) {
    PoseGroup& pose = measurements.poses[number];
    for (const Rest& rest : restsOf[number]) {
      const std::size_t stance = measurements.pictures[pose.readings[rest.readings.front()].pictures.front()].stance;
      std::vector<std::size_t> errors(joints);
      std::map<std::size_t, std::size_t> ofMotor;
      for (std::size_t joint = 0; joint < joints; ++joint) {
        const auto [entry, isNew] =
            ofMotor.try_emplace(measurements.robot.joints[joint].motor, pose.encoderErrors.size());
        errors[joint] = entry->second;
        const RestReadings& read = readings[joint][next];
        const RestReadings::Place place = read.place(measurements.jitter[joint]);
        if (isNew) {
          const double usual = stepOf(measurements, measurements.robot.joints[joint].motor) / encoderStep;
          pose.encoderErrors.push_back(
              {measurements.jitter[joint] > 0 ? std::sqrt(place.variance) / rounding : usual, stance});
        }
        for (const std::size_t reading : rest.readings) {
          for (const std::size_t index : pose.readings[reading].pictures) {
            measurements.pictures[index].instant.q[static_cast<Eigen::Index>(joint)] = place.angle;
            measurements.pictures[index].nominal.angle(joint) = place.angle;
          }
        }
      }
      for (const std::size_t reading : rest.readings) {
        pose.readings[reading].encoderError = errors;
      }
      ++next;
    }
  }
}

/// Sets `repeats`: the number of pictures of the same rest, camera and board.
void countRepeats(const std::vector<Rest>& rests, const PoseGroup& pose, std::vector<ImageObservation>& pictures) {
  for (const Rest& rest : rests) {
    std::map<std::pair<std::size_t, std::size_t>, std::vector<BoardObservation*>> seen; // keyed by (camera, board)
    for (const std::size_t reading : rest.readings) {
      for (const std::size_t index : pose.readings[reading].pictures) {
        for (BoardObservation& observation : pictures[index].observations) {
          seen[{pictures[index].camera, observation.view.board()}].push_back(&observation);
        }
      }
    }
    for (const auto& [where, observations] : seen) {
      for (BoardObservation* observation : observations) {
        observation->repeats = observations.size();
      }
    }
  }
}

/// With both feet on the floor, adds the contact of the right sole; one measurement per pose.
void addFloorContact(const Measurements& measurements, ImageObservation& picture) {
  const Robot& robot = measurements.robot;
  if (picture.instant.supportFoot == SupportFoot::both) {
    picture.otherSole = ObservationChain::betweenLinks(robot, measurements.quantities, robot.findSole("right")->link,
                                                       robot.findSole("left")->link);
  }
}

/// Sorts the pictures into a canonical order.
void sortPictures(Measurements& measurements) {
  const auto key = [&](const ImageObservation& picture) {
    const Capture& capture = measurements.captureOf(picture);
    return std::tuple{picture.set,          capture.pose,   capture.stance, capture.repeat,
                      capture.time.count(), capture.camera, capture.id};
  };
  std::stable_sort(measurements.pictures.begin(), measurements.pictures.end(),
                   [&](const ImageObservation& a, const ImageObservation& b) { return key(a) < key(b); });
}

/// Groups the pictures of one reading and the readings of one pose. Fills `poses` and `jitter`; returns the rests per
/// pose.
std::vector<std::vector<Rest>> groupReadings(Measurements& measurements) {
  const auto& pictures = measurements.pictures;
  std::map<std::pair<std::size_t, std::string>, std::vector<std::size_t>> poses;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    if (!pictures[i].measuresNothing()) {
      poses[{pictures[i].set, measurements.captureOf(pictures[i]).pose}].push_back(i);
    }
  }
  std::vector<std::vector<Rest>> rests;
  Tolerance tolerance = Tolerance::Constant(static_cast<Eigen::Index>(measurements.robot.joints.size()), mostJitter);
  for (int pass = 0; pass < 2; ++pass) { // the first pass only estimates the jitter
    rests.clear();
    measurements.poses.clear();
    for (const auto& [name, members] : poses) {
      PoseGroup& pose = measurements.poses.emplace_back();
      pose.name = name.second;
      rests.push_back(groupPose(measurements, members, tolerance, pose));
    }
    measurements.jitter = jitterOf(collectReadings(rests, measurements), measurements);
    tolerance = toleranceFor(measurements.jitter);
  }
  return rests;
}

/// Motors that the observations depend on, in ascending order.
std::vector<std::size_t> observedMotors(const Measurements& measurements) {
  std::set<std::size_t> motors;
  const auto use = [&](const ObservationChain& view) {
    for (std::size_t joint : view.joints()) {
      motors.insert(measurements.robot.joints[joint].motor);
    }
  };
  for (const ImageObservation& picture : measurements.pictures) {
    for (const BoardObservation& observation : picture.observations) {
      use(observation.view);
    }
    for (const WitnessObservation& witness : picture.witnesses) {
      if (witness.view) {
        use(*witness.view);
      }
    }
    if (picture.otherSole) {
      use(*picture.otherSole);
    }
  }
  return {motors.begin(), motors.end()};
}

/// Sorts the pictures, groups those of one reading and readings of one pose. Fills `poses`, `joints` and `repeats`.
void groupByPose(Measurements& measurements) {
  sortPictures(measurements);
  const std::vector<std::vector<Rest>> rests = groupReadings(measurements);
  placeJoints(rests, collectReadings(rests, measurements), measurements);
  for (std::size_t pose = 0; pose < rests.size(); ++pose) {
    const std::vector<EncoderSample>& readings = measurements.poses[pose].readings;
    measurements.hasRepeats |= readings.size() > 1;
    addFloorContact(measurements, measurements.pictures[readings.front().pictures.front()]);
    countRepeats(rests[pose], measurements.poses[pose], measurements.pictures);
  }
  measurements.joints = observedMotors(measurements);
}

void refuseOtherRobots(const std::vector<CaptureSet>& sets) {
  const CaptureSet& first = sets.front();
  for (const CaptureSet& set : sets) {
    if (set.bodyId != first.bodyId || set.headId != first.headId || set.model != first.model) {
      throw InputError{fmt::format(
          "{}: robot: expected the robot of {} (model {}, body {}, head {}), found model {}, body "
          "{}, head {}; sets given together must be of one robot",
          set.name, first.name, first.model, first.bodyId, first.headId, set.model, set.bodyId, set.headId)};
    }
  }
}

Seconds earliestTime(const CaptureSet& set) {
  Seconds first = Seconds::max();
  for (const Capture& capture : set.captures) {
    first = std::min(first, capture.time);
  }
  return first;
}

/// Motors recorded in every capture, each by the index of one of its joints.
std::vector<std::size_t> recordedMotors(const std::vector<CaptureSet>& sets, const Robot& robot) {
  std::map<std::size_t, std::size_t> captures; // motor -> number of captures
  std::size_t all = 0;
  for (const CaptureSet& set : sets) {
    for (const Capture& capture : set.captures) {
      ++all;
      std::set<std::size_t> motors;
      for (std::size_t i = 0; i < set.jointNames.size(); ++i) {
        const auto joint = robot.jointIndex(set.jointNames[i]);
        if (joint && !std::isnan(capture.joints.measured[i])) {
          motors.insert(robot.joints[*joint].motor);
        }
      }
      for (const std::size_t motor : motors) {
        ++captures[motor];
      }
    }
  }
  std::vector<std::size_t> result;
  for (const auto& [motor, count] : captures) {
    if (count == all) {
      result.push_back(motor);
    }
  }
  return result;
}

/// How a joint that mimics follows its motor's joint: as its angle, as its speed, or with the same value.
enum class Follows { angle, speed, value };

double followed(const Joint& joint, double ofMotor, Follows how) {
  return how == Follows::angle   ? joint.ratio * ofMotor + joint.shift
         : how == Follows::speed ? joint.ratio * ofMotor
                                 : ofMotor;
}

/// Values of `list` per joint of the robot, or NaN. Joints of one motor follow it; where only another of its joints was
/// recorded, that joint's ratio tells the motor's.
Eigen::VectorXd perJoint(const Robot& robot, const CaptureSet& set, const std::vector<double>& list, Follows how) {
  Eigen::VectorXd values =
      Eigen::VectorXd::Constant(static_cast<Eigen::Index>(robot.joints.size()), RobotSample::nothing);
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (const auto joint = robot.jointIndex(set.jointNames[i])) {
      values[static_cast<Eigen::Index>(*joint)] = list[i];
    }
  }
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    const auto own = static_cast<Eigen::Index>(joint);
    const auto motor = static_cast<Eigen::Index>(robot.joints[joint].motor);
    if (own != motor) {
      const Joint& follower = robot.joints[joint];
      if (std::isnan(values[motor]) && (how == Follows::value || follower.ratio != 0)) {
        values[motor] =
            how == Follows::value ? values[own] : (values[own] - followed(follower, 0, how)) / follower.ratio;
      }
      values[own] = followed(follower, values[motor], how);
    }
  }
  return values;
}

/// The left foot's share of the weight according to the force sensors; NaN if unknown.
double leftLoad(const Capture& capture) {
  if (!capture.fsr) {
    return RobotSample::nothing;
  }
  const auto middle = capture.fsr->begin() + 4;
  const double left = std::accumulate(capture.fsr->begin(), middle, 0.0);
  const double right = std::accumulate(middle, capture.fsr->end(), 0.0);
  return left + right > 0 ? left / (left + right) : RobotSample::nothing;
}

void addObservation(const CaptureSet& set, const Capture& capture, const BoardCorners& corners, std::size_t targetIndex,
                    const Measurements& measurements, ImageObservation& result) {
  const Robot& robot = measurements.robot;
  const Target& target = measurements.targets[targetIndex];
  const std::optional<std::size_t> support = measurements.stances[result.stance].supportLink;
  if (corners.ids.empty() || (target.inWorld && !support)) {
    return;
  }
  const std::size_t link = target.inWorld ? *support : *robot.linkIndex(target.board.link);
  const bool standsBeside = robot.cameras[result.camera].inWorld;
  if (standsBeside && (!support || target.inWorld)) {
    return; // tells nothing about the robot
  }
  ObservationChain view{robot,
                        measurements.quantities,
                        result.camera,
                        link,
                        target.inWorld,
                        targetIndex,
                        standsBeside ? support : std::nullopt};
  for (std::size_t joint : view.joints()) {
    if (std::isnan(result.instant.q[static_cast<Eigen::Index>(joint)])) {
      throw InputError{fmt::format("{}: capture {}: joints.measured: {} was not recorded but board {} is seen along it",
                                   set.name, capture.id, robot.joints[joint].name, corners.board)};
    }
  }
  result.observations.push_back({std::move(view), packCorners(target.board, corners), corners.ids});
}

/// Measured angles, or rest angles where not recorded.
void drawAngles(const Robot& robot, ImageObservation& result) {
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    double& angle = result.instant.q[static_cast<Eigen::Index>(joint)];
    if (std::isnan(angle)) {
      angle = robot.joints[joint].restAngle;
    }
    result.nominal.angle(joint) = angle;
  }
}

Twist toNumbers(const Placement& p) {
  return (Twist{} << p.x, p.y, p.z, p.roll, p.pitch, p.yaw).finished();
}

void drawLens(const CameraIntrinsics& camera, ImageObservation& result) {
  result.nominal.lens().head<4>() << camera.fx, camera.fy, camera.cx, camera.cy;
  for (std::size_t i = 0; i < camera.distortion.size(); ++i) {
    result.nominal.lens()[static_cast<Eigen::Index>(4 + i)] = camera.distortion[i];
  }
}

/// Sets known or guessed placements.
void drawScene(const Measurements& measurements, ImageObservation& result) {
  result.nominal.worldFromSupport() = toNumbers(measurements.stances[result.stance].placement);
  for (std::size_t target = 0; target < measurements.targets.size(); ++target) {
    const Board& board = measurements.targets[target].board;
    result.nominal.boardPlacement(target) = toNumbers(board.placement.value_or(board.placementGuess));
  }
}

/// Sets the placements of instruments and what they measure; unknown ones count from their references.
void drawInstruments(const InstrumentList& instruments, ModelState& nominal) {
  for (std::size_t i = 0; i < instruments.trackers.size(); ++i) {
    nominal.trackerPlacement(i) = toNumbers(instruments.trackers[i].tracker.placement.value_or(Placement{}));
  }
  for (std::size_t i = 0; i < instruments.markers.size(); ++i) {
    const TrackedMarker& marker = instruments.markers[i].marker;
    nominal.marker(i) = marker.point.value_or(marker.pointGuess);
  }
  for (std::size_t i = 0; i < instruments.frames.size(); ++i) {
    nominal.framePlacement(i) = toNumbers(instruments.frames[i].frame.placement.value_or(Placement{}));
  }
  for (std::size_t i = 0; i < instruments.places.size(); ++i) {
    nominal.place(i) = instruments.places[i].place.point.value_or(Eigen::Vector3d::Zero());
  }
}

/// Against gravity, in the support's frame.
Eigen::Vector3d upInSupport(const CaptureSet& set, const StanceInstance& stance) {
  return transformFromPlacement(toNumbers(stance.placement)).rotation.transpose() * -set.gravity.normalized();
}

/// Converts one capture to the robot's joints, cameras and targets. Requires robot, quantities and targets in
/// `measurements`. Throws InputError for captures that do not fit the robot (unknown camera, no corners, required joint
/// not recorded).
ImageObservation makeImageObservation(std::size_t setIndex, std::size_t index, const Measurements& measurements,
                                      const FrameRegistry& places) {
  const Robot& robot = measurements.robot;
  const CaptureSet& set = (*measurements.sets)[setIndex];
  const Capture& capture = set.captures[index];
  const bool hasPicture = !capture.camera.empty();
  if (hasPicture && !capture.corners) {
    throw InputError{fmt::format("{}: captures[{}] (id {}): no corners yet; run 'naocal detect {}' first", set.name,
                                 index, capture.id, set.name)};
  }
  const auto camera = robot.cameraIndex(capture.camera);
  if (hasPicture && !camera) {
    throw InputError{fmt::format("{}: captures[{}].camera: the {} has no camera '{}'", set.name, index, robot.model,
                                 capture.camera)};
  }
  ImageObservation result{.set = setIndex,
                          .capture = index,
                          .camera = camera.value_or(ImageObservation::noCamera),
                          .stance = places.stanceIndex(set, capture.stance),
                          .instant = {.time = capture.time,
                                      .supportFoot = capture.supportFoot,
                                      .q = perJoint(robot, set, capture.joints.measured, Follows::angle),
                                      .velocity = perJoint(robot, set, capture.joints.velocity, Follows::speed),
                                      .approach = perJoint(robot, set, capture.joints.approach, Follows::value),
                                      .temperature = perJoint(robot, set, capture.joints.temperature, Follows::value),
                                      .current = perJoint(robot, set, capture.joints.current, Follows::value),
                                      .imu = capture.imu.value_or(Eigen::Vector2d::Constant(RobotSample::nothing)),
                                      .leftLoad = leftLoad(capture)},
                          .nominal = nominalState(robot, measurements.quantities),
                          .observations = {}};
  if (!set.urdf.empty()) {
    const StanceInstance& stance = measurements.stances[result.stance];
    result.instant.supportLink = stance.supportLink;
    result.instant.upInSupport = upInSupport(set, stance);
  }
  for (const BoardCorners& corners : capture.corners.value_or(std::vector<BoardCorners>{})) {
    addObservation(set, capture, corners, places.targetIndex(set, corners.board), measurements, result);
  }
  drawAngles(robot, result);
  drawScene(measurements, result);
  if (hasPicture) {
    drawLens(set.cameras.at(capture.camera), result);
  }
  return result;
}

/// Estimates unknown placements of a robot with a URDF, and lets the state's numbers count from them.
void referPlacements(Measurements& measurements, const FrameRegistry& places) {
  placeInitially(measurements, [&](const CaptureSet& set, const std::string& id) { return places.scopedId(set, id); });
  for (ImageObservation& picture : measurements.pictures) {
    for (BoardObservation& observation : picture.observations) {
      observation.view.setReference(measurements.targets[observation.view.board()].reference);
    }
    drawInstruments(measurements.instruments, picture.nominal);
  }
}

/// Adds the measurements other than corners: those of each capture, and the distances, which belong to none, to the
/// first picture.
void addWitnesses(Measurements& measurements, const FrameRegistry& places) {
  for (ImageObservation& picture : measurements.pictures) {
    const CaptureSet& set = measurements.setOf(picture);
    const Capture& capture = measurements.captureOf(picture);
    const Eigen::VectorXd recorded = perJoint(measurements.robot, set, capture.joints.measured, Follows::angle);
    WitnessSource source{.set = set,
                         .capture = capture,
                         .stance = picture.stance,
                         .recorded = recorded,
                         .measurements = measurements,
                         .nameOf = [&](const std::string& id) { return places.scopedId(set, id); },
                         .witnesses = picture.witnesses};
    for (const auto& addKind : witnessKinds()) {
      addKind(source);
    }
    measurements.witnessCount += picture.witnesses.size();
  }
  for (const CaptureSet& set : *measurements.sets) {
    for (WitnessObservation& distance :
         makePlaceDistances(measurements, set, [&](const std::string& id) { return places.scopedId(set, id); })) {
      measurements.pictures.front().witnesses.push_back(std::move(distance));
    }
  }
}

} // namespace

bool Measurements::isCameraUnknown(std::size_t camera) const {
  const auto mounting = sets->front().mountings.find(robot.cameras[camera].name);
  return robot.cameras[camera].inWorld && mounting != sets->front().mountings.end() && !mounting->second.placement;
}

double sigmaOf(const Measurements& measurements, const Noise& noise, std::size_t level) {
  return noise.readings.empty() ? measurements.levels[level].sigma : noise.readings[level];
}

std::vector<std::size_t> posesOfPictures(const Measurements& measurements) {
  std::vector<std::size_t> result(measurements.pictures.size());
  for (std::size_t pose = 0; pose < measurements.poses.size(); ++pose) {
    for (const EncoderSample& reading : measurements.poses[pose].readings) {
      for (const std::size_t picture : reading.pictures) {
        result[picture] = pose;
      }
    }
  }
  return result;
}

Measurements buildMeasurements(std::vector<CaptureSet> given, const Robot& robot, bool samePlace) {
  refuseOtherRobots(given);
  const FrameRegistry places{given, robot, samePlace};
  Measurements result;
  result.sets = std::make_shared<const std::vector<CaptureSet>>(std::move(given));
  const std::vector<CaptureSet>& sets = *result.sets;
  result.robot = robot;
  result.samePlace = samePlace;
  result.instruments = places.instruments();
  const InstrumentList& instruments = result.instruments;
  const bool isUrdf = !sets.front().urdf.empty();
  result.quantities = StateLayout{robot.joints.size(),
                                  robot.lengths.size(),
                                  places.targets().size(),
                                  {.trackers = instruments.trackers.size(),
                                   .markers = instruments.markers.size(),
                                   .frames = instruments.frames.size(),
                                   .places = instruments.places.size(),
                                   .hasLinkSteps = isUrdf}};
  result.targets = places.targets();
  result.stances = places.stances();
  result.recordedMotors = recordedMotors(sets, robot);
  for (std::size_t set = 0; set < sets.size(); ++set) {
    const Seconds first = earliestTime(sets[set]);
    for (std::size_t capture = 0; capture < sets[set].captures.size(); ++capture) {
      result.pictures.push_back(makeImageObservation(set, capture, result, places));
      result.pictures.back().instant.time -= first;
      result.pictures.back().instant.set = set;
      for (const BoardObservation& observation : result.pictures.back().observations) {
        result.cornerCount += observation.ids.size();
      }
    }
  }
  if (isUrdf || !instruments.trackers.empty() || !instruments.places.empty()) {
    referPlacements(result, places);
    addWitnesses(result, places);
  }
  groupByPose(result);
  return result;
}

std::vector<std::size_t> observedJoints(const Robot& robot, const ImageObservation& picture) {
  std::vector<char> between(robot.joints.size(), 0);
  const auto add = [&](const ObservationChain& view) {
    for (const std::size_t joint : view.joints()) {
      between[joint] = 1;
    }
  };
  for (const BoardObservation& observation : picture.observations) {
    add(observation.view);
  }
  for (const WitnessObservation& witness : picture.witnesses) {
    if (witness.view) {
      add(*witness.view);
    }
  }
  if (picture.otherSole) {
    add(*picture.otherSole);
  }
  std::vector<std::size_t> joints;
  for (std::size_t joint = 0; joint < between.size(); ++joint) {
    if (between[joint] != 0) {
      joints.push_back(joint);
    }
  }
  return joints;
}

} // namespace naocal

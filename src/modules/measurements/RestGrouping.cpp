#include "measurements/RestGrouping.hpp"

#include "measurements/CaptureReading.hpp"
#include "measurements/EncoderReadings.hpp"
#include "measurements/Noise.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

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

/// The step of a joint's encoder, as its set tells it [rad]. A set of a robot with a URDF need not.
std::optional<double> givenStep(const Measurements& measurements, std::size_t joint) {
  const CaptureSet& set = measurements.sets->front();
  if (set.urdf.empty()) {
    return encoderStep;
  }
  const auto step = set.encoderSteps.find(measurements.robot.joints[joint].name);
  return step == set.encoderSteps.end() ? std::nullopt : std::optional{step->second};
}

/// Steps of the joints' encoders [rad]: as given, else of 12 bits, the coarsest in use. Joints of one motor share its
/// encoder.
Eigen::ArrayXd encoderSteps(const Measurements& measurements) {
  const std::vector<Joint>& joints = measurements.robot.joints;
  Eigen::ArrayXd steps(static_cast<Eigen::Index>(joints.size()));
  for (std::size_t joint = 0; joint < joints.size(); ++joint) {
    steps[static_cast<Eigen::Index>(joint)] = givenStep(measurements, joints[joint].motor).value_or(encoderStep);
  }
  return steps;
}

/// Before jitter is known; of a NAO's encoder: one degree.
Tolerance widestTolerance(const Eigen::ArrayXd& steps) {
  return 12 * steps;
}

/// 1.5 steps plus what jitter exceeds once in a million readings: 5 sigma of a difference of two readings, 5 sqrt(2).
Tolerance toleranceFor(const std::vector<double>& jitter, const Eigen::ArrayXd& steps) {
  const Eigen::Map<const Eigen::ArrayXd> sigmas{jitter.data(), static_cast<Eigen::Index>(jitter.size())};
  return (1.5 * steps + 7 * sigmas).min(widestTolerance(steps));
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
    const bool anew = last && (last->repeat != capture.repeat || last->stance != capture.stance) &&
                      capture.repeatKind != RepeatKind::rest;
    pose.repeated |= anew;
    stances.insert(capture.stance);
    approaches += !last || anew ? 1 : 0;
    // Rest repeats get an error separate from their approach, although the encoder error is the same: it models errors
    // common to the corners of a picture. Sharing it would double the false alarms with biased pictures. Those of
    // different approaches have different ones, for a joint rests elsewhere each time.
    const int approach = capture.repeatKind == RepeatKind::rest ? -1 - static_cast<int>(approaches) : capture.repeat;
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
std::vector<double> anglesOf(const Rest& rest, std::size_t joint, const PoseGroup& pose,
                             const std::vector<ImageObservation>& pictures) {
  std::vector<double> angles;
  for (const std::size_t reading : rest.readings) {
    angles.push_back(pictures[pose.readings[reading].pictures.front()].instant.q[static_cast<Eigen::Index>(joint)]);
  }
  return angles;
}

/// Readings of all rests per joint, pose by pose.
std::vector<std::vector<RestReadings>> collectReadings(const std::vector<std::vector<Rest>>& restsOf,
                                                       const Measurements& measurements) {
  const std::size_t joints = measurements.robot.joints.size();
  const Eigen::ArrayXd steps = encoderSteps(measurements);
  std::vector<std::vector<RestReadings>> readings(joints);
  for (std::size_t pose = 0; pose < measurements.poses.size(); ++pose) {
    for (const Rest& rest : restsOf[pose]) {
      for (std::size_t joint = 0; joint < joints; ++joint) {
        readings[joint].emplace_back(anglesOf(rest, joint, measurements.poses[pose], measurements.pictures),
                                     steps[static_cast<Eigen::Index>(joint)]);
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
          const double usual =
              givenStep(measurements, measurements.robot.joints[joint].motor).value_or(0) / encoderStep;
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

/// With several feet on the floor, adds the contacts of all but the first; one measurement per pose and foot. A leg
/// whose joints were not recorded says nothing about its foot.
void addFloorContacts(const Measurements& measurements, ImageObservation& picture) {
  const StanceInstance& stance = measurements.stances[picture.stance];
  const Eigen::VectorXd recorded =
      measuredAngles(measurements.robot, (*measurements.sets)[picture.set], measurements.captureOf(picture));
  for (const std::size_t sole : stance.furtherSoles) {
    ObservationChain contact =
        ObservationChain::betweenLinks(measurements.robot, measurements.quantities, sole, *stance.supportLink);
    const std::vector<std::size_t>& joints = contact.joints();
    if (std::none_of(joints.begin(), joints.end(),
                     [&](std::size_t joint) { return std::isnan(recorded[static_cast<Eigen::Index>(joint)]); })) {
      picture.otherSoles.push_back(std::move(contact));
    }
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
  const Eigen::ArrayXd steps = encoderSteps(measurements);
  Tolerance tolerance = widestTolerance(steps);
  for (int pass = 0; pass < 2; ++pass) { // the first pass only estimates the jitter
    rests.clear();
    measurements.poses.clear();
    for (const auto& [name, members] : poses) {
      PoseGroup& pose = measurements.poses.emplace_back();
      pose.name = name.second;
      rests.push_back(groupPose(measurements, members, tolerance, pose));
    }
    measurements.jitter = jitterOf(collectReadings(rests, measurements), measurements);
    tolerance = toleranceFor(measurements.jitter, steps);
  }
  return rests;
}

/// Motors that the observations depend on, in ascending order.
std::vector<std::size_t> observedMotors(const Measurements& measurements) {
  std::set<std::size_t> motors;
  for (const ImageObservation& picture : measurements.pictures) {
    for (const std::size_t joint : observedJoints(measurements.robot, picture)) {
      motors.insert(measurements.robot.joints[joint].motor);
    }
  }
  return {motors.begin(), motors.end()};
}

} // namespace

Eigen::ArrayXd restTolerance(const Measurements& measurements) {
  return toleranceFor(measurements.jitter, encoderSteps(measurements));
}

void groupByPose(Measurements& measurements) {
  sortPictures(measurements);
  const std::vector<std::vector<Rest>> rests = groupReadings(measurements);
  placeJoints(rests, collectReadings(rests, measurements), measurements);
  for (std::size_t pose = 0; pose < rests.size(); ++pose) {
    const std::vector<EncoderSample>& readings = measurements.poses[pose].readings;
    measurements.hasRepeats |= readings.size() > 1;
    addFloorContacts(measurements, measurements.pictures[readings.front().pictures.front()]);
    countRepeats(rests[pose], measurements.poses[pose], measurements.pictures);
  }
  measurements.joints = observedMotors(measurements);
}

} // namespace naocal

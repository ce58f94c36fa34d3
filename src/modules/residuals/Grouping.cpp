#include "residuals/Grouping.hpp"

#include "residuals/EncoderReadings.hpp"
#include "residuals/Noise.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

namespace naocal {

namespace {

/// One rest: readings between which nothing moved, as far as they tell.
struct Rest {
  int stance = 0, approach = 0;
  Eigen::VectorXd first;             // angles of its first reading [rad]
  std::vector<std::size_t> readings; // of the pose
};

/// How far readings of one rest may differ, per joint [rad]; beyond that the robot moved between them.
using Tolerance = Eigen::ArrayXd;

/// Before any jitter is known: a degree. Then what jitter leaves out once in a million readings, and a step between.
constexpr double mostJitter = 12 * encoderStep;

Tolerance toleranceFor(const std::vector<double>& jitter) {
  const Eigen::Map<const Eigen::ArrayXd> sigmas{jitter.data(), static_cast<Eigen::Index>(jitter.size())};
  return (1.5 * encoderStep + 7 * sigmas).min(mostJitter); // of a difference of two: 5 times sqrt(2)
}

/// Groups a pose's pictures: those with the same stance, repeat and measured angles share a reading; readings of one
/// rest share each joint's encoder error, for as long as the robot rests a joint keeps its rounding error and its
/// place.
std::vector<Rest> groupPose(const std::vector<CaptureSet>& sets, const std::vector<std::size_t>& members,
                            const std::vector<Picture>& pictures, const Tolerance& tolerance, PoseGroup& pose) {
  std::vector<Rest> rests;
  std::set<int> stances;
  std::size_t approaches = 0;
  const Picture* previous = nullptr;
  for (std::size_t index : members) {
    const Picture& picture = pictures[index];
    const Capture& capture = sets[picture.set].captures[picture.capture];
    const Capture* last = previous ? &sets[previous->set].captures[previous->capture] : nullptr;
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
    // Rest after an approach has an error of its own, though the encoder's is that approach's: it stands for what
    // corners of one picture have in common. Shared, it makes twice as many false alarms where pictures are biased.
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

/// What a joint was read as in one rest, once per reading.
RestReadings readingsOf(const Rest& rest, std::size_t joint, const PoseGroup& pose,
                        const std::vector<Picture>& pictures) {
  std::vector<double> angles;
  for (const std::size_t reading : rest.readings) {
    angles.push_back(pictures[pose.readings[reading].pictures.front()].instant.q[static_cast<Eigen::Index>(joint)]);
  }
  return RestReadings{angles};
}

/// Per joint the readings of all rests, pose after pose.
std::vector<std::vector<RestReadings>> allReadings(const std::vector<std::vector<Rest>>& restsOf,
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

/// The jitter of each joint's encoder. What was not recorded reads zero, always, and tells of no encoder; joints of one
/// motor share its encoder.
std::vector<double> jitterOf(std::vector<std::vector<RestReadings>> readings, const Measurements& measurements) {
  const auto isRecorded = [&](std::size_t joint) {
    return std::binary_search(measurements.recorded.begin(), measurements.recorded.end(), joint);
  };
  for (std::size_t joint = 0; joint < readings.size(); ++joint) {
    if (!isRecorded(joint)) {
      readings[joint].clear();
    }
  }
  const std::vector<double> ofMotors = encoderJitter(readings);
  std::vector<double> result;
  for (const Joint& joint : measurements.robot.joints) {
    result.push_back(isRecorded(joint.motor) ? ofMotors[joint.motor] : 0.0);
  }
  return result;
}

/// Gives each joint of each rest its encoder error, and its likeliest place to all pictures of the rest.
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
          pose.encoderErrors.push_back(
              {measurements.jitter[joint] > 0 ? std::sqrt(place.variance) / rounding : 1, stance});
        }
        for (const std::size_t reading : rest.readings) {
          for (const std::size_t index : pose.readings[reading].pictures) {
            measurements.pictures[index].instant.q[static_cast<Eigen::Index>(joint)] = place.angle;
            measurements.pictures[index].drawn.angle(joint) = place.angle;
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

/// Tells each sighting how many pictures of its rest show the same board to the same camera.
void countRepeats(const std::vector<Rest>& rests, const PoseGroup& pose, std::vector<Picture>& pictures) {
  for (const Rest& rest : rests) {
    std::map<std::pair<std::size_t, std::size_t>, std::vector<Sighting*>> seen; // by camera and board
    for (const std::size_t reading : rest.readings) {
      for (const std::size_t index : pose.readings[reading].pictures) {
        for (Sighting& sighting : pictures[index].sightings) {
          seen[{pictures[index].camera, sighting.view.board()}].push_back(&sighting);
        }
      }
    }
    for (const auto& [where, sightings] : seen) {
      for (Sighting* sighting : sightings) {
        sighting->repeats = sightings.size();
      }
    }
  }
}

/// On both feet the right sole lies flat on the floor too: one more measurement, told once per pose.
void addFloorContact(const Measurements& measurements, Picture& picture) {
  const Robot& robot = measurements.robot;
  if (picture.instant.supportFoot == SupportFoot::both) {
    picture.otherSole =
        View::betweenLinks(robot, measurements.quantities, robot.sole("right")->link, robot.sole("left")->link);
  }
}

} // namespace

void groupReadings(const std::vector<CaptureSet>& sets, Measurements& measurements) {
  auto& pictures = measurements.pictures;
  const auto key = [&](const Picture& picture) {
    const Capture& capture = sets[picture.set].captures[picture.capture];
    return std::tuple{picture.set,          capture.pose,   capture.stance, capture.repeat,
                      capture.time.count(), capture.camera, capture.id};
  };
  std::stable_sort(pictures.begin(), pictures.end(),
                   [&](const Picture& a, const Picture& b) { return key(a) < key(b); });
  std::map<std::pair<std::size_t, std::string>, std::vector<std::size_t>> poses;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    if (!pictures[i].sightings.empty()) {
      poses[{pictures[i].set, sets[pictures[i].set].captures[pictures[i].capture].pose}].push_back(i);
    }
  }
  std::vector<std::vector<Rest>> rests; // per pose
  Tolerance tolerance = Tolerance::Constant(static_cast<Eigen::Index>(measurements.robot.joints.size()), mostJitter);
  for (int pass = 0; pass < 2; ++pass) { // the first one only to learn how much readings jitter
    rests.clear();
    measurements.poses.clear();
    for (const auto& [name, members] : poses) {
      PoseGroup& pose = measurements.poses.emplace_back();
      pose.name = name.second;
      rests.push_back(groupPose(sets, members, measurements.pictures, tolerance, pose));
    }
    measurements.jitter = jitterOf(allReadings(rests, measurements), measurements);
    tolerance = toleranceFor(measurements.jitter);
  }
  placeJoints(rests, allReadings(rests, measurements), measurements);
  for (std::size_t pose = 0; pose < rests.size(); ++pose) {
    const std::vector<Reading>& readings = measurements.poses[pose].readings;
    measurements.repeats |= readings.size() > 1;
    addFloorContact(measurements, measurements.pictures[readings.front().pictures.front()]);
    countRepeats(rests[pose], measurements.poses[pose], measurements.pictures);
  }
  std::set<std::size_t> motors;
  const auto use = [&](const View& view) {
    for (std::size_t joint : view.joints()) {
      motors.insert(measurements.robot.joints[joint].motor);
    }
  };
  for (const Picture& picture : pictures) {
    for (const Sighting& sighting : picture.sightings) {
      use(sighting.view);
    }
    if (picture.otherSole) {
      use(*picture.otherSole);
    }
  }
  measurements.joints.assign(motors.begin(), motors.end());
}

} // namespace naocal

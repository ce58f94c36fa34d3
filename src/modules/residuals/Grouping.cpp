#include "residuals/Grouping.hpp"

#include "residuals/Noise.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

namespace naocal {

namespace {

/// Which part of a rest has these angles [rad]: where the robot stood, as it was read first; a new one where it did
/// not.
std::size_t partOf(const Eigen::VectorXd& angles, std::vector<Eigen::VectorXd>& parts) {
  constexpr double flip = 1.5 * encoderStep; // between two steps
  const auto found = std::find_if(parts.begin(), parts.end(), [&](const Eigen::VectorXd& first) {
    return (first - angles).cwiseAbs().maxCoeff() < flip;
  });
  const auto part = static_cast<std::size_t>(found - parts.begin());
  if (found == parts.end()) {
    parts.push_back(angles);
  }
  return part;
}

/// Pictures of one pose: those with the same stance, repeat and measured angles share a reading. As long as the robot
/// rests, a joint keeps its rounding error, and readings that flip between two steps tell that it stands at the edge
/// between them; every approach gives every joint a new error, and so does a reading that no flip explains.
void groupPose(const std::vector<CaptureSet>& sets, const std::vector<std::size_t>& members, const Robot& robot,
               std::vector<Picture>& pictures, PoseGroup& pose) {
  constexpr double atEdge = 0.3; // of the rounding error's size: what the encoder's dither leaves
  std::map<std::tuple<std::size_t, int, int, std::size_t>, std::size_t> known; // motor, stance, approach, part -> error
  std::map<std::pair<int, int>, std::vector<Eigen::VectorXd>> rests;           // per stance and approach
  std::map<std::size_t, std::set<double>> angles;                              // per error, the readings seen
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
    pose.repeated |= last && last->repeat != capture.repeat && capture.repeatKind != RepeatKind::rest;
    stances.insert(capture.stance);
    approaches += !last || (last->repeat != capture.repeat && capture.repeatKind != RepeatKind::rest) ? 1 : 0;
    // Rest after an approach has an error of its own, though the encoder's is that approach's: it stands for what
    // corners of one picture have in common. Shared, it makes twice as many false alarms where pictures are biased.
    const int approach = capture.repeatKind == RepeatKind::rest ? -1 : capture.repeat;
    const std::size_t part = partOf(picture.instant.q, rests[{capture.stance, approach}]);
    Reading reading{.pictures = {index}, .encoderError = std::vector<std::size_t>(robot.joints.size())};
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
      const auto [entry, isNew] =
          known.try_emplace({robot.joints[joint].motor, capture.stance, approach, part}, pose.encoderErrors.size());
      if (isNew) {
        pose.encoderErrors.push_back({1, picture.stance});
      }
      reading.encoderError[joint] = entry->second;
      angles[entry->second].insert(picture.instant.q[static_cast<Eigen::Index>(joint)]);
    }
    pose.readings.push_back(std::move(reading));
  }
  pose.restood = stances.size() > 1 && approaches > stances.size();
  for (const Reading& reading : pose.readings) {
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
      const std::set<double>& seen = angles.at(reading.encoderError[joint]);
      if (seen.size() == 1) {
        continue;
      }
      pose.encoderErrors[reading.encoderError[joint]].scale = atEdge;
      const double edge = std::accumulate(seen.begin(), seen.end(), 0.0) / static_cast<double>(seen.size());
      for (std::size_t index : reading.pictures) {
        pictures[index].instant.q[static_cast<Eigen::Index>(joint)] = edge;
        pictures[index].drawn.angle(joint) = edge;
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
  std::set<std::size_t> motors;
  for (const auto& [name, members] : poses) {
    PoseGroup pose;
    pose.name = name.second;
    groupPose(sets, members, measurements.robot, measurements.pictures, pose);
    measurements.repeats |= pose.readings.size() > 1;
    addFloorContact(measurements, measurements.pictures[pose.readings.front().pictures.front()]);
    measurements.poses.push_back(std::move(pose));
  }
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

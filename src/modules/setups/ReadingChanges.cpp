#include "setups/ReadingChanges.hpp"

#include "measurements/JointMotion.hpp"

#include "measurements/Measurements.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace naocal {

namespace {

/// Where a set's captures list a joint.
std::optional<std::size_t> columnOf(const CaptureSet& set, const std::string& joint) {
  const auto found = std::find(set.jointNames.begin(), set.jointNames.end(), joint);
  return found == set.jointNames.end() ? std::nullopt
                                       : std::optional{static_cast<std::size_t>(found - set.jointNames.begin())};
}

/// Calls `change` with the readings of every capture that lists the joint, and the joint's place among them.
void changeReadings(std::vector<CaptureSet>& sets, const std::string& joint,
                    const std::function<void(JointReadings&, std::size_t)>& change) {
  for (CaptureSet& set : sets) {
    if (const auto column = columnOf(set, joint)) {
      for (Capture& capture : set.captures) {
        change(capture.joints, *column);
      }
    }
  }
}

} // namespace

std::vector<std::string> namesOfJoints(const Measurements& measurements) {
  std::vector<std::string> names;
  for (const std::size_t joint : measurements.joints) {
    names.push_back(measurements.robot.joints[joint].name);
  }
  return names;
}

std::vector<std::string> namesOfMovingJoints(const Measurements& measurements) {
  std::vector<std::string> names;
  for (const std::size_t joint : measurements.joints) {
    if (!isStill(joint, measurements)) {
      names.push_back(measurements.robot.joints[joint].name);
    }
  }
  return names;
}

std::vector<std::string> trackerIds(const std::vector<CaptureSet>& sets) {
  std::vector<std::string> ids;
  for (const CaptureSet& set : sets) {
    for (const Tracker& tracker : set.instruments.trackers) {
      if (std::find(ids.begin(), ids.end(), tracker.id) == ids.end()) {
        ids.push_back(tracker.id);
      }
    }
  }
  return ids;
}

std::vector<std::string> trackersOfFrames(const Measurements& measurements) {
  std::vector<std::string> ids = trackerIds(*measurements.sets);
  std::erase_if(ids, [&](const std::string& id) {
    return std::none_of(measurements.sets->begin(), measurements.sets->end(), [&](const CaptureSet& set) {
      return std::any_of(set.captures.begin(), set.captures.end(), [&](const Capture& capture) {
        return std::any_of(capture.frames.begin(), capture.frames.end(),
                           [&](const FrameReading& reading) { return reading.tracker == id; });
      });
    });
  });
  return ids;
}

std::vector<std::string> listPairs(const std::vector<std::string>& names) {
  std::vector<std::string> pairs;
  for (std::size_t one = 0; one < names.size(); ++one) {
    for (std::size_t other = one + 1; other < names.size(); ++other) {
      pairs.push_back(names[one] + ',' + names[other]);
    }
  }
  return pairs;
}

std::pair<std::string, std::string> splitPair(const std::string& pair) {
  return {pair.substr(0, pair.find(',')), pair.substr(pair.find(',') + 1)};
}

bool areNearOnChain(const Robot& robot, const std::string& joint, const std::string& other) {
  constexpr int most = 2; // steps
  const auto isWithin = [&](std::size_t from, std::size_t to) {
    int steps = 0;
    for (std::optional<std::size_t> link = robot.joints[from].link; link && steps <= most;
         link = robot.links[*link].parent) {
      const std::optional<std::size_t>& here = robot.links[*link].joint;
      if (here == to) {
        return true;
      }
      steps += here ? 1 : 0;
    }
    return false;
  };
  const std::size_t one = *robot.jointIndex(joint), two = *robot.jointIndex(other);
  return isWithin(one, two) || isWithin(two, one);
}

void scaleJoint(std::vector<CaptureSet>& sets, const std::string& joint, double factor) {
  changeReadings(sets, joint, [&](JointReadings& readings, std::size_t column) {
    for (std::vector<double>* values : {&readings.measured, &readings.commanded, &readings.velocity}) {
      if (column < values->size()) { // what was not recorded is empty
        (*values)[column] *= factor;
      }
    }
    if (column < readings.approach.size()) {
      readings.approach[column] *= std::copysign(1, factor);
    }
  });
}

void shiftJoint(std::vector<CaptureSet>& sets, const std::string& joint, double shift) {
  changeReadings(sets, joint, [&](JointReadings& readings, std::size_t column) { readings.measured[column] += shift; });
}

void addOtherJoint(std::vector<CaptureSet>& sets, const std::string& joint, const std::string& other, double factor,
                   double shift) {
  for (CaptureSet& set : sets) {
    const auto own = columnOf(set, joint), from = columnOf(set, other);
    for (Capture& capture : set.captures) {
      for (std::vector<double>* values : {&capture.joints.measured, &capture.joints.commanded}) {
        if (own && from && !values->empty()) {
          (*values)[*own] += factor * (*values)[*from] + shift;
        }
      }
    }
  }
}

void changePoints(std::vector<CaptureSet>& sets, const std::string& tracker,
                  const std::function<void(Eigen::Vector3d&)>& change) {
  for (CaptureSet& set : sets) {
    for (Capture& capture : set.captures) {
      for (PointReading& reading : capture.points) {
        if (reading.tracker == tracker) {
          change(reading.xyz);
        }
      }
    }
  }
}

void changeFrames(std::vector<CaptureSet>& sets, const std::string& tracker,
                  const std::function<void(FrameReading&)>& change) {
  for (CaptureSet& set : sets) {
    for (Capture& capture : set.captures) {
      for (FrameReading& reading : capture.frames) {
        if (reading.tracker == tracker) {
          change(reading);
        }
      }
    }
  }
}

} // namespace naocal

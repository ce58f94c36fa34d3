#include "residuals/Measurements.hpp"

#include "io/InputError.hpp"
#include "residuals/Grouping.hpp"
#include "residuals/Places.hpp"
#include "residuals/RecordedPicture.hpp"

#include <cmath>
#include <fmt/format.h>
#include <map>
#include <set>

namespace naocal {

namespace {

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

Seconds earliest(const CaptureSet& set) {
  Seconds first = Seconds::max();
  for (const Capture& capture : set.captures) {
    first = std::min(first, capture.time);
  }
  return first;
}

/// Motors whose angles every capture tells, under the name of one of their joints.
std::vector<std::size_t> recordedMotors(const std::vector<CaptureSet>& sets, const Robot& robot) {
  std::map<std::size_t, std::size_t> captures; // motor -> in how many
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

} // namespace

std::vector<std::size_t> posesOfPictures(const Measurements& measurements) {
  std::vector<std::size_t> result(measurements.pictures.size());
  for (std::size_t pose = 0; pose < measurements.poses.size(); ++pose) {
    for (const Reading& reading : measurements.poses[pose].readings) {
      for (const std::size_t picture : reading.pictures) {
        result[picture] = pose;
      }
    }
  }
  return result;
}

Measurements measurementsOf(const std::vector<CaptureSet>& sets, const Robot& robot, bool samePlace) {
  refuseOtherRobots(sets);
  const Places places{sets, robot, samePlace};
  Measurements result;
  result.robot = robot;
  result.samePlace = samePlace;
  result.quantities = Quantities{robot.joints.size(), robot.lengths.size(), places.targets().size()};
  result.targets = places.targets();
  result.standings = places.standings();
  result.recorded = recordedMotors(sets, robot);
  for (std::size_t set = 0; set < sets.size(); ++set) {
    const Seconds first = earliest(sets[set]);
    for (std::size_t capture = 0; capture < sets[set].captures.size(); ++capture) {
      result.pictures.push_back(recordedPicture(sets, set, capture, result, places));
      result.pictures.back().instant.time -= first;
      result.pictures.back().instant.set = set;
      for (const Sighting& sighting : result.pictures.back().sightings) {
        result.cornerCount += sighting.ids.size();
      }
    }
  }
  groupReadings(sets, result);
  return result;
}

} // namespace naocal

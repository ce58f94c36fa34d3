#include "math/Angles.hpp"
#include "setups/Catalogue.hpp"
#include "setups/ReadingChanges.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace naocal {

namespace {

constexpr char everyJoint[] = "all";

/// A unit taken for another.
struct UnitMistake {
  std::string is, said;
  double factor = 1; // from what the file gives to what it should
};

std::vector<UnitMistake> mistakesOf(bool isLength) {
  return isLength ? std::vector<UnitMistake>{{"millimetres", "metres", 1e-3}, {"metres", "millimetres", 1e3}}
                  : std::vector<UnitMistake>{{"degrees", "radians", radians(1)}, {"radians", "degrees", degrees(1)}};
}

/// Names of the joints in use that turn.
std::vector<std::string> turningJoints(const Measurements& measurements) {
  std::vector<std::string> names = namesOfJoints(measurements);
  std::erase_if(names, [&](const std::string& name) {
    return measurements.robot.joints[*measurements.robot.jointIndex(name)].isPrismatic;
  });
  return names;
}

Mending scaleAll(const std::string& what, const std::vector<std::string>& joints, double factor) {
  return {what, [joints, factor](Recording& recording) {
            for (const std::string& joint : joints) {
              scaleJoint(recording.sets, joint, factor);
            }
          }};
}

/// Every joint that turns.
std::vector<Mending> mendingsOfAll(const Measurements& measurements) {
  std::vector<Mending> ways;
  for (const UnitMistake& mistake : mistakesOf(false)) {
    ways.push_back(scaleAll(fmt::format("all joints are given in {} where {} are expected", mistake.is, mistake.said),
                            turningJoints(measurements), mistake.factor));
  }
  return ways;
}

/// One joint; or all others, which were taken for its unit.
std::vector<Mending> mendingsOfJoint(const Measurements& measurements, const Joint& joint) {
  std::vector<Mending> ways;
  for (const UnitMistake& mistake : mistakesOf(joint.isPrismatic)) {
    ways.push_back(
        scaleAll(fmt::format("{} is given in {} where {} are expected", joint.name, mistake.is, mistake.said),
                 {joint.name}, mistake.factor));
    std::vector<std::string> others = turningJoints(measurements);
    std::erase(others, joint.name);
    if (!joint.isPrismatic && others.size() > 1) {
      ways.push_back(
          scaleAll(fmt::format("{} alone is given in {}: the other joints are in {}, and were taken for {}, too",
                               joint.name, mistake.said, mistake.is, mistake.said),
                   others, mistake.factor));
    }
  }
  return ways;
}

/// All axes of a tracker, or one.
std::vector<Mending> mendingsOfTracker(const std::string& tracker) {
  std::vector<Mending> ways;
  for (const UnitMistake& mistake : mistakesOf(true)) {
    for (const std::string& axes : {std::string{"xyz"}, std::string{"x"}, std::string{"y"}, std::string{"z"}}) {
      ways.push_back(
          {fmt::format("{}{} is given in {} where {} are expected",
                       axes.size() == 1 ? axes + " of tracker " : "tracker ", tracker, mistake.is, mistake.said),
           [tracker, axes, factor = mistake.factor](Recording& recording) {
             const auto scale = [&](Eigen::Vector3d& point) {
               for (const char axis : axes) {
                 point[axis - 'x'] *= factor;
               }
             };
             changePoints(recording.sets, tracker, scale);
             changeFrames(recording.sets, tracker, [&](FrameReading& reading) { scale(reading.xyz); });
           }});
    }
  }
  return ways;
}

} // namespace

/// One column is in another unit than the rest: degrees for radians, millimetres for metres.
SetUp columnUnit() {
  return {.name = "columnUnit",
          .description = "what the joint or the tracker reads is given in another unit",
          .question = "In which unit is {} given?",
          .listPlaces =
              [](const Measurements& measurements) {
                std::vector<std::string> places = namesOfJoints(measurements);
                if (places.size() > 1) {
                  places.insert(places.begin(), everyJoint);
                }
                const std::vector<std::string> trackers = trackerIds(*measurements.sets);
                places.insert(places.end(), trackers.begin(), trackers.end());
                return places;
              },
          .listMendings =
              [](const Measurements& measurements, const std::string& place) {
                const auto joint = measurements.robot.jointIndex(place);
                return joint                 ? mendingsOfJoint(measurements, measurements.robot.joints[*joint])
                       : place == everyJoint ? mendingsOfAll(measurements)
                                             : mendingsOfTracker(place);
              }};
}

} // namespace naocal

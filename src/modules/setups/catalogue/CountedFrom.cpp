#include "math/Angles.hpp"
#include "math/Statistics.hpp"
#include "setups/Catalogue.hpp"
#include "setups/ReadingChanges.hpp"

#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace naocal {

namespace {

/// What a joint usually reads: the median over all captures [rad].
double medianReading(const Measurements& measurements, const std::string& joint) {
  const auto index = static_cast<Eigen::Index>(*measurements.robot.jointIndex(joint));
  std::vector<double> angles;
  for (const ImageObservation& picture : measurements.pictures) {
    angles.push_back(picture.instant.q[index]);
  }
  return medianOf(std::move(angles));
}

} // namespace

/// An axis is counted from another: its motor sits on the base or its drive runs through the other joint, and the
/// controller reports what the motor does (FANUC's J3, coupled wrists).
///
///   q_true = q_measured ± (q_other + c), c = 0, or so that nothing changes where the other joint usually is
SetUp countedFrom() {
  return {.name = "countedFrom",
          .description = "the joint's angle is counted from another joint, not from its own link",
          .question = "Does the reported angle of the first of {} stay the same when only the second one moves?",
          .listPlaces =
              [](const Measurements& measurements) {
                const std::vector<std::string> names = namesOfJoints(measurements);
                std::vector<std::string> pairs;
                for (const std::string& joint : names) {
                  for (const std::string& other : names) {
                    if (joint != other && areNearOnChain(measurements.robot, joint, other)) {
                      pairs.push_back(joint + ',' + other);
                    }
                  }
                }
                return pairs;
              },
          .listMendings =
              [](const Measurements& measurements, const std::string& pair) {
                constexpr double nothing = radians(5); // an offset of a calibrated robot anyway
                const auto [joint, other] = splitPair(pair);
                const double usual = medianReading(measurements, other);
                std::vector<Mending> ways;
                for (const int sign : {1, -1}) {
                  for (const double from : {0.0, usual}) {
                    if (from != 0 && std::abs(from) < nothing) {
                      continue;
                    }
                    ways.push_back({fmt::format("{} is counted from {}: what it reads is its angle {} that of {}{}",
                                                joint, other, sign > 0 ? "minus" : "plus", other,
                                                from == 0 ? "" : fmt::format(", from {:.0f}° on", degrees(from))),
                                    [=, joint = joint, other = other](Recording& recording) {
                                      addOtherJoint(recording.sets, joint, other, sign, -sign * from);
                                    }});
                  }
                }
                return ways;
              }};
}

} // namespace naocal

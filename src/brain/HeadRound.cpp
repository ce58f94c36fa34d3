#include "brain/CalibrationStep.hpp"
#include "geometry/Angles.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace naocal {

CompensatedAngles lookingFrom(const CompensatedAngles& stand, double yaw, double pitch) {
  CompensatedAngles pose = stand;
  pose[*jointNumber("HeadYaw")] = radians(yaw);
  pose[*jointNumber("HeadPitch")] = radians(pitch);
  return pose;
}

CalibrationRound headRound(const CompensatedAngles& stand, const std::vector<double>& yaws,
                           const std::vector<double>& pitches, int pictures) {
  CalibrationRound round;
  bool backwards = false;
  for (const double pitch : pitches) {
    std::vector<double> row = yaws;
    if (backwards) {
      std::reverse(row.begin(), row.end());
    }
    backwards = !backwards;
    for (const double yaw : row) {
      CalibrationStep step{
          fmt::format("Pose {}", round.size() + 1), "", false, {lookingFrom(stand, yaw, pitch)}, pictures, {}};
      step.taken.pose = fmt::format("H{:02}", round.size());
      step.taken.supportFoot = SupportFoot::both;
      round.push_back(std::move(step));
    }
  }
  round.push_back({"The stand", "", false, {}, 0, {}});
  return round;
}

} // namespace naocal

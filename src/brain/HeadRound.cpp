#include "brain/CalibrationStep.hpp"
#include "math/Angles.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <random>

namespace naocal {

CompensatedAngles lookingFrom(const CompensatedAngles& stand, double yaw, double pitch) {
  CompensatedAngles pose = stand;
  pose[*jointNumber("HeadYaw")] = radians(yaw);
  pose[*jointNumber("HeadPitch")] = radians(pitch);
  return pose;
}

CalibrationRound headRound(const CompensatedAngles& stand, const std::vector<double>& yaws,
                           const std::vector<double>& pitches, double share, const RoundOptions& options) {
  std::vector<std::pair<double, double>> looks;
  for (const double pitch : pitches) {
    for (const double yaw : yaws) {
      looks.emplace_back(share * yaw, share * pitch);
    }
  }
  std::mt19937_64 random{options.seed};
  std::shuffle(looks.begin(), looks.end(), random);
  const std::size_t neck[]{*jointNumber("HeadYaw"), *jointNumber("HeadPitch")};
  CalibrationRound round;
  for (std::size_t look = 0; look < looks.size(); ++look) {
    const std::string id = fmt::format("H{:02}", look);
    for (int repeat = 0; repeat < options.pictures; ++repeat) {
      const CompensatedAngles pose = lookingFrom(stand, looks[look].first, looks[look].second);
      CalibrationStep step{fmt::format("Pose {}", id), "", false, {pose, pose}, 1, {}};
      step.taken.pose = id;
      step.taken.repeat = repeat;
      step.taken.repeatKind = RepeatKind::reapproach;
      step.taken.supportFoot = SupportFoot::both;
      step.taken.joints.approach.assign(jointCount, 0);
      for (const std::size_t joint : neck) {
        const double side = repeat % 2 == 0 ? 1 : -1; // the way that the joint turns at last
        step.taken.joints.approach[joint] = side;
        step.points.front()[joint] -= side * options.approach;
      }
      round.push_back(std::move(step));
    }
  }
  round.push_back({"The stand", "", false, {}, 0, {}});
  return round;
}

} // namespace naocal

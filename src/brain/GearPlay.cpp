#include "brain/GearPlay.hpp"

#include <algorithm>

namespace naocal {

std::vector<std::string> gearGaps(const Measurements& measurements) {
  std::vector<std::string> result;
  if (std::all_of(measurements.standings.begin(), measurements.standings.end(), [](const Standing& standing) {
        return standing.supportFoot == SupportFoot::left || standing.supportFoot == SupportFoot::right;
      })) {
    for (const std::size_t joint : measurements.joints) {
      result.push_back("backlash@" + measurements.robot.joints[joint].name);
      result.push_back("hysteresis@" + measurements.robot.joints[joint].name);
    }
  }
  return result;
}

} // namespace naocal

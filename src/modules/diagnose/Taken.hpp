#pragma once

#include "residuals/Measurements.hpp"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace naocal {

/// Which captures poses and pictures of the measurements are, for people who look for them in the sets.
struct Taken {
  struct Pose {
    std::string set, name;
    std::vector<std::size_t> pictures; // by capture
  };
  struct Picture {
    int capture = 0; // its id
    std::string camera;
  };
  std::vector<Pose> poses;                           // as in the measurements
  std::vector<Picture> pictures;                     // as in the measurements
  std::vector<std::string> joints, boards;           // names, as in the measurements
  std::map<std::string, std::array<int, 2>> cameras; // width and height of their pictures [px]
};

Taken takenIn(const std::vector<CaptureSet>& sets, const Measurements& measurements);

} // namespace naocal

#pragma once

#include <string>
#include <vector>

namespace naocal {

/// What a person gave on the command line, for commands that go on from there.
struct AsAsked {
  std::vector<std::string> sets, with, without;
  std::string model;
  bool samePlace = false, skipBad = false;

  /// "captures/ --with elasticity@LKneePitch,backlash@HeadYaw --model own.json --same-place", with these effects added.
  std::string words(const std::vector<std::string>& added = {}) const;
};

} // namespace naocal

#pragma once

#include "captures/Capture.hpp"
#include "captures/JsonPlace.hpp"

#include <array>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

/// The words of the capture-set file that reader and writer share, in the order of the enums.
namespace naocal {

inline const std::vector<std::string_view> supportFootWords{"left", "right", "both", "none"};
inline const std::vector<std::string_view> repeatKindWords{"rest", "reapproach", "restand"};

inline constexpr Range lengthRange{-1000, 1000, "m"};
inline constexpr Range positiveLengthRange{1e-6, 1000, "m"};
inline constexpr Range angleRange{-2 * std::numbers::pi, 2 * std::numbers::pi, "radians"};

/// A key of a placement; on the floor only those that keep a sheet flat on it are used.
struct PlacementKey {
  const char* key;
  double Placement::*value;
  bool onFloor, isAngle;
};
inline constexpr std::array<PlacementKey, 6> placementKeys{{
    {"x", &Placement::x, true, false},
    {"y", &Placement::y, true, false},
    {"z", &Placement::z, false, false},
    {"roll", &Placement::roll, false, true},
    {"pitch", &Placement::pitch, false, true},
    {"yaw", &Placement::yaw, true, true},
}};

/// A list under `joints`, and what its numbers can be.
struct JointList {
  const char* key;
  std::vector<double> JointReadings::*values;
  Range range;
};
inline constexpr std::array<JointList, 6> jointLists{{
    {"measured", &JointReadings::measured, angleRange},
    {"commanded", &JointReadings::commanded, angleRange},
    {"velocity", &JointReadings::velocity, {-100, 100, "rad/s"}},
    {"approach", &JointReadings::approach, {-1, 1, "(-1, 0 or +1)"}},
    {"temperature", &JointReadings::temperature, {-100, 500, "degrees Celsius"}},
    {"current", &JointReadings::current, {-100, 100, "A"}},
}};

} // namespace naocal

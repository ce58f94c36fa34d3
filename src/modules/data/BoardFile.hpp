#pragma once

#include "data/Board.hpp"
#include "io/JsonReader.hpp"

#include <array>
#include <numbers>
#include <vector>

namespace naocal {

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

/// Where a frame lies on the floor: x, y and yaw, all given.
Placement readFloorPlacement(const JsonCursor& place);

/// An entry of a capture set's `boards`.
Board readBoard(const JsonCursor& place);

/// The ChArUco keys of a board; those not given keep the defaults of CharucoPattern. Refuses what cannot be printed.
CharucoPattern readPattern(const JsonCursor& board);

/// Refuses markers that two boards share: they could not be told apart in a picture.
void requireDistinctMarkers(const std::vector<Board>& boards, const JsonCursor& place);

} // namespace naocal

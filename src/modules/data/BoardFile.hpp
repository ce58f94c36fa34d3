#pragma once

#include "data/Board.hpp"
#include "io/JsonReader.hpp"

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <numbers>
#include <vector>

namespace naocal {

inline constexpr Range lengthRange{-1000, 1000, "m"};
inline constexpr Range positiveLengthRange{1e-6, 1000, "m"};
inline constexpr Range positiveAngleRange{1e-9, 2 * std::numbers::pi, "radians"};
inline constexpr Range angleRange{-2 * std::numbers::pi, 2 * std::numbers::pi, "radians"};

/// A key of a placement; on the floor only the keys that keep a sheet flat are used.
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

/// Reads the placement of a frame on the floor (x, y and yaw, all required), and a 6-D one, whose missing keys are 0.
Placement readFloorPlacement(const JsonCursor& place);
Placement readSparsePlacement(const JsonCursor& place);

/// Reads a placement's 1 sigma: an object, or a number for its position.
Placement readSigma(const JsonCursor& place, bool onFloor);

/// Reads an entry of a capture set's `boards`.
Board readBoard(const JsonCursor& place);

/// An entry of a capture set's `boards`, and a placement; `read`: the entry it was read from, or null, whose unknown
/// keys are preserved.
nlohmann::ordered_json toJson(const Board& board, const nlohmann::json& read);
nlohmann::ordered_json toJson(const Placement& placement, bool onFloor, const nlohmann::json& read);
nlohmann::ordered_json sigmaJson(const Placement& sigma, bool onFloor, const nlohmann::json& read);

/// Refuses markers shared by two boards, since a picture cannot distinguish them.
void requireDistinctMarkers(const std::vector<Board>& boards, const JsonCursor& place);

} // namespace naocal

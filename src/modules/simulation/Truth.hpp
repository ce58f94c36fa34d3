#pragma once

#include "data/Capture.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// A number that a calibration should find.
struct TrueUnknown {
  std::string name; // as in the effect's list of unknowns: "o", "rx", ...
  double value = 0;
  std::string unit;
};

/// An effect at a place, such as jointOffset at LKneePitch.
struct TrueEffect {
  std::string effect, at;
  std::vector<TrueUnknown> unknowns;
};

/// Where boards and stances lay in one world: x, y, yaw.
struct TruePlacements {
  std::map<std::string, Placement> boards;
  std::map<int, Placement> stances;
};

/// A board that lay somewhere else while one picture was taken.
struct DisplacedBoard {
  int capture = 0;
  std::string board;
  double x = 0, y = 0; // by how much, in the board's frame [m]
};

/// A corner that was given a gross error.
struct GrossCorner {
  int capture = 0;
  std::string board;
  int corner = 0;
};

/// What a capture set must not contain: how the simulated robot really was.
struct Truth {
  std::uint64_t seed = 0;
  std::vector<TrueEffect> effects;
  TruePlacements placements; // in the world that a result uses: of the first floor board seen, unless surveyed
  TruePlacements ownWorld;   // in the simulator's
  std::map<std::string, TrueUnknown> noise; // standard deviations and shares by name
  std::vector<DisplacedBoard> displacedBoards;
  std::vector<GrossCorner> grossCorners;

  /// The value of one unknown, when the effect is there.
  std::optional<double> value(std::string_view effect, std::string_view at, std::string_view unknown) const;
};

/// The truth as JSON: a result's `effects` and `placements` with value and unit only, and how the data were spoilt.
std::string formatTruth(const Truth& truth);

/// Beside the set's folder, never inside: OUT/../<name>.truth.json.
std::filesystem::path truthPath(const std::filesystem::path& setFolder);

} // namespace naocal

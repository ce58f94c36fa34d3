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

/// True value of an unknown.
struct TrueUnknown {
  std::string name; // as in the effect's unknowns: "o", "rx", ...
  double value = 0;
  std::string unit;
};

/// An effect at a place, such as jointOffset at LKneePitch.
struct TrueEffect {
  std::string effect, at;
  std::vector<TrueUnknown> unknowns;
};

/// Placements of boards and stances in one world frame: x, y, yaw.
struct TruePlacements {
  std::map<std::string, Placement> boards;
  std::map<int, Placement> stances;
};

/// A board that was displaced during one image.
struct DisplacedBoard {
  int capture = 0;
  std::string board;
  double x = 0, y = 0; // displacement in the board's frame [m]
};

/// A corner with a gross error.
struct GrossCorner {
  int capture = 0;
  std::string board;
  int corner = 0;
};

/// Where everything is in a scene of any robot, in the world of a result or on its link.
struct TrueScene {
  std::map<std::string, std::map<std::string, Placement>> placements; // by list ("boards", "trackers", ...) and id
  std::map<std::string, Eigen::Vector3d> markers;                     // pointInLink [m]
  std::map<std::string, Eigen::Vector3d> places;                      // in the world of a result [m]
};

/// Ground truth of a simulated set; never part of the capture set.
struct Truth {
  std::uint64_t seed = 0;
  std::vector<TrueEffect> effects;
  TruePlacements placements;                // in the world of a result: first floor board seen, unless surveyed
  TruePlacements ownWorld;                  // in the simulator's world
  std::optional<TrueScene> scene;           // of any robot, instead of both
  std::map<std::string, TrueUnknown> noise; // standard deviations and shares, by name
  std::vector<DisplacedBoard> displacedBoards;
  std::vector<GrossCorner> grossCorners;

  /// The value of an unknown; absent if the robot lacks the effect.
  std::optional<double> value(std::string_view effect, std::string_view at, std::string_view unknown) const;
};

/// The truth as JSON: `effects` and `placements` as in a result, with value and unit only, and the injected errors.
std::string formatTruth(const Truth& truth);

/// Path beside the set's folder, never inside: OUT/../<name>.truth.json.
std::filesystem::path truthPath(const std::filesystem::path& setFolder);

} // namespace naocal

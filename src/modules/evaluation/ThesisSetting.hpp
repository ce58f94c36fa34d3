#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace naocal {

/// Observed targets: a grid of floor points with known correspondence, or four ChArUco boards on the floor.
enum class ThesisFeature { grid, boards };

/// Noisy quantities: corners, reported angles, or both.
enum class ThesisNoise { none, pixel, joint, both };

/// Interpretations of the thesis's joint noise, whose unit is not stated: sigma 0.007 rad or 0.007 degrees before
/// 12-bit rounding (4.1); the real encoder, whose readings alternate between two steps at rest; the same with gears
/// that stick slightly differently in every pose, behind the encoder.
enum class AngleNoise { radians, degrees, encoder, stiction };

/// Selection of poses: ours, or the thesis's chain (ThesisCriterion.hpp) among the same candidates.
enum class PoseChoice { ours, chain };

/// plain: Levenberg-Marquardt on equally weighted pixels, from zero. randomStarts: the best of it from random starts.
/// ours: corners weighted with the readings' noise marginalised, offsets with a prior. For comparison on some sets:
/// numeric (plain with central differences instead of analytic derivatives), dlib (find_min_global), swarm (particle
/// swarm).
enum class ThesisSolver { plain, randomStarts, ours, numeric, dlib, swarm };
constexpr std::array allSolvers{ThesisSolver::ours,    ThesisSolver::plain, ThesisSolver::randomStarts,
                                ThesisSolver::numeric, ThesisSolver::dlib,  ThesisSolver::swarm};

/// Everything that determines an error set, except its number.
struct ThesisSetting {
  ThesisFeature feature = ThesisFeature::boards;
  std::size_t poses = 3;
  ThesisNoise noise = ThesisNoise::none;
  AngleNoise jointNoise = AngleNoise::radians; // interpretation of joint noise, if present
  std::size_t samples = 1;                     // per pose, with new readings each
  bool largeErrors = false;                    // offsets of 1 to 6.5 degrees instead of 0 to 6.5, either sign
  // Beyond the thesis:
  bool bothLegs = false;      // adds the mirror images of all poses on the other leg: 13 offsets
  bool unknownPlaces = false; // camera mounts and board placements are unknown as well
  PoseChoice choice = PoseChoice::ours;

  auto key() const {
    return std::tuple{feature, poses, noise, jointNoise, samples, largeErrors, bothLegs, unknownPlaces, choice};
  }
  bool operator==(const ThesisSetting& other) const { return key() == other.key(); }
  bool operator<(const ThesisSetting& other) const { return key() < other.key(); }

  bool pixelNoise() const { return noise == ThesisNoise::pixel || noise == ThesisNoise::both; }
  bool angleNoise() const { return noise == ThesisNoise::joint || noise == ThesisNoise::both; }
  /// "boards, 3 poses, both (0.007rad), 3 samples"
  std::string name() const;
};

/// A figure of the thesis's tables 5.5 to 5.8. With joint noise, one figure gives three cells: one per interpretation.
struct ThesisCell {
  std::string table; // "5.8", or "beyond"
  ThesisSetting setting;
  ThesisSolver solver = ThesisSolver::plain; // the thesis's solver in this table
  std::optional<double> published;           // success rate [1]; absent: not in the thesis
};

/// Cells beyond the thesis, with the real encoder's noise and 0.3 px corner noise: both legs at once, unknown mounts
/// and places, stiction, and poses of the thesis's chain.
std::vector<ThesisCell> furtherCells();

/// All cells by table, those beyond the thesis last. Table 5.5 does not state its feature and number of poses; its 13 %
/// of failures match the grid with 3 poses in table 5.6.
std::vector<ThesisCell> thesisCells();

/// Whether the setting belongs to table 5.5, on which other solvers are compared.
bool isInTable55(const ThesisSetting& setting);

/// The settings of all cells, each once, with their solvers; plain and ours for all.
std::vector<std::pair<ThesisSetting, std::vector<ThesisSolver>>> thesisSettings();

/// Names used in evaluation files.
std::string_view toString(ThesisFeature feature);
std::string_view toString(ThesisNoise noise);
std::string_view toString(AngleNoise noise);
std::string_view toString(ThesisSolver solver);
std::string_view toString(PoseChoice choice);

} // namespace naocal

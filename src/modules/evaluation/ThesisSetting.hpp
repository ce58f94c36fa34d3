#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace naocal {

/// What the cameras look at: a grid of floor points seen by correspondence, or four ChArUco boards on the floor.
enum class ThesisFeature { grid, boards };

/// What is noisy: corners, the angles that the robot reports, or both.
enum class ThesisNoise { none, pixel, joint, both };

/// Readings of the thesis's joint noise, whose unit it does not state: sigma 0.007 rad or 0.007 degrees before the
/// 12-bit encoder rounds (4.1); the real encoder's, whose readings flip between two steps at rest; and with it gears
/// that stick a little differently in every pose, behind the encoder.
enum class AngleNoise { radians, degrees, encoder, stiction };

/// Who chose the poses: we, or the thesis's chain (Interaction.hpp) among the same candidates.
enum class PoseChoice { ours, chain };

/// Plain Levenberg-Marquardt on pixels, all alike, from zero; the best of it from random starts; and ours: corners
/// weighed with the readings' noise marginalised, offsets with their prior. For comparison on some sets: plain with
/// central differences instead of our derivatives, dlib's find_min_global, and a particle swarm.
enum class ThesisSolver { plain, randomStarts, ours, numeric, dlib, swarm };
constexpr std::array allSolvers{ThesisSolver::ours,    ThesisSolver::plain, ThesisSolver::randomStarts,
                                ThesisSolver::numeric, ThesisSolver::dlib,  ThesisSolver::swarm};

/// Everything that decides about an error set but its number.
struct ThesisSetting {
  ThesisFeature feature = ThesisFeature::boards;
  std::size_t poses = 3;
  ThesisNoise noise = ThesisNoise::none;
  AngleNoise jointNoise = AngleNoise::radians; // where the noise is of joints
  std::size_t samples = 1;                     // per pose, each with readings of its own
  bool largeErrors = false;                    // of 1 to 6.5 degrees instead of 0 to 6.5, either sign
  // Beyond the thesis:
  bool bothLegs = false;      // the mirror images of all poses on the other leg too, 13 offsets at once
  bool unknownPlaces = false; // the cameras' mounts and the boards' places are to be found along with the offsets
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

/// A figure of the thesis's tables 5.5 to 5.8. Joint noise makes three cells of one figure: one per reading.
struct ThesisCell {
  std::string table; // "5.8", or "beyond"
  ThesisSetting setting;
  ThesisSolver solver = ThesisSolver::plain; // the thesis's in this table
  std::optional<double> published;           // success [1]; absent: the thesis did not ask
};

/// What the thesis left open, with the real encoder's noise and 0.3 px of the corners: both legs at once, unknown
/// mounts and places, stiction, and poses of the thesis's chain.
std::vector<ThesisCell> furtherCells();

/// All cells, by table, those beyond it last. Table 5.5 is printed without its feature and poses: its 13 % of failures
/// are the grid's 3 poses of table 5.6.
std::vector<ThesisCell> thesisCells();

/// Whether it is one of table 5.5, on which other solvers are compared.
bool isInTable55(const ThesisSetting& setting);

/// The settings of all cells, each once, and which solvers they are for: ours and plain for all.
std::vector<std::pair<ThesisSetting, std::vector<ThesisSolver>>> thesisSettings();

/// As in evaluation files.
std::string_view toString(ThesisFeature feature);
std::string_view toString(ThesisNoise noise);
std::string_view toString(AngleNoise noise);
std::string_view toString(ThesisSolver solver);
std::string_view toString(PoseChoice choice);

} // namespace naocal

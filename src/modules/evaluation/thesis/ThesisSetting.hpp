#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace naocal {

/// Observed targets: a grid of floor points with known correspondence, or four ChArUco boards on the floor. As the
/// thesis's own program has them (ThesisProgram.hpp): its floor grid, and its boards, which it moves into one at the
/// support foot, with four or eight coinciding points each. Or those of a file.
enum class ThesisFeature { grid, boards, programGrid, fourBoards, eightBoards, file };

/// Noisy quantities: corners, reported angles, or both.
enum class ThesisNoise { none, pixel, joint, both };

/// Interpretations of the thesis's joint noise, whose unit is not stated: sigma 0.007 rad or 0.007 degrees before
/// 12-bit rounding (4.1); the real encoder, whose readings alternate between two steps at rest; the same with gears
/// that stick slightly differently in every pose, behind the encoder; the thesis's own program: sigma 0.007 degrees
/// between reading and true angle, anew in every picture, without rounding.
enum class AngleNoise { radians, degrees, encoder, stiction, unrounded };

/// Selection of poses: ours, the thesis's chain (ThesisCriterion.hpp) among the same candidates, those of the thesis's
/// own program, or those of a file.
enum class PoseChoice { ours, chain, program, file };

/// Error sets: uniform within +-6.5 degrees, the distribution of the thesis's own file, or those of a file.
enum class ErrorSets { uniform, program, file };

/// plain: Levenberg-Marquardt on equally weighted pixels, from zero. randomStarts: the best of it from random starts.
/// ours: corners weighted with the readings' noise marginalised, offsets with a prior. For comparison on some sets:
/// numeric (plain with central differences instead of analytic derivatives), dlib (find_min_global), swarm (particle
/// swarm). program, programStarts: the thesis's two solvers in its program's numeric form (ProgramSolver.hpp).
enum class ThesisSolver { plain, randomStarts, ours, numeric, dlib, swarm, program, programStarts };
constexpr std::array allSolvers{ThesisSolver::ours,    ThesisSolver::plain,        ThesisSolver::randomStarts,
                                ThesisSolver::numeric, ThesisSolver::dlib,         ThesisSolver::swarm,
                                ThesisSolver::program, ThesisSolver::programStarts};

/// Everything that determines an error set, except its number.
struct ThesisSetting {
  ThesisFeature feature = ThesisFeature::boards;
  std::size_t poses = 3;
  ThesisNoise noise = ThesisNoise::none;
  AngleNoise jointNoise = AngleNoise::radians; // interpretation of joint noise, if present
  std::size_t samples = 1;                     // per pose, with new readings each; corner noise: ThesisExperiment
  bool largeErrors = false;                    // offsets of 1 to 6.5 degrees instead of 0 to 6.5, either sign
  // Beyond the thesis:
  bool bothLegs = false;      // adds the mirror images of all poses on the other leg: 13 offsets
  bool unknownPlaces = false; // camera mounts and board placements are unknown as well
  PoseChoice choice = PoseChoice::ours;
  ErrorSets errorSets = ErrorSets::uniform; // `largeErrors` applies to the uniform ones only

  auto key() const {
    return std::tuple{feature,     poses,    noise,         jointNoise, samples,
                      largeErrors, bothLegs, unknownPlaces, choice,     errorSets};
  }
  bool operator==(const ThesisSetting& other) const { return key() == other.key(); }
  bool operator<(const ThesisSetting& other) const { return key() < other.key(); }

  bool pixelNoise() const { return noise == ThesisNoise::pixel || noise == ThesisNoise::both; }
  bool angleNoise() const { return noise == ThesisNoise::joint || noise == ThesisNoise::both; }
  /// As the thesis's own program measures: one camera, horizon test, held-out poses.
  bool likeProgram() const { return jointNoise == AngleNoise::unrounded; }
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

/// Cells of the tables 5.6 to 5.8 as the thesis's own program made them ("5.6-program"): its "3, 5, 8 poses" are 4, 6
/// and 9. "5.6-log", "5.7-log": further rows, 5.7 with eight boards instead of four, in its logs of 2019-06-02 only;
/// table 5.7 has 0 % with 3 poses, because those runs ended at their start (logs of 2019-05-27).
std::vector<ThesisCell> programCells();

/// Settings of a run with files: each kind of noise with `poses` poses.
std::vector<ThesisSetting> fileSettings(const ThesisSetting& common);

/// Whether the setting belongs to table 5.5, on which other solvers are compared.
bool isInTable55(const ThesisSetting& setting);

/// Settings with their solvers, each once.
using SolvedSettings = std::vector<std::pair<ThesisSetting, std::vector<ThesisSolver>>>;

/// The settings of all cells; plain and ours for all.
SolvedSettings thesisSettings();

/// Names used in evaluation files.
std::string_view toString(ThesisFeature feature);
std::string_view toString(ThesisNoise noise);
std::string_view toString(AngleNoise noise);
std::string_view toString(ThesisSolver solver);
std::string_view toString(PoseChoice choice);
std::string_view toString(ErrorSets errors);

} // namespace naocal

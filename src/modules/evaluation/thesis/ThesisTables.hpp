#pragma once

#include "evaluation/thesis/ThesisTrial.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// Tolerances of the offset error for counting success: 0.1, 0.2, ... 2.0 degrees.
constexpr std::size_t toleranceCount = 20;
constexpr double toleranceDegrees(std::size_t index) {
  return 0.1 * static_cast<double>(index + 1);
}

/// Index of the tolerance for counting statuses: 0.2 degrees, as in the author's published set-up.
constexpr std::size_t statusTolerance = 1;

/// Bins of an offset error: 0.1 degrees wide from -3 to 3; the outermost bins include larger values.
constexpr std::size_t errorBins = 60;
constexpr double firstErrorDegrees = -3, errorBinDegrees = 0.1;

/// Bins of a true offset: 0.5 degrees wide from -7 to 7.
constexpr std::size_t offsetBins = 28;
constexpr double firstOffsetDegrees = -7, offsetBinDegrees = 0.5;

/// A solver's results in a setting. Counts only, so that parts can be added.
struct ThesisTally {
  std::size_t sets = 0, limitDraws = 0;
  std::array<std::size_t, 4> status{};               // by ThesisStatus
  std::array<std::size_t, toleranceCount> success{}; // successful sets, by tolerance
  std::array<std::size_t, toleranceCount> limit{}; // successful draws of an efficient estimator's errors, by tolerance
  std::vector<std::array<std::size_t, errorBins>> errors;   // per joint: solved sets, by offset error
  std::vector<std::array<std::size_t, offsetBins>> offsets; // per joint: sets, by true offset
  double seconds = 0;                                       // solver time
  // Of settings like the program's:
  // Noiseless failures restarted with exact derivatives; of them successful; of them ended by the number of
  // evaluations.
  std::size_t restarts = 0, reached = 0, ranOut = 0;
  ResidualMap residuals;

  void add(const Eigen::VectorXd& offsets, const ThesisSolution& answer, const std::vector<double>& limitErrors);
  void add(const ThesisTally& other);
  double successAt(std::size_t tolerance) const; // [1]
  double limitAt(std::size_t tolerance) const;   // [1]
};

/// One solver on the error sets of one setting.
struct ThesisOutcome {
  ThesisSetting setting;
  ThesisSolver solver = ThesisSolver::plain;
  ThesisTally tally;
  std::vector<std::array<Eigen::Vector2d, 4>> fieldsOfView = {}; // of the poses, if known [m]
};

/// The thesis's evaluation, or parts of it: sets part, part + parts, part + 2 parts, ... of every setting.
struct ThesisEvaluation {
  std::uint64_t seed = 1;
  std::size_t sets = 10'000; // per setting, over all parts
  double pixel = 0.3;        // corner noise, if present, 1 sigma [px]
  std::size_t parts = 1;
  std::vector<std::size_t> done = {};   // parts included
  std::vector<std::string> joints = {}; // joints of the offsets
  std::vector<ThesisOutcome> outcomes;
  std::map<std::string, std::string> inputs = {}; // SHA-256 of the files given, by option
  std::size_t others = 0; // sets of table 5.5 for each comparison solver, ten times as many for `numeric`

  /// Number of sets for a solver.
  std::size_t setsOf(ThesisSolver solver) const;

  /// nullptr if not evaluated.
  const ThesisTally* tally(const ThesisSetting& setting, ThesisSolver solver) const;
};

/// EVALUATION.json: every cell of the tables with the thesis's figure, once per solver.
nlohmann::json evaluationJson(const ThesisEvaluation& evaluation);

/// Reads an evaluation file. Throws InputError with file, place, expectation and finding.
ThesisEvaluation readEvaluation(const std::filesystem::path& file);

/// Merges parts. Throws InputError if they belong to different evaluations or overlap.
ThesisEvaluation mergeEvaluations(const std::vector<ThesisEvaluation>& parts);

/// The cells of the tables, and those of settings that no table has ("files").
std::vector<ThesisCell> cellsOf(const ThesisEvaluation& evaluation);

/// Noiseless failures of the thesis's program and how many of them a search with exact derivatives, started from the
/// wrong answer, leads to the truth, over all cells. `ranOut`: those whose search ended by its number of evaluations.
struct RestartedFailures {
  std::size_t failures = 0, reached = 0, ranOut = 0;
};
RestartedFailures restartedFailures(const ThesisEvaluation& evaluation);

/// Agreement of the thesis's solvers, run here, with its figures.
struct NoiseInterpretation {
  AngleNoise jointNoise = AngleNoise::radians;
  std::size_t tolerance = 0; // index
  double difference = 0;     // root mean square over the cells [1]
  std::size_t cells = 0;
};

/// The interpretation of the joint noise and the tolerance that reproduce the thesis's figures best, over the cells
/// with joint noise in which the thesis had any success. Absent if none was evaluated.
std::optional<NoiseInterpretation> bestInterpretation(const ThesisEvaluation& evaluation);

} // namespace naocal

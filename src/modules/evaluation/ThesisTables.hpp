#pragma once

#include "evaluation/ThesisTrial.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// Tolerances of an offset's error at which success is counted: 0.1, 0.2, ... 2.0 degrees.
constexpr std::size_t toleranceCount = 20;
constexpr double toleranceDegrees(std::size_t index) {
  return 0.1 * static_cast<double>(index + 1);
}

/// The tolerance at which statuses are counted: 0.2 degrees, that of the author's published set-up.
constexpr std::size_t statusTolerance = 1;

/// Bins of an offset's error: 0.1 degrees wide from -3 to 3, the outermost hold what is beyond.
constexpr std::size_t errorBins = 60;
constexpr double firstErrorDegrees = -3, errorBinDegrees = 0.1;

/// Bins of an offset before it is found: 0.5 degrees wide from -7 to 7.
constexpr std::size_t offsetBins = 28;
constexpr double firstOffsetDegrees = -7, offsetBinDegrees = 0.5;

/// How often a solver succeeded in a setting. Only counts, so that parts add up to the whole.
struct ThesisTally {
  std::size_t sets = 0, limitDraws = 0;
  std::array<std::size_t, 4> status{};                      // by ThesisStatus
  std::array<std::size_t, toleranceCount> success{};        // sets
  std::array<std::size_t, toleranceCount> limit{};          // draws of an efficient estimator's errors
  std::vector<std::array<std::size_t, errorBins>> errors;   // per joint: sets that were solved, by the offset's error
  std::vector<std::array<std::size_t, offsetBins>> offsets; // per joint: sets, by the offset itself
  double seconds = 0;                                       // in the solver

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
};

/// The thesis's evaluation or parts of it: of every setting the sets part, part + parts, part + 2 parts, ...
struct ThesisEvaluation {
  std::uint64_t seed = 1;
  std::size_t sets = 10'000; // per setting, of all parts together
  double pixel = 0.3;        // corner noise where there is any [px]
  std::size_t parts = 1;
  std::vector<std::size_t> done = {};   // which parts
  std::vector<std::string> joints = {}; // whose offsets are found
  std::vector<ThesisOutcome> outcomes;
  std::size_t others = 0; // sets of table 5.5 for each solver that is only compared, ten times as many for `numeric`

  /// How many of the sets a solver gets.
  std::size_t setsOf(ThesisSolver solver) const;

  /// nullptr: not evaluated.
  const ThesisTally* tally(const ThesisSetting& setting, ThesisSolver solver) const;
};

/// EVALUATION.json: every cell of the tables with the figure of the thesis, once per solver.
nlohmann::json evaluationJson(const ThesisEvaluation& evaluation);

/// Reads an evaluation file. Throws InputError with file, place, what was expected and found.
ThesisEvaluation readEvaluation(const std::filesystem::path& file);

/// The parts together. Throws InputError where they are not of one evaluation, or overlap.
ThesisEvaluation mergeEvaluations(const std::vector<ThesisEvaluation>& parts);

/// How the thesis's figures are met by its own solvers.
struct NoiseInterpretation {
  AngleNoise jointNoise = AngleNoise::radians;
  std::size_t tolerance = 0; // index
  double difference = 0;     // root mean square over those cells [1]
  std::size_t cells = 0;
};

/// Of all readings of the joint noise and all tolerances the pair that meets the thesis's figures best, over the cells
/// with joint noise, which alone depend on the reading, but for those in which the thesis never succeeded. Absent: none
/// was evaluated.
std::optional<NoiseInterpretation> bestInterpretation(const ThesisEvaluation& evaluation);

} // namespace naocal

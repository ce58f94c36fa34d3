#pragma once

#include "evaluate/ThesisTally.hpp"

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>

namespace naocal {

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
ThesisEvaluation merged(const std::vector<ThesisEvaluation>& parts);

/// How the thesis's figures are met by its own solvers.
struct ThesisReading {
  AngleNoise jointNoise = AngleNoise::radians;
  std::size_t tolerance = 0; // index
  double difference = 0;     // root mean square over those cells [1]
  std::size_t cells = 0;
};

/// Of all readings of the joint noise and all tolerances the pair that meets the thesis's figures best, over the cells
/// with joint noise, which alone depend on the reading, but for those in which the thesis never succeeded. Absent: none
/// was evaluated.
std::optional<ThesisReading> bestReading(const ThesisEvaluation& evaluation);

} // namespace naocal

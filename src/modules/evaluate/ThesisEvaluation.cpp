#include "evaluate/ThesisEvaluation.hpp"

#include "io/InputError.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace naocal {

std::size_t ThesisEvaluation::setsOf(ThesisSolver solver) const {
  switch (solver) {
  case ThesisSolver::numeric:
    return std::min(sets, 10 * others);
  case ThesisSolver::dlib:
  case ThesisSolver::swarm:
    return std::min(sets, others);
  case ThesisSolver::plain:
  case ThesisSolver::randomStarts:
  case ThesisSolver::ours:
    break;
  }
  return sets;
}

const ThesisTally* ThesisEvaluation::tally(const ThesisSetting& setting, ThesisSolver solver) const {
  const auto found = std::find_if(outcomes.begin(), outcomes.end(), [&](const ThesisOutcome& outcome) {
    return outcome.setting == setting && outcome.solver == solver;
  });
  return found == outcomes.end() ? nullptr : &found->tally;
}

ThesisEvaluation merged(const std::vector<ThesisEvaluation>& parts) {
  ThesisEvaluation result = parts.front();
  for (auto part = parts.begin() + 1; part != parts.end(); ++part) {
    if (part->seed != result.seed || part->sets != result.sets || part->pixel != result.pixel ||
        part->parts != result.parts) {
      throw InputError{fmt::format("expected parts of one evaluation (seed {}, {} sets, {} px, {} parts), found one of "
                                   "seed {}, {} sets, {} px, {} parts",
                                   result.seed, result.sets, result.pixel, result.parts, part->seed, part->sets,
                                   part->pixel, part->parts)};
    }
    result.joints =
        result.joints.size() < part->joints.size() ? part->joints : result.joints; // one may have stopped early
    for (const std::size_t done : part->done) {
      if (std::find(result.done.begin(), result.done.end(), done) != result.done.end()) {
        throw InputError{fmt::format("expected every part once, found {}/{} twice", done, result.parts)};
      }
      result.done.push_back(done);
    }
    for (const ThesisOutcome& outcome : part->outcomes) {
      const auto same = std::find_if(result.outcomes.begin(), result.outcomes.end(), [&](const ThesisOutcome& other) {
        return outcome.setting == other.setting && outcome.solver == other.solver;
      });
      if (same != result.outcomes.end()) {
        same->tally.add(outcome.tally);
      } else {
        result.outcomes.push_back(outcome);
      }
    }
  }
  std::sort(result.done.begin(), result.done.end());
  return result;
}

std::optional<ThesisReading> bestReading(const ThesisEvaluation& evaluation) {
  std::optional<ThesisReading> best;
  for (const AngleNoise reading : {AngleNoise::radians, AngleNoise::degrees, AngleNoise::encoder}) {
    for (std::size_t tolerance = 0; tolerance < toleranceCount; ++tolerance) {
      double squares = 0;
      std::size_t cells = 0;
      for (const ThesisCell& cell : thesisCells()) {
        const ThesisTally* tally = evaluation.tally(cell.setting, cell.solver);
        if (tally && cell.setting.angleNoise() && cell.setting.jointNoise == reading &&
            cell.published.value_or(0) > 0) {
          squares += std::pow(tally->successAt(tolerance) - *cell.published, 2);
          ++cells;
        }
      }
      const double difference = std::sqrt(squares / static_cast<double>(std::max<std::size_t>(cells, 1)));
      if (cells > 0 && (!best || difference < best->difference)) {
        best = {reading, tolerance, difference, cells};
      }
    }
  }
  return best;
}

} // namespace naocal

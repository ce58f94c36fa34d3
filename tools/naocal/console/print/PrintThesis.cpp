#include "console/print/PrintThesis.hpp"

#include "console/print/PrintText.hpp"
#include "evaluation/Proportion.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <limits>
#include <map>
#include <vector>

namespace naocal {

namespace {

constexpr double withinPoints = 0.02;  // tolerance to the limit [1]
constexpr double nearPublished = 0.04; // to a figure of the thesis [1]

/// Success rates [%]: ours, the thesis's solver run here, the limit, and the published figure.
std::string figures(const ThesisEvaluation& evaluation, const ThesisCell& cell, std::size_t tolerance) {
  const ThesisTally* ours = evaluation.tally(cell.setting, ThesisSolver::ours);
  const ThesisTally* theirs = evaluation.tally(cell.setting, cell.solver);
  if (!ours || !theirs) {
    return fmt::format("{:>26}", "not done");
  }
  return fmt::format("{:5.1f}  {:5.1f}  {:5.1f}  {:>5}", 100 * ours->successAt(tolerance),
                     100 * theirs->successAt(tolerance), 100 * ours->limitAt(tolerance),
                     cell.published ? fmt::format("{:.1f}", 100 * *cell.published) : "-");
}

std::string rowName(const ThesisCell& cell) {
  const ThesisSetting& setting = cell.setting;
  if (cell.table == "5.5") {
    return fmt::format("{}, {}", setting.largeErrors ? "1..6.5 deg" : "6.5 deg", toString(cell.solver));
  }
  if (cell.table == "beyond") {
    return setting.bothLegs                             ? "both legs at once, 13 offsets"
           : setting.unknownPlaces                      ? "mounts and places unknown"
           : setting.choice == PoseChoice::chain        ? "poses of the thesis's chain"
           : setting.jointNoise == AngleNoise::stiction ? "gears stick, 0.05 deg"
                                                        : "our poses";
  }
  return fmt::format("{}{}{}", toString(setting.noise),
                     setting.angleNoise() ? fmt::format(" {}", toString(setting.jointNoise)) : "",
                     setting.samples > 1 ? fmt::format(", {} samples", setting.samples) : "");
}

const char* title(const std::string& table) {
  return table == "5.5"   ? "table 5.5: floor grid, no noise"
         : table == "5.6" ? "table 5.6: floor grid, Levenberg-Marquardt"
         : table == "5.7" ? "table 5.7: boards, Levenberg-Marquardt"
         : table == "5.8" ? "table 5.8: boards, random starts"
         : table == "5.6-program"
             ? "table 5.6 as the thesis's program made it: its poses, errors and floor grid, Levenberg-Marquardt"
         : table == "5.6-log"     ? "the same with three samples of the joints' noise, as its logs have it"
         : table == "5.7-program" ? "table 5.7 as its program made it: four boards moved into one at the foot"
         : table == "5.7-log"     ? "the same with eight boards in one, as its logs have it"
         : table == "5.8-program" ? "table 5.8 as its program made it: eight boards in one, random starts"
         : table == "files"       ? "with the given files"
                            : "beyond the thesis: boards, pixel noise and the real encoder's, Levenberg-Marquardt";
}

std::string trimmed(const std::string& line) {
  return line.substr(0, line.find_last_not_of(' ') + 1);
}

/// Prints one table: a row per noise, four figures per number of poses.
void printTable(const ThesisEvaluation& evaluation, const std::string& table, std::size_t tolerance) {
  const std::vector<ThesisCell> all = cellsOf(evaluation);
  if (std::none_of(all.begin(), all.end(), [&](const ThesisCell& cell) {
        return cell.table == table && evaluation.tally(cell.setting, ThesisSolver::ours);
      })) {
    return;
  }
  std::vector<std::string> rows;
  std::map<std::string, std::map<std::size_t, std::string>> cells;
  std::map<std::size_t, bool> poses;
  for (const ThesisCell& cell : all) {
    if (cell.table == table) {
      const std::string row = rowName(cell);
      if (!cells.contains(row)) {
        rows.push_back(row);
      }
      cells[row][cell.setting.poses] = figures(evaluation, cell, tolerance);
      poses[cell.setting.poses] = true;
    }
  }
  std::string counts = fmt::format("{:30}", ""), heads = counts;
  for (const auto& [count, used] : poses) {
    counts += fmt::format("  {:<26}", fmt::format("{} poses", count));
    heads += " ours     LM  limit thesis  ";
  }
  printText("\n{}\n{}\n{}\n", title(table), trimmed(counts), trimmed(heads));
  for (const std::string& row : rows) {
    std::string line = fmt::format("{:30}", row);
    for (const auto& [count, text] : cells[row]) {
      line += fmt::format("{:<28}", text);
    }
    printText("{}\n", trimmed(line));
  }
}

/// Prints other solvers' results on the sets of table 5.5, if evaluated.
void printOthers(const ThesisEvaluation& evaluation, std::size_t tolerance) {
  const auto perSolve = [](const ThesisTally& tally) { return 1e3 * tally.seconds / static_cast<double>(tally.sets); };
  for (const auto& [setting, solvers] : thesisSettings()) {
    if (!isInTable55(setting) || !evaluation.tally(setting, ThesisSolver::numeric)) {
      continue;
    }
    printText("\nother solvers, {}:\n", setting.name());
    for (const ThesisSolver solver : allSolvers) {
      if (const ThesisTally* tally = evaluation.tally(setting, solver)) {
        printText("  {:<17} {:>6} sets {:>7.1f} % {:>10.3f} ms each\n", toString(solver), tally->sets,
                  100 * tally->successAt(tolerance), perSolve(*tally));
      }
    }
  }
}

/// Comparison of our solver with plain Levenberg-Marquardt on the same sets, and with the limit.
struct Standing {
  std::size_t settings = 0, atLeastPlain = 0, nearLimit = 0, noiseless = 0, perfect = 0;
  double behindPlain = 0, aboveLimit = 1; // worst [1]
  std::string worst;                      // setting farthest below the limit
  std::size_t leastSets = std::numeric_limits<std::size_t>::max();
};

Standing standing(const ThesisEvaluation& evaluation, std::size_t tolerance) {
  Standing result;
  for (const auto& [setting, solvers] : thesisSettings()) {
    const ThesisTally* ours = evaluation.tally(setting, ThesisSolver::ours);
    const ThesisTally* plain = evaluation.tally(setting, ThesisSolver::plain);
    if (!ours || !plain) {
      continue;
    }
    ++result.settings;
    result.leastSets = std::min(result.leastSets, ours->sets);
    result.atLeastPlain += ours->success[tolerance] >= plain->success[tolerance];
    result.behindPlain = std::max(result.behindPlain, plain->successAt(tolerance) - ours->successAt(tolerance));
    const double above = ours->successAt(tolerance) - ours->limitAt(tolerance);
    result.nearLimit += above >= -withinPoints;
    if (above < result.aboveLimit) {
      result.aboveLimit = above;
      result.worst = setting.name();
    }
    if (setting.noise == ThesisNoise::none) {
      ++result.noiseless;
      result.perfect += ours->success[tolerance] == ours->sets;
    }
  }
  return result;
}

/// Prints how near the thesis's solvers, in its program's numeric form, come to its figures, and why they fail.
void printProgram(const ThesisEvaluation& evaluation, std::size_t tolerance) {
  std::size_t cells = 0, near = 0;
  std::vector<std::string> missed;
  for (const ThesisCell& cell : programCells()) {
    const ThesisTally* tally = evaluation.tally(cell.setting, cell.solver);
    if (!tally || tally->sets == 0 || !cell.published) {
      continue;
    }
    ++cells;
    if (std::abs(tally->successAt(tolerance) - *cell.published) <= nearPublished) {
      ++near;
      continue;
    }
    const Proportion measured = proportion(tally->success[tolerance], tally->sets);
    missed.push_back(fmt::format("  {:12} {} poses, {}: {:.1f} % ({:.1f} to {:.1f} %), published {:.1f} %", cell.table,
                                 cell.setting.poses, rowName(cell), 100 * measured.share, 100 * measured.low,
                                 100 * measured.high, 100 * *cell.published));
  }
  if (cells > 0) {
    printText(
        "\nThe thesis's solvers in its program's numeric form lie within {:.0f} points of its figures in {} of {} "
        "cells{}\n",
        100 * nearPublished, near, cells, missed.empty() ? "." : "; elsewhere:");
    for (const std::string& line : missed) {
      printText("{}\n", line);
    }
  }
  if (const auto [failures, reached, ranOut] = restartedFailures(evaluation); failures > 0) {
    const Proportion share = proportion(reached, failures);
    printText("Its local minima: of {} noiseless failures {} reach the true offsets ({:.1f} %, 95 % interval {:.1f} to "
              "{:.1f} %) when Levenberg-Marquardt with exact derivatives starts from the wrong answer. {} of the "
              "failures had run out of evaluations, which derivatives by differences use up; rounding in single "
              "precision had "
              "stopped the others.\n",
              failures, reached, 100 * share.share, 100 * share.low, 100 * share.high, ranOut);
  }
}

void printSummary(const ThesisEvaluation& evaluation, std::size_t tolerance) {
  const Standing all = standing(evaluation, tolerance);
  if (all.settings == 0) {
    return;
  }
  // [percentage points], 1 sigma for a share of 0.5
  const double uncertainty = 50 / std::sqrt(static_cast<double>(all.leastSets));
  printText(
      "\nOf {} settings ours succeeds at least as often as plain Levenberg-Marquardt on the same sets in {}{}; in {} "
      "it is at most {:.0f} points below the Cramer-Rao limit (worst: {:+.1f} points, {}; shares are uncertain by up "
      "to {:.1f}). Without noise it never fails in {} of {}.\n",
      all.settings, all.atLeastPlain,
      all.behindPlain > 0 ? fmt::format(" (elsewhere at most {:.2f} points less)", 100 * all.behindPlain) : "",
      all.nearLimit, 100 * withinPoints, 100 * all.aboveLimit, all.worst, uncertainty, all.perfect, all.noiseless);
  if (const auto best = bestInterpretation(evaluation); best && all.settings == thesisSettings().size()) {
    printText("The thesis's own solvers, run here, come nearest to its figures with joint noise {} and a tolerance of "
              "{:.1f} deg: {:.0f} points apart (root mean square over the {} cells with joint noise in which the "
              "thesis had any success).\n",
              toString(best->jointNoise), toleranceDegrees(best->tolerance), 100 * best->difference, best->cells);
  }
}

} // namespace

void printThesisTables(const ThesisEvaluation& evaluation, double degrees) {
  const auto tolerance = static_cast<std::size_t>(std::lround(degrees / toleranceDegrees(0))) - 1;
  printText("success in % with all 8 offsets within {:.1f} deg: ours, the thesis's solver with our derivatives (LM), "
            "Cramer-Rao limit, thesis\n",
            toleranceDegrees(tolerance));
  for (const char* table : {"5.5", "5.6", "5.6-program", "5.6-log", "5.7", "5.7-program", "5.7-log", "5.8",
                            "5.8-program", "beyond", "files"}) {
    printTable(evaluation, table, tolerance);
  }
  printOthers(evaluation, tolerance);
  printProgram(evaluation, tolerance);
  printSummary(evaluation, tolerance);
}

} // namespace naocal

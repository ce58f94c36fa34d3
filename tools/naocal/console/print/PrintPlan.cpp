#include "console/print/PrintPlan.hpp"

#include "console/print/PrintText.hpp"
#include "io/Units.hpp"
#include "math/Angles.hpp"
#include "poses/candidates/BoardPlacement.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

namespace {

/// How a robot's candidates are described that passed tests of balance and sight.
struct SieveWords {
  const char *reachable, *stable, *seeing;
};
constexpr SieveWords standingNao{"within reach and joint limits", "stable, also with joint errors",
                                 "with a board in view"},
    standingRobot{"within joint limits", "balanced, and above the floor", "in which enough is measured"},
    mountedRobot{"within joint limits", "standing on their base", "in which enough is measured"};

void printSieve(const PassCounts& sieve, const SieveWords& words) {
  printText("\n{:>10} attitudes drawn\n{:>10} {}\n{:>10} without self-collision\n{:>10} {}\n{:>10} {}\n\n",
            sieve.generated, sieve.reachable, words.reachable, sieve.collisionFree, sieve.stable, words.stable,
            sieve.seeing, words.seeing);
}

/// Standard errors of an unknown.
struct SigmaRow {
  std::string name;
  std::string unit; // SI
  double asDrawn = 0;
  std::optional<double> withErrors;
  std::optional<double> known;
};

std::string barOf(double share) {
  std::string bar;
  for (int i = 0; i < static_cast<int>(std::lround(20 * share)); ++i) {
    bar += "█";
  }
  return bar;
}

/// A table of standard errors, with bars that compare those of the same unit.
void printSigmaRows(const std::vector<SigmaRow>& rows) {
  std::size_t width = 14;
  std::map<std::string, double> worst;
  for (const SigmaRow& row : rows) {
    width = std::max(width, row.name.size());
    worst[row.unit] = std::max(worst[row.unit], row.asDrawn);
  }
  const auto has = [&](auto SigmaRow::*column) {
    return std::any_of(rows.begin(), rows.end(), [&](const SigmaRow& row) { return row.*column; });
  };
  const bool hasErrors = has(&SigmaRow::withErrors), hasKnown = has(&SigmaRow::known);
  printText("  {:<{}} {:>11}{}{}\n", "", width, "as drawn", hasErrors ? "    with errors" : "",
            hasKnown ? "    cameras and boards known" : "");
  for (const SigmaRow& row : rows) {
    const auto [unit, factor] = displayUnit(row.unit);
    const std::string errors =
                          hasErrors ? fmt::format("    {:>7.3f} {}", factor * row.withErrors.value_or(0), unit) : "",
                      known = hasKnown ? fmt::format("    {:>5.3f} {}", factor * row.known.value_or(0), unit) : "";
    printText("  {:<{}} {:>9.3f} {}{}{}  {}\n", row.name, width, factor * row.asDrawn, unit, errors, known,
              barOf(row.asDrawn / worst[row.unit]));
  }
}

void printSigmas(const PosePlan& plan) {
  printText("standard error of each offset after these {} poses (one picture per camera and pose):\n",
            plan.poses.size());
  std::vector<SigmaRow> rows;
  for (const auto& [joint, sigma] : plan.sigma) {
    rows.push_back({joint, "rad", sigma, plan.sigmaOfRobots.at(joint), plan.sigmaKnown.at(joint)});
  }
  printSigmaRows(rows);
}

std::vector<SigmaRow> toRows(const std::vector<PlannedSigma>& sigmas) {
  std::vector<SigmaRow> rows;
  for (const PlannedSigma& each : sigmas) {
    rows.push_back({each.name, each.unit, each.sigma, std::nullopt, each.known});
  }
  return rows;
}

/// What the poses do not tell; joints that move nothing measured share a line.
void printUntold(const CapturePlan& plan) {
  std::map<std::string, std::vector<std::string>> byReason;
  for (const UntoldUnknown& untold : plan.untold) {
    byReason[untold.why].push_back(untold.name);
  }
  for (const auto& [why, names] : byReason) {
    printText("not told: {} ({})\n", fmt::join(names, ", "), why);
  }
}

void printMisfit(const PosePlan& plan) {
  if (plan.misfit) {
    printText("\nwith {} where a robot has {}, or the other way round, the fit to these poses is worse by chi2 of at "
              "least {:.1f} (both as large as they plausibly may be; 10 is beyond doubt)\n",
              plan.options.effects[0], plan.options.effects[1], *plan.misfit);
  }
}

/// Prints the floor from above, robot facing up; a character is 6 cm wide and 12 cm high.
void printFloor(const PosePlan& plan) {
  constexpr int rows = 14, columns = 45, ahead = 11; // rows in front of the robot
  std::vector<std::string> floor(rows, std::string(columns, '.'));
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      for (const Board& board : plan.boards) {
        if (insideDepth(boardOutline(board), {0.12 * (ahead - row), 0.06 * (columns / 2 - column)}) >= 0) {
          floor[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = board.id.front();
        }
      }
    }
  }
  floor[ahead][columns / 2] = '^';
  printText(
      "\nwhere to lay the boards (top view, robot faces up; ^ is the support foot, with both feet the left one; a "
      "character is 6 cm wide, 12 cm high):\n");
  for (const std::string& row : floor) {
    printText("  {}\n", row);
  }
  for (std::size_t i = 0; i < plan.boards.size(); ++i) {
    const Board& board = plan.boards[i];
    const Placement& place = *board.placement;
    printText("  {}: its corner {:5.2f} m ahead, {:5.2f} m to the {}, turned by {:4.0f}°; tolerance {:.0f} cm, "
              "{:.0f}°\n",
              board.id, place.x, std::abs(place.y), place.y >= 0 ? "left " : "right", degrees(place.yaw),
              100 * plan.tolerances[i].shift, degrees(plan.tolerances[i].turn));
  }
  printText(
      "  (tolerance of each board, the others in place: beyond it the worst offset's standard error grows by more than "
      "10 %, or a pose sees no board; not checked beyond 30 cm / 45°)\n");
}

void printWay(const PosePlan& plan) {
  double seconds = plan.options.secondsPerPose * static_cast<double>(plan.poses.size());
  std::size_t ways = 0, round = 0, straight = 0;
  for (std::size_t i = plan.kept + 1; i < plan.ways.size(); ++i) {
    const bool otherFoot = plan.poses[i].pose.supportFoot != plan.poses[i - 1].pose.supportFoot;
    ways += otherFoot ? 0 : 1;
    if (plan.ways[i]) {
      seconds += plan.ways[i]->seconds;
      ++(plan.ways[i]->via.empty() ? straight : round);
    }
  }
  printText("\nplaying time {:.0f} s, including {:.0f} s of rest per pose; {} of {} transitions are direct", seconds,
            plan.options.secondsPerPose, straight, ways);
  if (round > 0) {
    printText(", {} go by other postures (\"via\")", round);
  }
  if (const std::size_t missing = ways - straight - round; missing > 0) {
    printText(", {} are not safe: stand on both feet in between", missing);
  }
  printText("\n");
}

/// Prints the selection of each criterion among the same candidates, boards where they were given.
void printComparison(const PosePlan& plan) {
  if (plan.comparison.empty()) {
    return;
  }
  printText("what the criteria select among the same {} candidates, boards where they were given, nothing refined:\n"
            "  {:<12} {:>5}  {:>12}  {:>9}  {:>24}  {}{}\n",
            plan.sieve.seeing, "criterion", "poses", "worst offset", "mean", "worst, places known",
            "pairs of joints that look alike (cost)", plan.misfit ? "  effects told apart (chi2)" : "");
  for (const CriterionResult& each : plan.comparison) {
    printText("  {:<12} {:>5}  {:>10.3f} °  {:>7.3f} °  {:>22.3f} °  {:>30} ({:.3f}){}\n", toString(each.criterion),
              each.poses, degrees(each.worst), degrees(each.mean), degrees(each.worstKnown), each.interaction.count,
              each.interaction.cost, each.misfit ? fmt::format("  {:>25.1f}", *each.misfit) : "");
  }
  printText("\n");
}

} // namespace

void printPlan(const PosePlan& plan) {
  printSieve(plan.sieve, standingNao);
  printComparison(plan);
  printSigmas(plan);
  printMisfit(plan);
  printFloor(plan);
  printWay(plan);
}

void printPlan(const CapturePlan& plan) {
  printSieve(plan.sieve, plan.isOnSole ? standingRobot : mountedRobot);
  printText("standard error of each offset after these {} poses (one sample each):\n", plan.poses.size());
  printSigmaRows(toRows(plan.offsets));
  if (!plan.mounts.empty()) {
    printText("of cameras on the robot:\n");
    printSigmaRows(toRows(plan.mounts));
  }
  if (!plan.effects.empty()) {
    printText("of the effects asked for:\n");
    printSigmaRows(toRows(plan.effects));
  }
  printUntold(plan);
  printText("ways between the poses are not tested: move slowly, and watch the robot\n");
}

} // namespace naocal

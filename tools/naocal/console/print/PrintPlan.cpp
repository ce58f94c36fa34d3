#include "console/print/PrintPlan.hpp"

#include "console/print/PrintText.hpp"
#include "math/Angles.hpp"
#include "poses/candidates/BoardPlacement.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>

namespace naocal {

namespace {

void printSieve(const PassCounts& sieve) {
  printText("\n{:>10} attitudes drawn\n{:>10} within reach and joint limits\n{:>10} without self-collision\n"
            "{:>10} stable, also with joint errors\n{:>10} with a board in view\n\n",
            sieve.generated, sieve.reachable, sieve.collisionFree, sieve.stable, sieve.seeing);
}

void printSigmas(const PosePlan& plan) {
  double worst = 0;
  for (const auto& [joint, sigma] : plan.sigma) {
    worst = std::max(worst, sigma);
  }
  printText("standard error of each offset after these {} poses (one picture per camera and pose):\n",
            plan.poses.size());
  printText("  {:<14} {:>11}    {:>9}    {}\n", "", "as drawn", "with errors", "cameras and boards known");
  for (const auto& [joint, sigma] : plan.sigma) {
    std::string bar;
    for (int i = 0; i < static_cast<int>(std::lround(20 * sigma / worst)); ++i) {
      bar += "█";
    }
    printText("  {:<14} {:>9.3f} °    {:>7.3f} °    {:>5.3f} °  {}\n", joint, degrees(sigma),
              degrees(plan.sigmaOfRobots.at(joint)), degrees(plan.sigmaKnown.at(joint)), bar);
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
  printSieve(plan.sieve);
  printComparison(plan);
  printSigmas(plan);
  printMisfit(plan);
  printFloor(plan);
  printWay(plan);
}

} // namespace naocal

#include "console/print/PrintHistory.hpp"

#include "console/print/PrintText.hpp"
#include "math/Angles.hpp"
#include "runs/RunWording.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace naocal {

namespace {

constexpr std::size_t axisWidth = 32; // of an error bar's axis [characters]

/// A line per moment, runs before falls.
using Timeline = std::multimap<RunTime, std::string>;

void print(const Timeline& lines) {
  for (const auto& [time, line] : lines) {
    printText("  {}  {}\n", formatMinute(time), line);
  }
}

void addFalls(const RobotHistory& history, Timeline& lines) {
  for (const RunTime fall : history.falls) {
    lines.emplace(fall, "fall");
  }
}

/// Where the run's captures are, as seen from this computer.
std::string describePlace(const Run& run) {
  const std::string place = run.kind == applyKind && !run.result.empty() ? run.result : run.captures;
  std::error_code ignored;
  return place.empty() || std::filesystem::exists(place, ignored) ? place : place + " (not here)";
}

/// Lowest and highest end of the error bars [rad].
std::pair<double, double> rangeOf(const std::vector<HistoricOffset>& series) {
  double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
  for (const HistoricOffset& one : series) {
    low = std::min(low, one.offset.value - 2 * one.offset.sigma);
    high = std::max(high, one.offset.value + 2 * one.offset.sigma);
  }
  return {low, high};
}

/// The estimate with two standard errors on an axis: "      |-o-|       ".
std::string drawBar(const RunOffset& offset, const std::pair<double, double>& range) {
  const auto place = [&](double value) {
    const double share = (value - range.first) / std::max(range.second - range.first, 1e-12);
    return static_cast<std::size_t>(std::lround(std::clamp(share, 0.0, 1.0) * double(axisWidth - 1)));
  };
  std::string bar(axisWidth, ' ');
  const std::size_t begin = place(offset.value - 2 * offset.sigma), end = place(offset.value + 2 * offset.sigma);
  std::fill(bar.begin() + static_cast<std::ptrdiff_t>(begin), bar.begin() + static_cast<std::ptrdiff_t>(end) + 1, '-');
  bar[place(offset.value)] = 'o';
  return bar;
}

std::string describeChance(double chance) {
  return chance < 0.001 ? "< 0.001" : fmt::format("{:.3f}", chance);
}

std::string describeOffset(const RobotHistory& history, const HistoricOffset& one,
                           const std::pair<double, double>& range) {
  const HistoricRun& run = history.runs[one.run];
  const std::string line = fmt::format("{:>8.3f}° ± {:.3f}°  |{}|", degrees(one.offset.value),
                                       degrees(one.offset.sigma), drawBar(one.offset, range));
  if (!one.change) {
    return line + (run.isCompared() ? "" : fmt::format("  {}: not compared", describeOutcome(run)));
  }
  return fmt::format("{}  {:>18}  {:>7}{}", line, formatChange(*one.change), describeChance(one.change->familyChance),
                     one.change->isJump ? "  JUMP" : "");
}

} // namespace

void printHistory(const RobotHistory& history) {
  printText("{}\n", describeHistory(history));
  Timeline lines;
  bool areUsed = false; // corners that were used for the calibration
  for (const HistoricRun& one : history.runs) {
    const Run& run = one.run;
    areUsed |= run.errorBefore && !run.heldOut;
    lines.emplace(run.time, fmt::format("{:<10} {:>19} {:>8}  {:<17} {}", run.kind, describeErrors(run),
                                        run.offsets.size(), describeOutcome(one), describePlace(run)));
  }
  addFalls(history, lines);
  printText("  {:<16}  {:<10} {:>19} {:>8}  {:<17} {}\n", "date (UTC)", "kind", "error", "offsets", "its numbers",
            "captures or result");
  print(lines);
  if (areUsed) {
    printText("  *: on the captures that the result was made from; without it, on captures that were not used\n");
  }
}

void printJointHistory(const RobotHistory& history, const std::string& joint) {
  printText("{}\n", describeJoint(history, joint));
  const std::vector<HistoricOffset>& series = history.joints.at(joint);
  const auto range = rangeOf(series);
  Timeline lines;
  for (const HistoricOffset& one : series) {
    lines.emplace(history.runs[one.run].run.time, describeOffset(history, one, range));
  }
  addFalls(history, lines);
  printText("  {:<16}  {:>19}  {:<34}  {:>18}  {:>7}\n", "date (UTC)", "offset",
            fmt::format("{:.2f}° to {:.2f}°, ± 2 sigma", degrees(range.first), degrees(range.second)), "change",
            "chance");
  print(lines);
}

} // namespace naocal

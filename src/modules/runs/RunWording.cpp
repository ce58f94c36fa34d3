#include "runs/RunWording.hpp"

#include "io/InputError.hpp"
#include "io/Units.hpp"
#include "math/Angles.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace naocal {

namespace {

std::string plural(std::size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

/// The runs' days: "on 2026-02-14" or "from 2026-02-14 to 2026-05-01".
std::string describeSpan(const RobotHistory& history) {
  const std::string first = formatDay(history.runs.front().run.time), last = formatDay(history.runs.back().run.time);
  return first == last ? "on " + first : fmt::format("from {} to {}", first, last);
}

/// "between 2026-03-01 and 2026-03-08"; with the time of day if both are of one day.
std::string describeGap(const RobotHistory& history, const HistoricOffset& offset) {
  const RunTime begin = history.runs[*offset.since].run.time, end = history.runs[offset.run].run.time;
  const bool isOneDay = formatDay(begin) == formatDay(end);
  return fmt::format("between {} and {}{}", isOneDay ? formatMinute(begin) : formatDay(begin),
                     isOneDay ? formatMinute(end) : formatDay(end), offset.afterFall ? ", with a fall in between" : "");
}

bool isJump(const HistoricOffset& offset) {
  return offset.change && offset.change->isJump;
}

/// Number of changes that were tested, over all joints.
std::size_t countChanges(const RobotHistory& history) {
  std::size_t count = 0;
  for (const auto& [joint, series] : history.joints) {
    count += static_cast<std::size_t>(
        std::count_if(series.begin(), series.end(), [](const HistoricOffset& one) { return one.change.has_value(); }));
  }
  return count;
}

} // namespace

std::string describeRobot(const RunRobot& robot) {
  return robot.head.empty() || robot.head == robot.body ? robot.body
                                                        : fmt::format("{} with head {}", robot.body, robot.head);
}

std::string describeOutcome(const HistoricRun& run) {
  if (!run.run.outcome) {
    return run.run.kind;
  }
  switch (*run.run.outcome) {
  case RunOutcome::kept:
    return run.undone ? "kept, then undone" : "kept";
  case RunOutcome::unneeded:
    return "not needed";
  case RunOutcome::takenBack:
    break;
  }
  return "taken back";
}

std::string describeErrors(const Run& run) {
  if (!run.errorBefore || !run.errorAfter) {
    return "-";
  }
  const auto number = [](double error) { return fmt::format("{:.{}f}", error, error < 10 ? 2 : 1); };
  return fmt::format("{} -> {} px{}", number(*run.errorBefore), number(*run.errorAfter), run.heldOut ? "" : "*");
}

std::string formatChange(const OffsetChange& change) {
  const double sigma = degrees(change.sigma);
  const int decimals = decimalsFor(sigma);
  return fmt::format("{:+.{}f}° ± {:.{}f}°", degrees(change.value), decimals, sigma, decimals);
}

std::vector<std::string> describeJumps(const RobotHistory& history) {
  std::vector<std::pair<std::size_t, std::string>> jumps; // by run
  for (const auto& [joint, series] : history.joints) {
    for (const HistoricOffset& one : series) {
      if (isJump(one)) {
        jumps.emplace_back(one.run,
                           fmt::format("{} by {} {}", joint, formatChange(*one.change), describeGap(history, one)));
      }
    }
  }
  std::stable_sort(jumps.begin(), jumps.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> clauses;
  for (auto& [run, clause] : jumps) {
    clauses.push_back(std::move(clause));
  }
  return clauses;
}

std::string describeHistory(const RobotHistory& history) {
  const std::string name = describeRobot(history.robot);
  if (history.runs.empty()) {
    return fmt::format("{}: no calibration yet, {}.", name, plural(history.falls.size(), "fall"));
  }
  const std::string head =
      fmt::format("{}: {} {}{}", name, plural(history.runs.size(), "run"), describeSpan(history),
                  history.falls.empty() ? "" : fmt::format(", {}", plural(history.falls.size(), "fall")));
  const std::vector<std::string> jumps = describeJumps(history);
  if (jumps.empty()) {
    return head + (countChanges(history) == 0 ? ". No joint has two calibrations that can be compared yet."
                                              : ". No joint's offset changed by more than its uncertainty explains.");
  }
  constexpr std::size_t shown = 4;
  const std::vector<std::string> first{jumps.begin(), jumps.begin() + std::min(shown, jumps.size())};
  return fmt::format("{}. {} jumped: {}{}.", head,
                     jumps.size() == 1 ? "One offset" : fmt::format("{} offsets", jumps.size()), fmt::join(first, "; "),
                     jumps.size() > shown ? fmt::format("; and {} more", jumps.size() - shown) : "");
}

std::string describeJoint(const RobotHistory& history, const std::string& joint) {
  const auto found = history.joints.find(joint);
  if (found == history.joints.end()) {
    std::vector<std::string> known;
    for (const auto& [name, series] : history.joints) {
      known.push_back(name);
    }
    throw InputError{
        known.empty()
            ? fmt::format("--joint: expected a joint that the runs of {} have, but they have none", history.robot.body)
            : fmt::format("--joint: expected a joint that the runs of {} have, found \"{}\"; near it are {}",
                          history.robot.body, joint, fmt::join(closestNames(joint, known), ", "))};
  }
  const std::vector<HistoricOffset>& series = found->second;
  const std::string head = fmt::format("{} of {}: {}", joint, history.robot.body, plural(series.size(), "calibration"));
  std::vector<std::string> jumps;
  bool isTested = false;
  for (const HistoricOffset& one : series) {
    isTested |= one.change.has_value();
    if (isJump(one)) {
      jumps.push_back(fmt::format("by {} {}", formatChange(*one.change), describeGap(history, one)));
    }
  }
  if (!isTested) {
    return head + ". A jump needs two that were kept or not needed.";
  }
  return jumps.empty() ? head + ". Its offset never changed by more than its uncertainty explains."
                       : fmt::format("{}. It jumped {}.", head, fmt::join(jumps, "; "));
}

std::string describeRule() {
  return fmt::format(
      "A jump is a change that would turn up in at most {:.0f} % of pairs of calibrations of a robot whose "
      "joints did not move, in any of its joints.",
      100 * jumpFalseAlarms);
}

} // namespace naocal

#include "runs/RobotHistory.hpp"

#include "io/InputError.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace naocal {

namespace {

/// Marks the runs that an undo names, and drops those undos.
void applyUndos(RobotHistory& history) {
  std::map<std::string, HistoricRun*> kept; // by id
  for (HistoricRun& one : history.runs) {
    if (one.run.outcome == RunOutcome::kept) {
      kept[one.run.id] = &one;
    }
  }
  for (const HistoricRun& one : history.runs) {
    if (const auto found = kept.find(one.run.undoes); one.run.kind == undoKind && found != kept.end()) {
      found->second->undone = one.run.time;
    }
  }
  std::erase_if(history.runs,
                [&](const HistoricRun& one) { return one.run.kind == undoKind && kept.contains(one.run.undoes); });
}

void takeFalls(RobotHistory& history) {
  for (const HistoricRun& one : history.runs) {
    if (one.run.kind == fallKind) {
      history.falls.push_back(one.run.time);
    }
  }
  std::erase_if(history.runs, [](const HistoricRun& one) { return one.run.kind == fallKind; });
}

/// Compares a run's joints with the latest compared run before it, all joints together.
void compareRun(std::size_t index, RobotHistory& history) {
  std::vector<OffsetChange> changes;
  for (const auto& [joint, offset] : history.runs[index].run.offsets) {
    std::vector<HistoricOffset>& series = history.joints[joint];
    const auto before = std::find_if(series.rbegin(), series.rend(), [&](const HistoricOffset& earlier) {
      return history.runs[earlier.run].isCompared();
    });
    HistoricOffset next{index, offset};
    if (before != series.rend() && history.runs[index].isCompared()) {
      const RunTime begin = history.runs[before->run].run.time, end = history.runs[index].run.time;
      next.since = before->run;
      next.change = compareOffsets(before->offset, offset);
      next.afterFall = std::any_of(history.falls.begin(), history.falls.end(),
                                   [&](RunTime fall) { return begin <= fall && fall <= end; });
    }
    series.push_back(next);
    if (next.change) {
      changes.push_back(*next.change);
    }
  }
  findJumps(changes);
  std::size_t place = 0;
  for (const auto& [joint, offset] : history.runs[index].run.offsets) {
    HistoricOffset& last = history.joints[joint].back();
    if (last.change) {
      last.change = changes[place++];
    }
  }
}

} // namespace

bool HistoricRun::isCompared() const {
  return run.outcome && *run.outcome != RunOutcome::takenBack && !undone;
}

std::vector<RobotHistory> makeHistories(const std::vector<Run>& runs) {
  std::vector<Run> sorted = runs;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Run& a, const Run& b) { return a.time < b.time; });
  std::vector<RobotHistory> histories;
  for (Run& run : sorted) {
    auto history = std::find_if(histories.begin(), histories.end(),
                                [&](const RobotHistory& one) { return isSameRobot(one.robot, run.robot); });
    if (history == histories.end()) {
      history = histories.insert(histories.end(), RobotHistory{run.robot});
    }
    if (!run.robot.bodyId.empty() || history->robot.bodyId.empty()) {
      history->robot = run.robot;
    }
    history->runs.push_back({std::move(run)});
  }
  for (RobotHistory& history : histories) {
    takeFalls(history);
    applyUndos(history);
    for (std::size_t i = 0; i < history.runs.size(); ++i) {
      compareRun(i, history);
    }
  }
  return histories;
}

const RobotHistory& findRobot(const std::vector<RobotHistory>& histories, const std::string& name) {
  std::vector<std::string> known;
  for (const RobotHistory& history : histories) {
    const RunRobot& robot = history.robot;
    if (!name.empty() && (name == robot.body || name == robot.head || name == robot.bodyId || name == robot.headId)) {
      return history;
    }
    known.push_back(robot.body);
  }
  throw InputError{known.empty() ? fmt::format("expected a robot whose runs are recorded, found no runs at all; "
                                               "calibrate \"{}\", or name the folder of its runs with --state",
                                               name)
                                 : fmt::format("expected a robot whose runs are recorded, found \"{}\"; near it are {}",
                                               name, fmt::join(closestNames(name, known), ", "))};
}

std::optional<std::string> findRunOf(const std::map<std::string, double>& set, const RunRobot& robot,
                                     const std::vector<Run>& runs) {
  constexpr double rounding = 1e-9; // [rad]
  for (const RobotHistory& history : makeHistories(runs)) {
    if (!isSameRobot(history.robot, robot)) {
      continue;
    }
    for (auto one = history.runs.rbegin(); one != history.runs.rend(); ++one) {
      const bool isIt = one->run.outcome == RunOutcome::kept && !one->undone && one->run.set.size() == set.size() &&
                        std::equal(set.begin(), set.end(), one->run.set.begin(), [](const auto& a, const auto& b) {
                          return a.first == b.first && std::abs(a.second - b.second) <= rounding;
                        });
      if (isIt) {
        return one->run.id;
      }
    }
  }
  return std::nullopt;
}

} // namespace naocal

#pragma once

#include "runs/Run.hpp"

#include <map>
#include <string>

namespace naocal {

/// A kept calibration of robot "nao21" with one joint, on a day of 2026.
inline Run exampleRun(const std::string& time, const std::map<std::string, RunOffset>& offsets) {
  Run run{.time = parseTime(time).value(),
          .robot = {"nao21", "nao21", "P007", "P008"},
          .kind = "left leg",
          .by = "naocal-robot",
          .outcome = RunOutcome::kept,
          .errorBefore = 16.25,
          .errorAfter = 2.5,
          .heldOut = true,
          .captures = "/recordings/one",
          .result = "/recordings/one/first/result.json",
          .sha256 = "ab",
          .offsets = offsets};
  for (const auto& [joint, offset] : offsets) {
    run.set[joint] = offset.value;
  }
  run.id = makeRunId(run);
  return run;
}

/// An event of the same robot.
inline Run exampleEvent(const std::string& time, std::string_view kind, const std::string& undoes = "") {
  Run run = exampleRun(time, {});
  run.kind = kind;
  run.outcome.reset();
  run.undoes = undoes;
  run.id = makeRunId(run);
  return run;
}

} // namespace naocal

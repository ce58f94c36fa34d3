#include "runs/Run.hpp"

#include "runs/RunFile.hpp"

#include <catch2/catch.hpp>

namespace naocal {

TEST_CASE("a time is read in every form that people type, and nothing else is") {
  // Proves that all forms give the same moment, formatting gives it back, and impossible dates and other text are
  // absent.
  const RunTime time = parseTime("2026-02-14T10:05:00Z").value();
  CHECK(formatTime(time) == "2026-02-14T10:05:00Z");
  CHECK(formatMinute(time) == "2026-02-14 10:05");
  CHECK(formatDay(time) == "2026-02-14");
  for (const char* same : {"2026-02-14 10:05:00", "2026-02-14 10:05", "2026-02-14T10:05Z"}) {
    CHECK(parseTime(same) == time);
  }
  CHECK(parseTime("2026-02-14") == parseTime("2026-02-14 00:00"));
  CHECK(parseTime("2026-02-28 23:59:59").value() + std::chrono::seconds{1} == parseTime("2026-03-01"));
  for (const char* wrong : {"", "now", "2026-02-30", "2026-13-01", "2026-02-14 24:00", "2026-02-14 10:60",
                            "2026-02-14x", "2026-02-14 10", "14.02.2026", "1969-12-31", " 2026-02-14"}) {
    INFO(wrong);
    CHECK_FALSE(parseTime(wrong));
  }
}

TEST_CASE("a run's id is the name of a file, whatever the robot is called") {
  // Proves it for names that would lead out of the folder or hide the file; ids that could are refused.
  for (const char* name : {"nao21", "../../etc/passwd", "a robot", "näö", ".hidden", "x\ny",
                           "a name much longer than any that a team has given to one of its robots so far"}) {
    Run run{.time = parseTime("2026-02-14T10:05:00Z").value(), .robot = {name, "", "", ""}, .kind = "left leg"};
    INFO(makeRunId(run));
    CHECK(isRunId(makeRunId(run)));
  }
  CHECK(makeRunId({.time = parseTime("2026-02-14T10:05:00Z").value(), .robot = {"nao21"}, .kind = "left leg"}) ==
        "2026-02-14_10-05-00_nao21_left-leg");
  for (const char* wrong : {"", ".", "..", ".a", "a/b", "a b", "a\\b", "ä"}) {
    CHECK_FALSE(isRunId(wrong));
  }
  CHECK_FALSE(isRunId(std::string(121, 'a')));
}

} // namespace naocal

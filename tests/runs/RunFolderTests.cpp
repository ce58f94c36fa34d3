#include "runs/RunFolder.hpp"

#include "ExampleRuns.hpp"
#include "TemporaryFolder.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "runs/RunFile.hpp"

#include <catch2/catch.hpp>
#include <functional>
#include <nlohmann/json.hpp>

using Catch::Contains;

namespace naocal {

using nlohmann::json;

namespace {

json goodRun() {
  return runJson(exampleRun("2026-02-14T10:05:00Z", {{"LKneePitch", {0.03, 0.001, 12}}}));
}

} // namespace

TEST_CASE("a recorded run is read as it was") {
  // Proves that every member survives writing and reading, also those that are absent.
  const TemporaryFolder folder;
  const RunFolder runs{runsIn(folder.path())};
  CHECK(runs.read().runs.empty());
  const Run kept = runs.add(exampleRun("2026-02-14T10:05:00Z", {{"LKneePitch", {0.03, 0.001, 12}}}));
  const Run undo = runs.add(exampleEvent("2026-02-14T11:00:00Z", undoKind, kept.id));
  const RecordedRuns read = runs.read();
  CHECK(read.broken.empty());
  REQUIRE(read.runs.size() == 2);
  CHECK(read.runs[0].id == kept.id);
  CHECK(runJson(read.runs[0]) == runJson(kept));
  CHECK(runJson(read.runs[1]) == runJson(undo));
  CHECK(read.runs[0].offsets.at("LKneePitch").freedom == 12);
  CHECK_FALSE(read.runs[1].outcome);
  CHECK(read.runs[1].undoes == kept.id);
}

TEST_CASE("nothing that is recorded replaces another run") {
  // Proves it for two runs of the same second, and for a copy of a run that is there already.
  const TemporaryFolder folder;
  const RunFolder runs{folder.path()};
  const Run first = runs.add(exampleRun("2026-02-14T10:05:00Z", {})), second = runs.add(first);
  CHECK(first.id != second.id);
  Run changed = first;
  changed.kind = "head";
  CHECK_FALSE(runs.addCopy(changed));
  changed.id = "other";
  CHECK(runs.addCopy(changed));
  const RecordedRuns read = runs.read();
  REQUIRE(read.runs.size() == 3);
  CHECK(read.runs[0].kind == "left leg");
  changed.id = "../other";
  CHECK_THROWS_AS(runs.addCopy(changed), InputError);
}

TEST_CASE("broken runs are told one by one, and the others are read") {
  // Proves that each break is refused by a sentence that names the file, and does not hide a good run.
  const TemporaryFolder folder;
  const RunFolder runs{folder.path()};
  runs.add(exampleRun("2026-02-14T10:05:00Z", {}));
  const std::vector<std::function<void(json&)>> breaks{
      [](json& run) { run["format"] = "naocal-result"; },
      [](json& run) { run["version"] = 2; },
      [](json& run) { run["time"] = "yesterday"; },
      [](json& run) { run["robot"] = "nao21"; },
      [](json& run) { run.erase("kind"); },
      [](json& run) { run.erase("outcome"); },
      [](json& run) { run["outcome"] = "lost"; },
      [](json& run) { run["errorBefore"] = -1; },
      [](json& run) { run["offsets"]["LKneePitch"]["sigma"] = 0; },
      [](json& run) { run["offsets"]["LKneePitch"]["offset"] = 100; },
      [](json& run) { run["offsets"]["LKneePitch"]["degreesOfFreedom"] = 1; },
      [](json& run) { run["offsets"] = json::array({1}); },
      [](json& run) {
        run["set"] = {{"LKneePitch", "much"}};
      },
  };
  for (std::size_t i = 0; i < breaks.size(); ++i) {
    json run = goodRun();
    breaks[i](run);
    writeAtomically(folder.path() / ("broken-" + std::to_string(i) + ".json"), run.dump());
  }
  writeAtomically(folder.path() / "text.json", "no JSON");
  writeAtomically(folder.path() / "large.json", std::string(std::size_t{2} << 20, ' '));
  writeAtomically(folder.path() / "a name.json", goodRun().dump());
  writeAtomically(folder.path() / ".part.json", "being written");
  writeAtomically(folder.path() / "notes.txt", "a note");
  const RecordedRuns read = runs.read();
  CHECK(read.runs.size() == 1);
  CHECK(read.broken.size() == breaks.size() + 3);
  for (const std::string& sentence : read.broken) {
    CHECK_THAT(sentence, Contains(folder.path().string()));
  }
}

TEST_CASE("of too many runs the newest are read, and that is said") {
  // Proves it with a limit of two.
  const TemporaryFolder folder;
  const RunFolder runs{folder.path()};
  for (const char* day : {"2026-02-14", "2026-02-16", "2026-02-15"}) {
    runs.add(exampleRun(day, {}));
  }
  const RecordedRuns read = runs.read(2);
  REQUIRE(read.runs.size() == 2);
  CHECK(formatDay(read.runs[0].time) == "2026-02-15");
  REQUIRE(read.broken.size() == 1);
  CHECK_THAT(read.broken.front(), Contains("at most 2 runs, found 3"));
}

TEST_CASE("the newest wanted runs are read without the older ones") {
  // Proves which runs are read, that their order is that of time, and that a broken file and another robot's run are
  // passed over. A wish that counts its runs proves that older files are not read.
  const TemporaryFolder folder;
  const RunFolder runs{folder.path()};
  for (const char* day : {"2026-02-14", "2026-02-18", "2026-02-15", "2026-02-17"}) {
    runs.add(exampleRun(day, {}));
  }
  Run other = exampleRun("2026-02-16", {});
  other.robot.bodyId = "P009";
  runs.add(other);
  writeAtomically(folder.path() / "2026-02-19.json", "no JSON");
  std::size_t asked = 0;
  const std::vector<Run> newest = runs.readNewest(3, [&](const Run& run) {
    ++asked;
    return run.robot.bodyId != "P009";
  });
  REQUIRE(newest.size() == 3);
  CHECK(formatDay(newest[0].time) == "2026-02-15");
  CHECK(formatDay(newest[1].time) == "2026-02-17");
  CHECK(formatDay(newest[2].time) == "2026-02-18");
  CHECK(asked == 4);
  CHECK(RunFolder{folder.path() / "none"}.readNewest(3, [](const Run&) { return true; }).empty());
}

TEST_CASE("offsets of a result are the averaged ones that its captures determine") {
  // Proves which numbers are taken: averaged before value, learned joints only, joint offsets only.
  const json unknown{{"value", 0.1}, {"sigma", 0.01}, {"learned", 0.9}, {"degreesOfFreedom", 20.0}};
  json averaged = unknown, unlearned = unknown;
  averaged["averaged"] = {{"value", 0.2}, {"sigma", 0.02}};
  unlearned["learned"] = 0.3;
  const json result{{"effects",
                     {{{"effect", "jointOffset"}, {"at", "LKneePitch"}, {"unknowns", {{"o", averaged}}}},
                      {{"effect", "jointOffset"}, {"at", "HeadYaw"}, {"unknowns", {{"o", unlearned}}}},
                      {{"effect", "jointOffset"}, {"at", "HeadPitch"}, {"unknowns", {{"o", unknown}}}},
                      {{"effect", "elasticity"}, {"at", "LKneePitch"}, {"unknowns", {{"c", unknown}}}}}}};
  const auto offsets = offsetsOfResult(result, "result.json");
  REQUIRE(offsets.size() == 2);
  CHECK(offsets.at("LKneePitch").value == 0.2);
  CHECK(offsets.at("LKneePitch").sigma == 0.02);
  CHECK(offsets.at("LKneePitch").freedom == 20);
  CHECK(offsets.at("HeadPitch").value == 0.1);
}

} // namespace naocal

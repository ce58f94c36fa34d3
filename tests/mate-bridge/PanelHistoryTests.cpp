#include "PanelHistory.hpp"

#include "TemporaryFolder.hpp"
#include "io/Files.hpp"
#include "runs/RunFile.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <mutex>
#include <nlohmann/json.hpp>

using namespace naocal;
using Catch::Contains;
using Json = nlohmann::json;

namespace {

Run recordedRun(const std::string& captures) {
  return {.id = "2026-02-14_10-05-00_nao21_head",
          .time = parseTime("2026-02-14T10:05:00Z").value(),
          .robot = {"nao21", "nao21", "P007", "P008"},
          .kind = "head",
          .by = "naocal-robot",
          .outcome = RunOutcome::kept,
          .captures = captures,
          .sha256 = sha256("a set")};
}

Json published(const Run& run) {
  return Json::array({{{"id", run.id}, {"run", runJson(run)}}});
}

/// A history whose messages and opened paths are collected; `finish` waits for its thread.
struct HistoryBench {
  explicit HistoryBench(const std::filesystem::path& folder)
      : history{std::make_unique<PanelHistory>(
            folder, PanelHistory::Callbacks{
                        [this](const std::function<void()>& action) {
                          const std::lock_guard lock{mutex};
                          action();
                        },
                        [this](const Json& message) { told.push_back(message); },
                        [this](const std::vector<std::string>& paths, const std::vector<std::filesystem::path>&) {
                          opened.insert(opened.end(), paths.begin(), paths.end());
                        }})} {}
  void finish() { history.reset(); }

  std::mutex mutex;
  std::vector<Json> told;
  std::vector<std::string> opened;
  std::unique_ptr<PanelHistory> history;
};

} // namespace

TEST_CASE("a robot's runs are recorded once and shown") {
  // Proves it for a list that a robot sends twice, as a robot on the same computer records it too.
  const TemporaryFolder folder;
  const Run run = recordedRun("/recordings/one");
  HistoryBench bench{folder.path()};
  bench.history->record("nao21", published(run));
  bench.history->record("nao21", published(run));
  bench.finish();
  REQUIRE(bench.told.size() == 2);
  CHECK(bench.told[1]["kind"] == "history");
  REQUIRE(bench.told[1]["robots"].size() == 1);
  CHECK(bench.told[1]["robots"][0]["runs"].size() == 1);
  CHECK(runJson(RunFolder{folder.path()}.read().runs.at(0)) == runJson(run));
}

TEST_CASE("what a robot sends instead of runs is refused, and nothing is written for it") {
  // Proves it for wrong types, for an id that leads out of the folder, and for more runs than a message has.
  const TemporaryFolder folder;
  Run outside = recordedRun("");
  outside.id = "../outside";
  Json many = Json::array();
  for (int i = 0; i < 101; ++i) {
    many.push_back(published(recordedRun(""))[0]);
  }
  for (const Json& wrong :
       {Json(7), Json::array({1}), Json::array({{{"id", "a"}, {"run", 1}}}), published(outside), many}) {
    HistoryBench bench{folder.path() / "runs"};
    bench.history->record("nao21", wrong);
    bench.finish();
    REQUIRE(bench.told.size() == 2);
    CHECK(bench.told[0]["kind"] == "refused");
    CHECK_THAT(bench.told[0]["sentence"].get<std::string>(), Contains("A run of nao21 is not recorded"));
  }
  CHECK_FALSE(std::filesystem::exists(folder.path() / "outside.json"));
  CHECK(RunFolder{folder.path() / "runs"}.read().runs.empty());
}

TEST_CASE("a run is opened at its place, or where its captures were moved to, and otherwise asked for") {
  // Proves all three for a robot's recording, and that an applied result is opened instead of its captures.
  const TemporaryFolder folder;
  const auto recording = folder.path() / "recordings/one", moved = folder.path() / "usb/stick";
  std::filesystem::create_directories(recording / "first");
  writeAtomically(recording / "first/captures.json", "a set");
  Run applied = recordedRun(recording.string());
  applied.kind = applyKind;
  applied.id = "applied";
  applied.result = (folder.path() / "result.json").string();
  writeAtomically(applied.result, "{}");
  RunFolder{folder.path() / "runs"}.addCopy(recordedRun(recording.string()));
  RunFolder{folder.path() / "runs"}.addCopy(applied);
  const auto open = [&](const std::string& id, const std::vector<std::filesystem::path>& lookIn) {
    HistoryBench bench{folder.path() / "runs"};
    bench.history->open(id, lookIn);
    bench.finish();
    return bench.told.empty()
               ? bench.opened.at(0)
               : bench.told.at(0)["kind"].get<std::string>() + ": " + bench.told.at(0)["sentence"].get<std::string>();
  };
  const std::string id = recordedRun("").id;
  CHECK(open("applied", {}) == applied.result);
  CHECK(open(id, {}) == recording.string());
  std::filesystem::create_directories(moved);
  std::filesystem::rename(recording, moved / "other name");
  CHECK_THAT(open(id, {}), Contains("missing: ") && Contains("not in " + recording.string() + " on this computer"));
  CHECK(open(id, {folder.path() / "usb"}) == (moved / "other name/first").string());
  CHECK_THAT(open("never", {}), Contains("no longer recorded"));
}

TEST_CASE("without a folder nothing is recorded, and the page is told so") {
  // Proves that a panel of a user without a home works.
  HistoryBench bench{""};
  CHECK_FALSE(bench.history->isRecording());
  bench.history->record("nao21", published(recordedRun("")));
  bench.history->refresh();
  bench.finish();
  REQUIRE(bench.told.size() == 1);
  CHECK(bench.told[0]["folder"] == "");
  CHECK(bench.told[0]["robots"].empty());
}

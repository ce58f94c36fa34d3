#include "PanelHistory.hpp"

#include "data/SetSearch.hpp"
#include "io/InputError.hpp"
#include "io/JsonReader.hpp"
#include "runs/HistoryFile.hpp"
#include "runs/RobotHistory.hpp"
#include "runs/RunFile.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>

namespace naocal {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::json;

constexpr std::size_t mostPublished = 100; // runs in one message of a robot

/// The runs of a robot's message. Throws InputError.
std::vector<Run> parsePublished(const std::string& robot, const Json& published) {
  std::vector<Run> runs;
  const JsonCursor list{published, robot};
  for (const JsonCursor& one : list.elements()) {
    if (runs.size() == mostPublished) {
      list.refuse("at most 100 runs");
    }
    const std::string id = one.at("id").text();
    runs.push_back(parseRun(one.at("run").value(), id, fmt::format("{}: run {}", robot, id)));
  }
  return runs;
}

/// What to open for a run: its result or its recording, or its captures found by their sum.
SoughtSet findRecording(const Run& run, const std::vector<fs::path>& lookIn) {
  std::error_code ignored;
  if (run.kind == applyKind && !run.result.empty() && fs::exists(run.result, ignored)) {
    return {run.result, std::nullopt, ""};
  }
  const fs::path folder = run.captures;
  const bool isRound = !run.captures.empty() && fs::exists(folder / "captures.json", ignored);
  if (isRound || (!run.captures.empty() && fs::exists(folder / "first" / "captures.json", ignored))) {
    return {folder, std::nullopt, ""};
  }
  if (run.captures.empty() || run.sha256.empty()) {
    return {std::nullopt, std::nullopt,
            fmt::format("the run of {} UTC names no captures: there is nothing to open", formatMinute(run.time))};
  }
  for (const fs::path& root : lookIn) {
    SoughtSet found = findSet({run.captures, run.sha256}, {root / "x", {root}});
    if (found.folder) {
      return found;
    }
  }
  return {std::nullopt, std::nullopt,
          fmt::format("the captures of the run of {} UTC are not in {} on this computer; copy that folder from where "
                      "the run was made, and say where it is",
                      formatMinute(run.time), run.captures)};
}

} // namespace

PanelHistory::PanelHistory(fs::path folder, Callbacks calls) : runs_{std::move(folder)}, calls_{std::move(calls)} {}

void PanelHistory::send(Json message) {
  calls_.later([this, told = std::move(message)] { calls_.all(told); });
}

Json PanelHistory::readAll() const {
  if (!isRecording()) {
    return historyJson({}, "", {});
  }
  const RecordedRuns recorded = runs_.read(mostShown);
  return historyJson(makeHistories(recorded.runs), runs_.path().string(), recorded.broken);
}

void PanelHistory::refresh() {
  worker_.enqueue([this] {
    Json message;
    try {
      message = readAll();
    } catch (const std::exception& error) {
      message = historyJson({}, runs_.path().string(), {error.what()});
    }
    message["kind"] = "history";
    send(std::move(message));
  });
}

void PanelHistory::record(const std::string& robot, const Json& published) {
  if (!isRecording()) {
    return;
  }
  worker_.enqueue([this, robot, published] {
    try {
      for (const Run& run : parsePublished(robot, published)) {
        if (copied_ >= mostCopied) {
          throw InputError{fmt::format("expected at most {} new runs since the panel's start, found more", mostCopied)};
        }
        copied_ += runs_.addCopy(run) ? 1 : 0;
      }
    } catch (const std::exception& error) {
      send({{"kind", "refused"}, {"sentence", fmt::format("A run of {} is not recorded: {}", robot, error.what())}});
    }
  });
  refresh();
}

void PanelHistory::open(const std::string& id, const std::vector<fs::path>& lookIn) {
  worker_.enqueue([this, id, lookIn] {
    SoughtSet sought{std::nullopt, std::nullopt, "this run is no longer recorded"};
    try {
      const std::vector<Run> runs = runs_.read(mostShown).runs;
      const auto run = std::find_if(runs.begin(), runs.end(), [&](const Run& one) { return one.id == id; });
      sought = run == runs.end() ? sought : findRecording(*run, lookIn);
    } catch (const std::exception& error) {
      sought.sentence = error.what();
    }
    if (sought.folder) {
      calls_.later([this, path = sought.folder->string(), lookIn] { calls_.open({path}, lookIn); });
    } else {
      send({{"kind", "missing"}, {"sentence", sought.sentence}, {"run", id}});
    }
  });
}

} // namespace naocal

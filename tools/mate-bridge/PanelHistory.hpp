#pragma once

#include "math/Worker.hpp"
#include "runs/RunFolder.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace naocal {

/// The runs of robots for the panel: reads and records them on its own thread, and opens their captures.
///
/// Messages to all panels: {"kind": "history", ..} as `historyJson`; {"kind": "missing", "sentence", "run": id} if the
/// captures of a run are not on this computer.
class PanelHistory {
public:
  static constexpr std::size_t mostShown = 1000, mostCopied = 1000; // runs; copied from robots, per start of the panel

  struct Callbacks {
    std::function<void(std::function<void()>)> later; // posts to the panel's thread; thread-safe
    std::function<void(const nlohmann::json& message)> all;
    std::function<void(const std::vector<std::string>& paths, const std::vector<std::filesystem::path>& lookIn)> open;
  };

  /// `folder`: of runs; empty: none are read or recorded. The callbacks are called on the panel's thread, except
  /// `later`.
  PanelHistory(std::filesystem::path folder, Callbacks calls);

  /// Whether there is a folder of runs.
  bool isRecording() const { return !runs_.path().empty(); }
  /// Reads the runs and sends them.
  void refresh();
  /// Records a robot's newest runs ([{"id", "run": RUN.json}]) where they are not recorded yet, then sends all.
  void record(const std::string& robot, const nlohmann::json& published);
  /// Opens a run's recording, or the result that was applied: at its place, or found by its SHA-256 in `lookIn`.
  void open(const std::string& id, const std::vector<std::filesystem::path>& lookIn);

private:
  void send(nlohmann::json message);
  nlohmann::json readAll() const;

  RunFolder runs_;
  std::size_t copied_ = 0; // worker only
  Callbacks calls_;
  Worker worker_{Worker::AtEnd::allTasks}; // last: uses the members above
};

} // namespace naocal

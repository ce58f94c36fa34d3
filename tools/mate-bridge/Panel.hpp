#pragma once

#include "analysis/Dataset.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

struct PanelOptions {
  std::optional<Dataset> opened;                  // initial dataset; absent: none
  std::vector<std::string> robots;                // initial robots: addresses
  std::uint16_t port = 0;                         // on 127.0.0.1; 0: any free one
  std::vector<std::string> paths;                 // where `opened` was read from, for the recent files
  std::filesystem::path recentFiles;              // file that keeps the recent files; empty: none
  std::filesystem::path runs = {};                // folder of recorded runs; empty: none are read or recorded
  std::vector<std::filesystem::path> lookIn = {}; // searched for captures that were moved
};

/// The complete bridge: server, analysis of captures, robots. Runs until `stop`.
///
/// Path of a request to a robot, on the thread of `run` (one io_context): `send` in page/core/connection.js,
/// HttpServer, the handler of its verb in Panel.cpp, Robots, WatchedRobot, RobotClient. On the robot, on the thread of
/// SocketServers: Connection, then DebugServer (subscriptions) or ConfigServer (values; Configuration posts each to the
/// Thread of its module, which applies it between cycles).
///
/// Path back: a Thread (motion or brain) passes each cycle's values through an Outbox to the thread of SocketServers:
/// DebugServer (another thread encodes images), Connection; then, on the thread of `run`: RobotClient, WatchedRobot
/// (selects the panels that subscribe), HttpServer; in the page the listeners of `on` in connection.js. The Worker
/// threads of LiveDetection, AnalysisWorker and AnalysisSlot post their messages to the thread of `run`.
class Panel {
public:
  explicit Panel(PanelOptions options);
  ~Panel();

  /// URL of the panel, including the token.
  std::string address() const;

  void run();
  /// Thread-safe.
  void stop();

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

} // namespace naocal

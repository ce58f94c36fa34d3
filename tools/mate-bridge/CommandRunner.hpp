#pragma once

#include "start/ChildProgram.hpp"

#include <boost/asio/io_context.hpp>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// Runs the terminal program `naocal` for the panel: one command at a time, in the bridge's working directory, without
/// a shell; streams its output.
class CommandRunner {
public:
  /// A message for all panels, in JSON: {"kind": "errand", "program" or null, "folder", "words", "lines": the last
  /// lines of output, "running", "ending": whether an end was requested, "exitCode" or null}.
  using MessageSink = std::function<void(const std::string& json)>;

  /// `program`: absent if `naocal` is not installed.
  CommandRunner(boost::asio::io_context& context, std::optional<std::filesystem::path> program, MessageSink tell);

  /// Starts a command: its name and options. Throws InputError for an unknown command, or while another one runs.
  void run(const std::vector<std::string>& words);
  /// Sends SIGINT, so that the command can finish its current work; the second call sends SIGTERM.
  void end();

  /// The last message, for a new panel.
  std::string latest() const;

private:
  MessageSink tell_;
  std::string folder_;
  bool ending_ = false; // whether an end was requested
  ChildProgram child_;
};

} // namespace naocal

#pragma once

#include <boost/asio/io_context.hpp>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// The terminal's program `naocal`, run for a person who is at the panel: one command at a time, what it prints is told
/// as it comes. It runs in the folder where the bridge was started, without a shell.
class CommandRunner {
public:
  /// A message for all panels, in JSON: {"kind": "errand", "program" or null, "folder", "words", "lines": the last that
  /// were printed, "running", "ending": whether a person asked for its end, "exitCode" or null}.
  using MessageSink = std::function<void(const std::string& json)>;

  /// `program`: absent when this computer has none.
  CommandRunner(boost::asio::io_context& context, std::optional<std::filesystem::path> program, MessageSink tell);
  /// Ends the command.
  ~CommandRunner();

  /// Starts a command: its name and options. Throws InputError for what cannot be run, or not now.
  void run(const std::vector<std::string>& words);
  /// Ends the command as Ctrl-C does: it may finish what it has begun; asked again, it ends at once.
  void end();

  /// What was told last, for a panel to come.
  std::string latest() const;

private:
  struct Running;
  std::shared_ptr<Running> running_;
};

/// Where `naocal` is: beside this program, as it is built or installed, or where the shell would find it.
std::optional<std::filesystem::path> findNaocal();

} // namespace naocal

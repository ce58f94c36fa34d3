#pragma once

#include <boost/asio/io_context.hpp>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// A program that the bridge starts without a shell and without standard input, in its own process group; keeps the
/// last lines of its output. One at a time; it can be started again after its end. Used on the context's thread.
class ChildProgram {
public:
  static constexpr std::size_t mostLines = 300, longestLine = 500; // kept output; longer lines are cut [bytes]

  /// `program`: absent if it is not installed; `name` stands for it in messages. `changed` is called after the start,
  /// after the end, and at most five times per second for new output.
  ChildProgram(boost::asio::io_context& context, std::string name, std::optional<std::filesystem::path> program,
               std::function<void()> changed);
  /// Sends SIGTERM to a running program.
  ~ChildProgram();

  /// Throws InputError if the program is missing, runs already, or cannot be started.
  void start(const std::vector<std::string>& words);
  /// Sends a signal to the program's group, if it runs.
  void end(int signal);

  const std::optional<std::filesystem::path>& program() const;
  const std::vector<std::string>& words() const;
  const std::deque<std::string>& lines() const;
  bool isRunning() const;
  /// Of the last run; -1 after a signal, absent before the first end.
  const std::optional<int>& exitCode() const;
  /// Why the last run failed: its last line that is not empty. Empty while it runs, and if it ended with exit code 0.
  std::string failure() const;

private:
  struct Running;
  std::shared_ptr<Running> running_;
};

} // namespace naocal

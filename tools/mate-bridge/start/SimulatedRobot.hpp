#pragma once

#include "start/ChildProgram.hpp"

#include "io/Files.hpp"

#include <boost/asio/io_context.hpp>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace naocal {

/// A simulated robot to try the panel with: `naocal-robot` on this computer, with a temporary folder for what it learns
/// and records.
class SimulatedRobot {
public:
  /// `started` gets its address, `ended` too; `changed` is called when `state` changes.
  struct Calls {
    std::function<void(const std::string&address)> started, ended;
    std::function<void()> changed;
  };
  SimulatedRobot(boost::asio::io_context& context, Calls calls);

  /// Throws InputError if it cannot be started; does nothing if it runs.
  void start();
  /// It goes to its stand first; a second call ends it at once.
  void end();
  /// {"state": "off", "running", "ending" or "failed", "address", "sentence": why it failed}
  nlohmann::json state() const;

private:
  void onChanged();

  boost::asio::io_context& context_;
  Calls calls_;
  std::unique_ptr<TemporaryDirectory> folder_;
  std::string address_; // empty: off
  bool ending_ = false;
  ChildProgram child_; // last: it ends before the folder goes
};

} // namespace naocal

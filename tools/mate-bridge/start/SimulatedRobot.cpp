#include "start/SimulatedRobot.hpp"

#include "io/InputError.hpp"
#include "io/Programs.hpp"

#include <boost/asio/ip/tcp.hpp>
#include <csignal>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>
#include <utility>

namespace naocal {

namespace {

using Tcp = boost::asio::ip::tcp;

/// A base port of this computer whose debug and configuration ports, one and two above it, are free. Throws InputError
/// if none is found.
std::uint16_t freeBasePort(boost::asio::io_context& context) {
  const auto loopback = boost::asio::ip::address_v4::loopback();
  for (int trial = 0; trial < 20; ++trial) {
    boost::system::error_code error;
    const Tcp::acceptor debug{context, Tcp::endpoint{loopback, 0}};
    const unsigned port = debug.local_endpoint().port();
    Tcp::acceptor configuration{context, Tcp::v4()};
    if (port > 1 && port < 65535 && !configuration.bind({loopback, static_cast<std::uint16_t>(port + 1)}, error)) {
      return static_cast<std::uint16_t>(port - 1);
    }
  }
  throw InputError{"no free ports were found for a simulated robot; end programs that listen, and try again"};
}

} // namespace

SimulatedRobot::SimulatedRobot(boost::asio::io_context& context, Calls calls)
    : context_{context}, calls_{std::move(calls)}, child_{context, "naocal-robot", findProgram("naocal-robot"),
                                                          [this] { onChanged(); }} {}

void SimulatedRobot::start() {
  if (child_.isRunning()) {
    return;
  }
  const std::uint16_t port = freeBasePort(context_);
  folder_ = std::make_unique<TemporaryDirectory>();
  child_.start({"--hardware", "simulated", "--parent", std::to_string(::getpid()), "--base-port", std::to_string(port),
                "--state", (folder_->path() / "state").string(), "--recordings",
                (folder_->path() / "recordings").string()});
  ending_ = false;
  address_ = fmt::format("127.0.0.1:{}", port);
  calls_.changed();
  calls_.started(address_);
}

void SimulatedRobot::end() {
  child_.end(std::exchange(ending_, true) ? SIGKILL : SIGTERM);
  calls_.changed();
}

void SimulatedRobot::onChanged() {
  if (!child_.isRunning() && !address_.empty()) {
    calls_.ended(std::exchange(address_, ""));
  }
  calls_.changed();
}

nlohmann::json SimulatedRobot::state() const {
  const std::string failure = ending_ ? "" : child_.failure();
  const char* const state = child_.isRunning() ? ending_ ? "ending" : "running" : failure.empty() ? "off" : "failed";
  return {{"state", state}, {"address", address_}, {"sentence", failure}};
}

} // namespace naocal

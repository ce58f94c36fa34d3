#include "hardware/simulated/SimulatedSides.hpp"
#include "simulation/Simulation.hpp"

#include <fmt/format.h>
#include <thread>

namespace naocal {

namespace {

class SimulatedRobot : public RobotInterface {
public:
  explicit SimulatedRobot(std::shared_ptr<SimulatedShared> shared) : shared_{std::move(shared)} {}

  std::optional<RobotIdentity> waitForIdentity(std::chrono::milliseconds) override {
    const std::string id = fmt::format("{}{}", syntheticId, shared_->plan.seed);
    return RobotIdentity{id, id, shared_->drawing.model, shared_->drawing.model};
  }

  std::optional<RobotState> waitForState(std::chrono::milliseconds timeout) override {
    std::unique_lock lock{shared_->mutex};
    if (shared_->plan.pace == Pace::quick) {
      shared_->step.waitForCameraLoop(lock, [this] { return shared_->picturePending(); });
    } else {
      const TimePoint wake =
          std::min(shared_->now + SimulatedShared::cycle, std::chrono::steady_clock::now() + timeout);
      lock.unlock();
      std::this_thread::sleep_until(wake);
      lock.lock();
      if (wake < shared_->now + SimulatedShared::cycle) {
        return std::nullopt;
      }
      catchUp();
    }
    shared_->advance();
    ++shared_->link.states;
    RobotState state;
    shared_->body.measure(state);
    state.time = shared_->now;
    state.touch = shared_->touched;
    state.battery = {0.9, 0, -1.5, 30};
    shared_->step.changed.notify_all();
    return state;
  }

  void send(const RobotCommand& command) override {
    const std::lock_guard lock{shared_->mutex};
    const auto delay = std::chrono::duration_cast<std::chrono::nanoseconds>(shared_->plan.commandDelay);
    shared_->commands.emplace_back(shared_->now + delay, command);
  }

  std::chrono::nanoseconds period() const override { return SimulatedShared::cycle; }
  RobotLink link() const override {
    const std::lock_guard lock{shared_->mutex};
    return shared_->link;
  }

private:
  /// The world does not wait for a late program: what it misses is lost.
  void catchUp() {
    constexpr int most = 100; // cycles; a program that was stopped for longer finds the robot as it was
    for (int missed = 0; shared_->now + 2 * SimulatedShared::cycle <= std::chrono::steady_clock::now(); ++missed) {
      if (missed < most) {
        shared_->advance();
        ++shared_->link.lostStates;
      } else {
        shared_->now += SimulatedShared::cycle;
      }
    }
  }

  std::shared_ptr<SimulatedShared> shared_;
};

} // namespace

std::unique_ptr<RobotInterface> simulatedRobot(std::shared_ptr<SimulatedShared> shared) {
  return std::make_unique<SimulatedRobot>(std::move(shared));
}

} // namespace naocal

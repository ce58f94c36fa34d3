#pragma once

#include "hardware/RobotInterface.hpp"

#include <memory>

namespace naocal {

namespace shared {
struct Block;
}

/// A NAO V5: a module within NAOqi (nao/naoqi/, built with the vendor's SDK) exchanges states and commands with this
/// program through shared memory, every 10 ms. States are stamped by that module.
class SharedMemoryRobot : public RobotInterface {
public:
  /// `blockName` as for shm_open.
  explicit SharedMemoryRobot(std::string blockName = "/naocal");
  ~SharedMemoryRobot() override;

  std::optional<RobotIdentity> waitForIdentity(std::chrono::milliseconds timeout) override;
  std::optional<RobotState> waitForState(std::chrono::milliseconds timeout) override;
  void send(const RobotCommand& command) override;
  std::chrono::nanoseconds period() const override { return std::chrono::milliseconds{10}; }
  RobotStatus status() const override { return link_; }

private:
  struct Unmap {
    void operator()(shared::Block* block) const;
  };
  bool map();

  std::string blockName_;
  std::unique_ptr<shared::Block, Unmap> block_;
  std::uint32_t seen_ = 0; // number of the last state
  bool wasLost_ = false;   // since the last state
  TimePoint lastSign_{};   // of life
  RobotStatus link_;
};

} // namespace naocal

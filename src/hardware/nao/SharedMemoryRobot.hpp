#pragma once

#include "hardware/RobotInterface.hpp"

#include <memory>

namespace naocal {

namespace shared {
struct Block;
}

/// Driver of a NAO V5: exchanges states and commands with a NAOqi module (nao/naoqi/, built with the vendor's SDK)
/// through shared memory, every 10 ms. That module stamps the states.
class SharedMemoryRobot : public RobotInterface {
public:
  /// `blockName`: as for shm_open.
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
  std::uint32_t seen_ = 0; // number of the last state received
  bool wasLost_ = false;   // since the last state
  TimePoint lastSign_{};   // time of the last state or mapping
  RobotStatus link_;
};

} // namespace naocal

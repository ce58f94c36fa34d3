#include "hardware/nao/SharedMemoryRobot.hpp"

#include "hardware/RobotInterface.hpp"
#include "hardware/nao/DeviceConventions.hpp"
#include "hardware/nao/naoqi/SharedBlock.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace naocal {
namespace {

static_assert(sizeof(shared::Block) == 8 * sizeof(shared::State) + 8 * sizeof(shared::Command) + 148,
              "the robot's side is built by another compiler");

constexpr std::chrono::milliseconds silence{200}; // without new states for longer, the block is mapped again
constexpr std::chrono::milliseconds betweenMappings{5};

std::string text(const char (&characters)[shared::idLength]) {
  return {characters, strnlen(characters, shared::idLength)};
}

void copy(const Rgb& light, float (&to)[3]) {
  to[0] = light.red;
  to[1] = light.green;
  to[2] = light.blue;
}

template <typename List> Eigen::Vector3d vector(const List& numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

/// Converts a state from the shared block's format.
RobotState fromShared(const shared::State& from) {
  RobotState state;
  const auto seconds = std::int64_t(std::uint64_t{from.secondsHigh} << 32 | from.secondsLow);
  state.time = TimePoint{std::chrono::seconds{seconds} + std::chrono::nanoseconds{from.nanoseconds}};
  std::copy_n(from.angles, jointCount, state.angles.values.begin());
  std::copy_n(from.stiffness, jointCount, state.stiffness.begin());
  std::copy_n(from.current, jointCount, state.current.begin());
  std::copy_n(from.temperature, jointCount, state.temperature.begin());
  std::transform(from.status, from.status + jointCount, state.status.begin(), toStatusCode);
  state.accelerometer = vector(from.accelerometer);
  state.gyroscope = vector(from.gyroscope);
  state.torsoAngles = {from.torsoAngles[0], from.torsoAngles[1]};
  std::copy_n(from.forces, state.forces.size(), state.forces.begin());
  std::copy_n(from.sonar, state.sonar.size(), state.sonar.begin());
  for (std::size_t i = 0; i < touchOrder.size(); ++i) {
    state.touch.*touchOrder[i] = from.touch[i] > 0.5f;
  }
  state.battery = {from.battery[0], from.battery[1], from.battery[2], from.battery[3]};
  return state;
}

/// Converts a command to the shared block's format.
shared::Command toShared(const RobotCommand& command) {
  shared::Command to{};
  for (std::size_t joint = 0; joint < jointCount; ++joint) {
    to.angles[joint] = float(command.angles[joint]);
    to.stiffness[joint] = motorStiffness(command.stiffness[joint]);
  }
  copy(command.leds.chest, to.chest);
  copy(command.leds.leftFoot, to.leftFoot);
  copy(command.leds.rightFoot, to.rightFoot);
  for (std::size_t i = 0; i < command.leds.leftEye.size(); ++i) {
    copy(command.leds.leftEye[i], to.leftEye[i]);
    copy(command.leds.rightEye[i], to.rightEye[i]);
  }
  std::copy(command.leds.leftEar.begin(), command.leds.leftEar.end(), to.leftEar);
  std::copy(command.leds.rightEar.begin(), command.leds.rightEar.end(), to.rightEar);
  std::copy(command.leds.skull.begin(), command.leds.skull.end(), to.skull);
  return to;
}

} // namespace

void SharedMemoryRobot::Unmap::operator()(shared::Block* block) const {
  munmap(block, sizeof(shared::Block));
}

SharedMemoryRobot::SharedMemoryRobot(std::string blockName) : blockName_{std::move(blockName)} {
  link_.problem = "not connected yet";
}

SharedMemoryRobot::~SharedMemoryRobot() = default;

bool SharedMemoryRobot::map() {
  block_.reset();
  const int file = shm_open(blockName_.c_str(), O_RDWR | O_CLOEXEC, 0);
  if (file < 0) {
    link_.problem =
        fmt::format("shared memory {}: {}; is naocal's module loaded in NAOqi?", blockName_, strerror(errno));
    return false;
  }
  struct stat status {};
  void* memory = MAP_FAILED;
  if (fstat(file, &status) == 0 && status.st_size >= off_t(sizeof(shared::Block))) {
    memory = mmap(nullptr, sizeof(shared::Block), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  }
  close(file);
  if (memory == MAP_FAILED) {
    link_.problem =
        fmt::format("shared memory {}: it has {} bytes instead of {}; naocal's module in NAOqi is of another "
                    "version",
                    blockName_, status.st_size, sizeof(shared::Block));
    return false;
  }
  block_.reset(static_cast<shared::Block*>(memory));
  if (__atomic_load_n(&block_->magic, __ATOMIC_ACQUIRE) != shared::blockMagic ||
      block_->version != shared::blockVersion || block_->size != sizeof(shared::Block)) {
    block_.reset();
    link_.problem =
        fmt::format("shared memory {}: naocal's module in NAOqi is not ready or of another version", blockName_);
    return false;
  }
  lastSign_ = std::chrono::steady_clock::now();
  seen_ = __atomic_load_n(&block_->stateCount, __ATOMIC_ACQUIRE);
  return true;
}

std::optional<RobotIdentity> SharedMemoryRobot::waitForIdentity(std::chrono::milliseconds timeout) {
  if (!waitForState(timeout)) {
    return std::nullopt;
  }
  return RobotIdentity{text(block_->bodyId), text(block_->headId), text(block_->bodyVersion),
                       text(block_->headVersion)};
}

std::optional<RobotState> SharedMemoryRobot::waitForState(std::chrono::milliseconds timeout) {
  const TimePoint deadline = std::chrono::steady_clock::now() + timeout;
  TimePoint now;
  do {
    now = std::chrono::steady_clock::now();
    if (!block_ && !map()) {
      std::this_thread::sleep_for(std::clamp<std::chrono::nanoseconds>(deadline - now, {}, betweenMappings));
      continue;
    }
    shared::State state;
    const std::uint32_t number = shared::newest(block_->states, block_->stateCount, state);
    if (number == 0 || number == seen_) {
      if (now - lastSign_ > silence) {
        block_.reset(); // a restarted NAOqi may have created a new block
        wasLost_ = true;
        link_.problem = fmt::format("shared memory {}: NAOqi has not measured for 0.2 s", blockName_);
        continue;
      }
      const auto most = std::clamp<std::chrono::nanoseconds>(deadline - now, {}, silence);
      const std::uint32_t seen = number == 0 ? 0 : seen_; // no state yet: a restarted NAOqi
      shared::wait(block_->stateCount, seen, {0, long(most.count())});
      continue;
    }
    const bool restarted = number < seen_;
    link_.lostStates += restarted ? 0 : number - seen_ - 1;
    seen_ = number;
    lastSign_ = now;
    RobotState result = fromShared(state);
    if (isFinite(result)) {
      link_.reconnects += std::exchange(wasLost_, false);
      ++link_.states;
      link_.problem.clear();
      return result;
    }
    ++link_.lostStates;
    link_.problem = "the robot reports an angle, a tilt or a turning that is not a finite number";
  } while (now < deadline);
  return std::nullopt;
}

void SharedMemoryRobot::send(const RobotCommand& command) {
  if (!isFinite(command)) {
    link_.problem = "a command was not sent because it asks for an angle or stiffness that is not a finite number";
  } else if (block_) {
    shared::publish(block_->commands, block_->commandCount, toShared(command));
  }
}

} // namespace naocal

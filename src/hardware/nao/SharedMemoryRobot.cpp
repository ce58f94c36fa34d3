#include "hardware/nao/SharedMemoryRobot.hpp"

#include "hardware/nao/Finite.hpp"
#include "hardware/nao/SharedMessages.hpp"

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

constexpr std::chrono::milliseconds silence{200}; // after which the block may be another one by now
constexpr std::chrono::milliseconds betweenMappings{5};

std::string text(const char (&characters)[shared::idLength]) {
  return {characters, strnlen(characters, shared::idLength)};
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
        block_.reset(); // a NAOqi that was started anew may have made another block
        wasLost_ = true;
        link_.problem = fmt::format("shared memory {}: NAOqi has not measured for 0.2 s", blockName_);
        continue;
      }
      const auto most = std::clamp<std::chrono::nanoseconds>(deadline - now, {}, silence);
      const std::uint32_t seen = number == 0 ? 0 : seen_; // no state yet, of a NAOqi that was started anew
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

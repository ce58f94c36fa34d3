#include "hardware/nao/SharedMemoryRobot.hpp"
#include "hardware/nao/naoqi/DeviceKeys.h"
#include "hardware/nao/naoqi/SharedBlock.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <cstring>
#include <fcntl.h>
#include <limits>
#include <set>
#include <sys/mman.h>
#include <thread>

using namespace naocal;
using namespace std::chrono_literals;

namespace {

/// NAOqi's side of the shared memory, as implemented by the module in nao/naoqi.
class BlockTwin {
public:
  BlockTwin() {
    const int file = shm_open(name().c_str(), O_RDWR | O_CREAT, 0600);
    REQUIRE(ftruncate(file, sizeof(shared::Block)) == 0);
    block =
        static_cast<shared::Block*>(mmap(nullptr, sizeof(shared::Block), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0));
    close(file);
    block->version = shared::blockVersion;
    block->size = sizeof(shared::Block);
    std::strcpy(block->bodyId, "ALDB0001");
    std::strcpy(block->headId, "ALDH0002");
    std::strcpy(block->bodyVersion, "V5.0");
    std::strcpy(block->headVersion, "V5.0");
    __atomic_store_n(&block->magic, shared::blockMagic, __ATOMIC_RELEASE);
  }
  ~BlockTwin() {
    munmap(block, sizeof(shared::Block));
    shm_unlink(name().c_str());
  }
  static std::string name() { return "/naocal-test-" + std::to_string(getpid()); }

  /// Every number of the state identifies its position and sequence number.
  void measure(std::uint32_t sequence) {
    shared::State state{};
    float* numbers = state.angles;
    for (std::size_t i = 0; i < numberCount; ++i) {
      numbers[i] = number(i, sequence);
    }
    state.secondsLow = 100 + sequence;
    state.nanoseconds = 5;
    shared::publish(block->states, block->stateCount, state);
    shared::wake(block->stateCount);
  }
  static float number(std::size_t place, std::uint32_t sequence) { return float(place) / 256 + float(sequence % 1024); }

  static constexpr std::size_t numberCount = (sizeof(shared::State) - 12) / 4;
  shared::Block* block;
};

} // namespace

// Proves that both sides agree on the position of the numbers. The names of NAOqi's devices are not covered.
TEST_CASE("a V5's state arrives through shared memory with all its numbers") {
  BlockTwin twin;
  SharedMemoryRobot robot{BlockTwin::name()};
  CHECK(!robot.waitForState(0ms)); // nothing measured since the start
  std::thread naoqi{[&] {
    std::this_thread::sleep_for(5ms);
    twin.measure(3);
  }};
  const auto state = robot.waitForState(10s);
  naoqi.join();
  REQUIRE(state);
  CHECK(state->time.time_since_epoch() == 103s + 5ns);
  CHECK(state->angles[0] == BlockTwin::number(0, 3));
  CHECK(state->angles[25] == BlockTwin::number(25, 3));
  CHECK(state->stiffness[1] == BlockTwin::number(26 + 1, 3));
  CHECK(state->current[2] == BlockTwin::number(52 + 2, 3));
  CHECK(state->temperature[3] == BlockTwin::number(78 + 3, 3));
  CHECK(state->status[4] == 3);
  CHECK(state->accelerometer.z() == BlockTwin::number(132, 3));
  CHECK(state->gyroscope.x() == BlockTwin::number(133, 3));
  CHECK(state->torsoAngles.y() == BlockTwin::number(137, 3));
  CHECK(state->forces[7] == BlockTwin::number(145, 3));
  CHECK(state->sonar[1] == BlockTwin::number(147, 3));
  CHECK(state->touch.rightHandRight);
  CHECK(state->battery.temperature == BlockTwin::number(165, 3));
  CHECK(robot.status().problem.empty());
}

// Proves that states are complete and in order while the robot's side writes at full speed, and that all are delivered
// or counted.
TEST_CASE("states that were overwritten while they were read are never given", "[slow]") {
  BlockTwin twin;
  SharedMemoryRobot robot{BlockTwin::name()};
  CHECK(!robot.waitForState(0ms));
  constexpr std::uint32_t count = 100'000;
  std::thread naoqi{[&] {
    for (std::uint32_t sequence = 1; sequence <= count; ++sequence) {
      twin.measure(sequence);
      if (sequence % 16 == 0) {
        std::this_thread::yield();
      }
    }
  }};
  bool whole = true, inOrder = true;
  std::uint64_t last = 0;
  while (last < count && whole && inOrder) {
    const auto state = robot.waitForState(10s);
    REQUIRE(state);
    const auto sequence = std::uint64_t(state->time.time_since_epoch() / 1s - 100);
    inOrder = sequence > last && sequence == robot.status().states + robot.status().lostStates;
    last = sequence;
    for (std::size_t joint = 0; joint < jointCount; ++joint) {
      whole = whole && state->angles[joint] == BlockTwin::number(joint, std::uint32_t(sequence));
    }
    whole = whole && state->battery.temperature == BlockTwin::number(165, std::uint32_t(sequence));
  }
  naoqi.join();
  CHECK(whole);
  CHECK(inOrder);
}

// Proves the positions of a command's stiffness and light values.
TEST_CASE("a V5's command arrives whole, and one that is not finite does not") {
  BlockTwin twin;
  SharedMemoryRobot robot{BlockTwin::name()};
  CHECK(!robot.waitForState(0ms));
  RobotCommand command;
  command.angles[11] = 0.5;
  command.stiffness[11] = 0.75;
  command.stiffness[12] = 2;
  command.leds.chest = {0.25f, 0.5f, 0.75f};
  command.leds.leftEye[7].blue = 0.125f;
  command.leds.rightEye[0].green = 0.375f;
  command.leds.skull[11] = 1;
  robot.send(command);
  shared::Command received;
  REQUIRE(shared::newest(twin.block->commands, twin.block->commandCount, received) == 1);
  CHECK(received.angles[11] == 0.5f);
  CHECK(received.stiffness[11] == 0.75f);
  CHECK(received.stiffness[12] == 1);
  CHECK(received.stiffness[13] == -1);
  CHECK(received.chest[2] == 0.75f);
  CHECK(received.leftEye[7][2] == 0.125f);
  CHECK(received.rightEye[0][1] == 0.375f);
  CHECK(received.skull[11] == 1);
  command.angles[3] = std::numeric_limits<double>::quiet_NaN();
  robot.send(command);
  CHECK(shared::newest(twin.block->commands, twin.block->commandCount, received) == 1);
}

// Proves that a missing, incompatible or restarted NAOqi is waited for. The waiting time is not tested.
TEST_CASE("shared memory that is missing, foreign or made anew is said so and mended") {
  SharedMemoryRobot robot{BlockTwin::name()};
  CHECK(!robot.waitForIdentity(10ms));
  CHECK(robot.status().problem.find("is naocal's module loaded") != std::string::npos);
  {
    BlockTwin foreign;
    foreign.block->version = 77;
    CHECK(!robot.waitForState(10ms));
    CHECK(robot.status().problem.find("another version") != std::string::npos);
  }
  for (int start = 0; start < 2; ++start) {
    BlockTwin twin;
    std::atomic<bool> seen = false;
    std::thread naoqi{[&] {
      for (std::uint32_t sequence = 0; !seen; ++sequence) {
        twin.measure(sequence);
        std::this_thread::sleep_for(1ms);
      }
    }};
    if (start == 0) {
      CHECK(robot.waitForIdentity(10s) == RobotIdentity{"ALDB0001", "ALDH0002", "V5.0", "V5.0"});
    }
    CHECK(robot.waitForState(10s));
    seen = true;
    naoqi.join();
  }
  CHECK(robot.status().reconnects == 1);
}

// Proves that the module's device lists match the block's size and list no device twice except the motor of both hip
// yaw-pitches. The module itself requires the vendor's SDK and is not run.
TEST_CASE("NAOqi's devices are as many as the shared block has numbers") {
  const Keys sensors = sensorKeys(), lights = lightKeys();
  CHECK(sensors.size() == BlockTwin::numberCount);
  CHECK(std::set<std::string>(sensors.begin(), sensors.end()).size() == sensors.size() - 5);
  CHECK(lights.size() == (sizeof(shared::Command) - offsetof(shared::Command, chest)) / sizeof(float));
  CHECK(std::set<std::string>(lights.begin(), lights.end()).size() == lights.size());
  CHECK(jointKeys("", true).size() == jointCount - 1);
  for (std::size_t joint = 0; joint < jointCount; ++joint) {
    CHECK(std::string(deviceNames[joint]) == (joint == rightHipYawPitch ? "LHipYawPitch" : jointNames[joint]));
  }
}

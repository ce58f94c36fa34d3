#include "LolaTwin.hpp"
#include "TemporaryFolder.hpp"
#include "hardware/nao/LolaRobot.hpp"

#include <bit>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <random>
#include <thread>

using namespace naocal;
using namespace std::chrono_literals;

namespace {

/// Sequence number of a state, from one angle; absent if any other number belongs to another state.
std::optional<std::uint32_t> sequenceOf(const RobotState& state, std::uint32_t atLeast, std::uint32_t atMost) {
  for (std::uint32_t sequence = atLeast; sequence <= atMost; ++sequence) {
    if (state.angles[0] == twin::reported("Position", 0, sequence)) {
      bool same = true;
      for (std::size_t i = 0; i < twin::names.size(); ++i) {
        const std::size_t joint = *jointIndex(twin::names[i]);
        same = same && state.angles[joint] == twin::reported("Position", i, sequence) &&
               state.temperature[joint] == twin::reported("Temperature", i, sequence);
      }
      return same ? std::optional{sequence} : std::nullopt;
    }
  }
  return std::nullopt;
}

/// Number of states: $NAOCAL_LOLA_STATES, or 20,000 by default.
std::uint32_t stateCount() {
  const char* wanted = std::getenv("NAOCAL_LOLA_STATES");
  return wanted ? std::uint32_t(std::strtoul(wanted, nullptr, 10)) : 20'000;
}

void sendInFragments(twin::Server& server, std::string_view bytes, std::mt19937& random) {
  while (!bytes.empty()) {
    const std::size_t length = std::min<std::size_t>(bytes.size(), 1 + random() % (random() % 8 == 0 ? 5000 : 900));
    if (!server.send(bytes.substr(0, length))) {
      return;
    }
    bytes.remove_prefix(length);
  }
}

} // namespace

// Proves that no byte is lost or misplaced over many states, for random fragments: every state is delivered or counted
// as lost. NAOCAL_LOLA_STATES=1000000 runs a million.
TEST_CASE("states in random fragments are all received, in order and in step") {
  const TemporaryFolder folder;
  twin::Server server{folder.path() / "robocup"};
  auto robot = std::make_unique<LolaRobot>(folder.path() / "robocup");
  const std::uint32_t count = stateCount();
  std::thread sender{[&] {
    std::mt19937 random{1};
    server.accept();
    std::string pending;
    for (std::uint32_t sequence = 0; sequence < count; ++sequence) {
      pending += twin::state(sequence);
      if (random() % 4 != 0 || sequence + 1 == count) { // several states may share a fragment
        sendInFragments(server, pending, random);
        pending.clear();
        server.forget();
      }
    }
  }};
  std::uint32_t next = 0;
  bool inOrder = true;
  while (next < count && inOrder) {
    const auto state = robot->waitForState(10s);
    const std::uint32_t overtaken = std::uint32_t(robot->status().lostStates + robot->status().states) - next;
    const std::uint32_t expected = next + overtaken - 1;
    inOrder = state && sequenceOf(*state, expected, expected);
    next = expected + 1;
    robot->send({});
  }
  CHECK(inOrder);
  CHECK(next == count);
  CHECK(robot->status().states + robot->status().lostStates == count);
  CHECK(robot->status().reconnects == 0);
  robot.reset(); // lets the sender end after a failure
  sender.join();
}

// Proves that the robot receives one complete command per state, in order. Late readers are tested below.
TEST_CASE("every state is answered by a whole command") {
  const TemporaryFolder folder;
  twin::Server server{folder.path() / "robocup"};
  LolaRobot robot{folder.path() / "robocup"};
  constexpr int count = 2000;
  int whole = 0;
  std::thread sender{[&] {
    server.accept();
    LolaCommandWriter writer;
    for (int cycle = 0; cycle < count; ++cycle) {
      server.send(twin::state(std::uint32_t(cycle)));
      RobotCommand command;
      command.angles[0] = 1e-3 * cycle;
      const auto expected = writer.encode(command);
      whole += server.receive(lolaCommandSize) == std::string(expected.begin(), expected.end());
    }
  }};
  for (int cycle = 0; cycle < count; ++cycle) {
    const auto state = robot.waitForState(10s);
    REQUIRE(state);
    RobotCommand command;
    command.angles[0] = 1e-3 * cycle;
    robot.send(command);
  }
  sender.join();
  CHECK(whole == count);
}

// Proves that a robot that does not read its commands neither blocks the program nor receives partial ones.
TEST_CASE("commands that the robot does not take are dropped whole", "[slow]") {
  const TemporaryFolder folder;
  twin::Server server{folder.path() / "robocup"};
  auto robot = std::make_unique<LolaRobot>(folder.path() / "robocup");
  std::thread sender{[&] {
    server.accept();
    server.send(twin::state(0));
  }};
  REQUIRE(robot->waitForState(10s));
  sender.join();
  RobotCommand command;
  int sent = 0;
  for (; sent < 5000; ++sent) {
    command.angles[0] = sent;
    robot->send(command); // far more than the socket's buffer holds
  }
  std::atomic<int> taken = 0;
  bool good = true;
  std::thread reader{[&] {
    float last = -1;
    for (std::string message; (message = server.receive(lolaCommandSize)).size() == lolaCommandSize; ++taken) {
      std::uint32_t bits = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        bits = bits << 8 | std::uint8_t(message[message.find("Position") + 8 + 3 + 1 + i]);
      }
      const float angle = std::bit_cast<float>(bits);
      good = good && message[0] == char(0x8b) && angle > last;
      last = angle;
    }
  }};
  const int kept = 100; // fewer than the socket's buffer holds
  for (; taken < kept + 1000; ++sent) {
    command.angles[0] = sent;
    robot->send(command);
    robot->waitForState(1ms);
  }
  robot.reset();
  reader.join();
  CHECK(good);
  CHECK(taken < sent);
}

// Proves that after closes at random bytes the program reconnects in step, and that only complete states are delivered.
// LolaMeasurements.cpp measures the time to reconnect.
TEST_CASE("sudden closes in the middle of states are survived") {
  const TemporaryFolder folder;
  LolaRobot robot{folder.path() / "robocup"};
  constexpr std::uint32_t sessions = 20;
  std::atomic<bool> over = false;
  std::thread sender{[&] {
    std::mt19937 random{2};
    for (std::uint32_t session = 0; session < sessions; ++session) {
      twin::Server server{folder.path() / "robocup"}; // the socket file is also recreated
      for (int connection = 0; connection < 3; ++connection) {
        server.accept();
        const std::string bytes = twin::state(session) + twin::state(session) + twin::state(session);
        sendInFragments(server, std::string_view{bytes}.substr(0, random() % bytes.size()), random);
      }
      server.accept();
      server.send(twin::state(session));
      server.receive(lolaCommandSize); // waits until the state has been answered
    }
    over = true;
  }};
  std::uint32_t session = 0;
  bool good = true;
  while (!over) {
    if (const auto state = robot.waitForState(10ms)) {
      const auto now = sequenceOf(*state, session, sessions);
      good = good && now;
      session = now.value_or(session);
      robot.send({});
    }
  }
  sender.join();
  CHECK(good);
  CHECK(session + 1 == sessions);
  CHECK(robot.status().reconnects >= 2 * sessions);
}

// Proves that lost, inserted or random bytes never become a state, and that the stream resynchronises. A number changed
// in place cannot be noticed: the protocol has no checksum.
TEST_CASE("garbage between and within states never becomes a state", "[slow]") {
  const TemporaryFolder folder;
  twin::Server server{folder.path() / "robocup"};
  LolaRobot robot{folder.path() / "robocup"};
  constexpr std::uint32_t rounds = 50;
  std::atomic<std::uint32_t> wholeSeen = 0;
  std::thread sender{[&] {
    std::mt19937 random{3};
    for (std::uint32_t round = 0; round < rounds; ++round) {
      server.accept();
      std::string bytes = twin::state(2 * round) + twin::state(2 * round) + twin::state(2 * round);
      const std::size_t place = random() % bytes.size();
      switch (random() % 3) {
      case 0:
        bytes.erase(place, 1 + random() % 1000);
        break;
      case 1:
        for (std::size_t i = random() % 1000 + 1; i > 0; --i) {
          bytes.insert(place, 1, char(random()));
        }
        break;
      default:
        bytes.resize(20'000);
        std::generate(bytes.begin(), bytes.end(), [&] { return char(random()); });
      }
      sendInFragments(server, bytes, random);
      server.accept(); // accepts the reconnection, if any; the next data are correct
      while (wholeSeen < round + 1) {
        if (!server.send(twin::state(2 * round + 1))) {
          server.accept();
        }
        std::this_thread::yield();
      }
    }
  }};
  bool good = true;
  for (std::uint32_t round = 0; round < rounds && good;) {
    const auto state = robot.waitForState(10s);
    const auto sequence = state ? sequenceOf(*state, 2 * round, 2 * round + 1) : std::nullopt;
    const bool late = state && round > 0 && sequenceOf(*state, 2 * round - 1, 2 * round - 1);
    good = sequence || late;
    if (sequence == 2 * round + 1) {
      wholeSeen = ++round;
    }
  }
  wholeSeen = rounds;
  CHECK(good);
  server.forget();
  sender.join();
}

// Proves the message for a missing robot, and that waiting times out.
TEST_CASE("a robot whose socket is not there is absent, with a sentence") {
  const TemporaryFolder folder;
  LolaRobot robot{folder.path() / "robocup"};
  CHECK(!robot.waitForState(20ms));
  CHECK(!robot.waitForIdentity(0ms));
  CHECK(robot.status().problem == (folder.path() / "robocup").string() +
                                      ": no connection to the robot's hardware service: No such file or directory");
  robot.send({});
  CHECK_THROWS_AS(LolaRobot{std::string(200, 'x')}, std::invalid_argument);
}

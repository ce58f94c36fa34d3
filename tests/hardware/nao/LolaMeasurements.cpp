#include "LolaTwin.hpp"
#include "TemporaryFolder.hpp"
#include "hardware/nao/LolaRobot.hpp"

#include <catch2/catch.hpp>
#include <ctime>
#include <thread>

using namespace naocal;
using namespace std::chrono_literals;

// Measurement; proves nothing.
TEST_CASE("how long a reconnection and a cycle take", "[.measure]") {
  const TemporaryFolder folder;
  LolaRobot robot{folder.path() / "robocup"};
  std::vector<double> seconds;
  for (int i = 0; i < 100; ++i) {
    twin::Server server{folder.path() / "robocup"};
    const auto since = std::chrono::steady_clock::now();
    std::thread sender{[&] {
      server.accept();
      server.send(twin::state(1));
    }};
    REQUIRE(robot.waitForState(10s));
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count());
    sender.join();
    server.hangUp();
    robot.waitForState(30ms);
  }
  std::sort(seconds.begin(), seconds.end());
  WARN("a state after the robot is back: median " << 1e3 * seconds[50] << " ms, longest " << 1e3 * seconds.back()
                                                  << " ms");

  twin::Server server{folder.path() / "robocup"};
  constexpr int cycles = 20'000;
  std::thread sender{[&] {
    server.accept();
    for (int i = 0; i < cycles; ++i) {
      server.send(twin::state(1));
      server.receive(lolaCommandSize);
    }
  }};
  timespec before, after;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &before);
  RobotCommand command;
  for (int i = 0; i < cycles; ++i) {
    const auto state = robot.waitForState(10s);
    command.angles = state->angles;
    robot.send(command);
  }
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &after);
  sender.join();
  const double each = (double(after.tv_sec - before.tv_sec) + 1e-9 * double(after.tv_nsec - before.tv_nsec)) / cycles;
  WARN("processor time per cycle: " << 1e6 * each << " us, " << 100 * each / 0.012 << " % of 12 ms");
}

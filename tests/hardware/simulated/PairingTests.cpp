#include "framework/core/History.hpp"
#include "hardware/simulated/SimulatedWorld.hpp"

#include "RobotV6.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <thread>

using namespace naocal;
using namespace std::chrono_literals;

// Proves that images and joints share one clock: the head's angle, interpolated between states of 12 ms at the middle
// of an exposure, is wrong by less than 1 ms of its motion, with jitter and lost images. The encoder is configured
// finer, so that its steps do not matter. The simulated motion is linear within 3 ms.
TEST_CASE("joints interpolated at a picture's exposure are those of that moment to a millisecond") {
  SimulatedPlan plan;
  plan.pace = Pace::quick;
  plan.mechanics.encoderSteps = 1 << 24;
  plan.mechanics.encoderDither = 0;
  plan.cameras.jitter = Seconds{0.003};
  plan.cameras.lostShare = 0.1;
  SimulatedWorld world{v6(), plan};
  const auto robot = world.robot();
  const auto cameras = world.cameras();
  const std::size_t yaw = *jointIndex("HeadYaw");
  const auto inDrawing = Eigen::Index(*v6().jointIndex("HeadYaw"));
  const double offset = world.errors().robot.jointOffsets[inDrawing];

  History<double> measured;
  std::atomic<bool> over = false;
  std::thread motion{[&] {
    for (int cycle = 0; cycle < 1500; ++cycle) {
      const auto state = robot->waitForState(1s);
      measured.push(state->time, state->angles[yaw]);
      RobotCommand command;
      command.angles = plan.start;
      command.angles[yaw] = 0.8 * std::sin(0.05 * cycle); // up to 3.3 rad/s
      command.stiffness.fill(1);
      robot->send(command);
    }
    over = true;
  }};
  std::size_t pairs = 0;
  double worst = 0; // [s]
  while (!over) {
    const auto frame = cameras->waitForFrame(20ms);
    if (!frame) {
      continue;
    }
    const TimePoint middle = frame->time + 17ms;
    const auto angle = measured.at(middle);
    const auto truth = world.jointsAt(middle), before = world.jointsAt(middle - 12ms),
               after = world.jointsAt(middle + 12ms);
    if (!angle || !truth || !before || !after) {
      continue; // too early
    }
    const double speed = ((*after)[inDrawing] - (*before)[inDrawing]) / 0.024;
    if (std::abs(speed) > 1) {
      worst = std::max(worst, std::abs((*angle - offset - (*truth)[inDrawing]) / speed));
      ++pairs;
    }
  }
  motion.join();
  CHECK(pairs > 200);
  CHECK(worst < 0.001);
  UNSCOPED_INFO("worst of " << pairs << " pairs: " << 1e6 * worst << " us");
  CHECK(cameras->status(CameraName::top).lost > 10);
}

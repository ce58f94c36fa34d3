#include "hardware/simulated/SimulatedWorld.hpp"

#include "RobotV6.hpp"
#include "detect/BoardDetector.hpp"
#include "simulation/SyntheticRobot.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <thread>

using namespace naocal;
using namespace std::chrono_literals;

namespace {

SimulatedPlan inItsOwnTime() {
  SimulatedPlan plan;
  plan.pace = Pace::quick;
  return plan;
}

/// Plays `cycles` cycles of `angles(cycle)` in one thread; passes every image to `see` in another.
template <typename Angles, typename See>
void play(SimulatedWorld& world, int cycles, const Angles& angles, const See& see) {
  const auto robot = world.robot();
  auto cameras = world.cameras();
  std::atomic<bool> over = false;
  std::thread motion{[&] {
    for (int cycle = 0; cycle < cycles; ++cycle) {
      robot->waitForState(1s);
      RobotCommand command;
      command.angles = angles(cycle);
      command.stiffness.fill(1);
      robot->send(command);
    }
    over = true;
  }};
  while (!over) {
    if (const auto frame = cameras->waitForFrame(20ms)) {
      see(*frame, *cameras);
    }
  }
  motion.join();
}

RawAngles standing(int) {
  return SimulatedPlan::standingAngles();
}

/// Present pose of a camera in the world.
Eigen::Isometry3d worldFromCamera(const SimulatedWorld& world, const SyntheticRobot& robot, std::size_t camera) {
  const auto truth = world.truth();
  return truth.worldFromTorso * robot.torsoFromCamera(camera, truth.joints);
}

} // namespace

// Proves rate, order and numbers of images in a world with its own time, and reproducibility.
TEST_CASE("a quick world gives both cameras thirty pictures a second, none skipped, the same every time") {
  std::array<std::vector<TimePoint>, 2> times;
  std::array<std::vector<std::uint8_t>, 2> pictures;
  for (std::size_t round = 0; round < 2; ++round) {
    SimulatedWorld world{v6(), inItsOwnTime()};
    std::array<std::uint64_t, 2> next{};
    play(world, 250, standing, [&](const CameraFrame& frame, const CameraInterface& cameras) {
      CHECK(frame.sequence == next[std::size_t(frame.camera)]++);
      CHECK((times[round].empty() || frame.time > times[round].back()));
      times[round].push_back(frame.time);
      CHECK(cameras.status(frame.camera).skipped == 0);
      if (frame.sequence == 20) {
        const auto bytes = frame.picture->bytes();
        pictures[round].insert(pictures[round].end(), bytes.begin(), bytes.end());
      }
    });
    CHECK(times[round].size() >= 176); // 3 s, except images still in progress
    CHECK(times[round].size() <= 180);
  }
  CHECK(times[0] == times[1]);
  CHECK(pictures[0].size() == 2 * 2 * 640 * 480);
  CHECK(pictures[0] == pictures[1]);
}

// Proves that lost images are gaps and counted, and that time stamps jitter.
TEST_CASE("pictures that a simulated driver loses are gaps in the sequence") {
  SimulatedPlan plan = inItsOwnTime();
  plan.cameras.lostShare = 0.2;
  plan.cameras.jitter = Seconds{0.002};
  SimulatedWorld world{v6(), plan};
  std::uint64_t given = 0, last = 0;
  bool early = false, late = false;
  play(world, 500, standing, [&](const CameraFrame& frame, const CameraInterface& cameras) {
    if (frame.camera == CameraName::top) {
      ++given;
      last = frame.sequence;
      CHECK(cameras.status(CameraName::top).lost + given == frame.sequence + 1);
      const Seconds off = frame.time - TimePoint{1000s} - double(frame.sequence) * Seconds{1.0 / 30};
      early = early || off.count() < -0.001;
      late = late || off.count() > 0.001;
    }
  });
  CHECK(given < last);
  CHECK(given > last / 2);
  CHECK(early);
  CHECK(late);
}

// Proves that images show the boards as seen from the true camera, including the robot's errors.
TEST_CASE("a detector finds the boards in a simulated picture where they are") {
  const SimulatedPlan plan = inItsOwnTime();
  SimulatedWorld world{v6(), plan};
  const SyntheticRobot robot{v6(), world.errors().robot, plan.mechanics};
  std::size_t corners = 0;
  play(world, 60, standing, [&](const CameraFrame& frame, const CameraInterface&) {
    if (frame.sequence != 15) {
      return;
    }
    const std::size_t camera = *v6().cameraIndex(toString(frame.camera));
    const CameraIntrinsics intrinsics = plan.cameras.intrinsics.at(std::string{toString(frame.camera)});
    const Eigen::Isometry3d eye = worldFromCamera(world, robot, camera);
    const Detection detection = detectBoards(*toGreyImage(frame), plan.boards, intrinsics);
    for (const BoardCorners& found : detection.boards) {
      const auto board =
          std::find_if(plan.boards.begin(), plan.boards.end(), [&](auto& one) { return one.id == found.board; });
      for (std::size_t i = 0; i < found.ids.size(); ++i, ++corners) {
        const auto expected = projectPoint(intrinsics, eye.inverse() * isometryFromPlacement(*board->placement) *
                                                           board->points[std::size_t(found.ids[i])]);
        REQUIRE(expected);
        CHECK((*expected - found.uv[i]).norm() < 1);
      }
    }
  });
  CHECK(corners > 10);
}

// Proves that a quick world runs without a camera loop. A slow camera loop is not tested.
TEST_CASE("a quick world without a camera loop goes on") {
  SimulatedWorld world{v6(), inItsOwnTime()};
  const auto robot = world.robot();
  for (int i = 0; i < 100; ++i) {
    REQUIRE(robot->waitForState(1s));
  }
  CHECK(robot->status().states == 100);
}

// Proves that a blocked camera gives no images and reports it, and that time goes on.
TEST_CASE("a camera that gives no pictures leaves the other one alone") {
  SimulatedWorld world{v6(), inItsOwnTime()};
  world.block(CameraName::top, true);
  play(world, 50, standing, [&](const CameraFrame& frame, const CameraInterface& cameras) {
    CHECK(frame.camera == CameraName::bottom);
    CHECK(cameras.status(CameraName::top).problem == "the top camera gives no pictures");
  });
}

// Proves that both sides work in two threads in real time; the accuracy of the pace is not tested.
TEST_CASE("a world at the wall's pace gives states and pictures to two threads") {
  SimulatedPlan plan;
  plan.offsetRange = 0;
  const TimePoint began = std::chrono::steady_clock::now();
  SimulatedWorld world{v6(), plan};
  int frames = 0;
  play(world, 40, standing, [&](const CameraFrame& frame, const CameraInterface&) {
    CHECK(frame.time < std::chrono::steady_clock::now());
    ++frames;
  });
  CHECK(frames > 0);
  CHECK(std::chrono::steady_clock::now() - began >= 40 * 12ms);
  CHECK(world.truth().time <= std::chrono::steady_clock::now());
  CHECK(world.jointsAt(world.truth().time - 10ms).has_value());
  CHECK(!world.jointsAt(world.truth().time + 10ms));
  CHECK(!world.jointsAt(began - 10ms));
}

// Proves rolling shutter: with the head turning, a corner is projected at the exposure time of its row, not of the
// first or last row.
TEST_CASE("rows of a simulated picture are exposed one after the other") {
  SimulatedPlan plan = inItsOwnTime();
  plan.offsetRange = plan.mountRange = 0;
  plan.cameras.appearance.noise = 0;
  SimulatedWorld world{v6(), plan};
  const SyntheticRobot robot{v6(), world.errors().robot, plan.mechanics};
  const CameraIntrinsics intrinsics = plan.cameras.intrinsics.at("bottom");
  const std::size_t camera = *v6().cameraIndex("bottom");
  const auto turning = [](int cycle) {
    RawAngles angles = SimulatedPlan::standingAngles();
    angles[*jointIndex("HeadYaw")] = std::clamp(-0.4 + 0.008 * (cycle - 50), -0.4, 0.4); // 0.67 rad/s from cycle 50 on
    return angles;
  };
  std::size_t corners = 0;
  Eigen::Vector2d atRow = Eigen::Vector2d::Zero(), atFirst = atRow, atLast = atRow; // mean errors
  play(world, 140, turning, [&](const CameraFrame& frame, const CameraInterface&) {
    if (frame.camera != CameraName::bottom || frame.sequence < 30 || frame.sequence > 36) {
      return;
    }
    const Detection detection = detectBoards(*toGreyImage(frame), plan.boards, intrinsics);
    const Eigen::Isometry3d worldFromTorso = world.truth().worldFromTorso; // constant: only the head turns
    for (const BoardCorners& found : detection.boards) {
      const auto board =
          std::find_if(plan.boards.begin(), plan.boards.end(), [&](auto& one) { return one.id == found.board; });
      for (std::size_t i = 0; i < found.ids.size(); ++i, ++corners) {
        const auto off = [&](double row) {
          const Seconds since = plan.cameras.readOut * row / 479 + plan.cameras.exposure / 2;
          const auto joints =
              world.jointsAt(frame.time + std::chrono::duration_cast<std::chrono::nanoseconds>(since)).value();
          const Eigen::Isometry3d eye = worldFromTorso * robot.torsoFromCamera(camera, joints);
          const Eigen::Vector3d point =
              isometryFromPlacement(*board->placement) * board->points[std::size_t(found.ids[i])];
          return Eigen::Vector2d{found.uv[i] - projectPoint(intrinsics, eye.inverse() * point).value()};
        };
        atRow += off(found.uv[i].y());
        atFirst += off(0);
        atLast += off(479);
      }
    }
  });
  REQUIRE(corners > 10);
  CHECK((atRow / double(corners)).norm() < 0.3);
  CHECK((atFirst / double(corners)).norm() > 1);
  CHECK((atLast / double(corners)).norm() > 1);
}

#include "motion/RobotFaults.hpp"

#include "MotionRig.hpp"

#include <catch2/catch.hpp>
#include <limits>

namespace naocal {
namespace {

using Kind = PoseRequest::Kind;

constexpr int cyclesOfASecond = 84;

/// A robot in a pose away from its stand, whose joints follow so far.
struct Out : MotionRig {
  Out() {
    stand();
    ask(Kind::go, {looking(40, 0)});
    REQUIRE(untilDone());
    REQUIRE(see.player->reason.empty());
  }
  /// Whether the robot is back at its stand within a minute, and says why.
  bool comesHome(const std::string& why) {
    INFO(see.player->reason);
    return untilHome() && see.player->reason.find(why) != std::string::npos;
  }
};

} // namespace

TEST_CASE("a joint that is stuck sends the robot home") {
  // Proves it for a joint that does not move at all; the others go home.
  MotionRig rig;
  rig.stand();
  rig.robot.stuck[yaw] = true;
  rig.ask(Kind::go, {MotionRig::looking(40, 10)});
  for (int i = 0; i < 5000 && rig.see.player->reason.empty(); ++i) {
    rig.cycles(1);
  }
  CHECK(rig.see.player->reason.starts_with("HeadYaw does not follow: it was sent to "));
  CHECK(rig.see.player->reason.ends_with(" degrees and reads 0. The robot goes back to its stand: look after it."));
  CHECK(rig.untilHome());
  CHECK(rig.robot.state.angles[*jointIndex("HeadPitch")] == Approx(0).margin(1e-6));
}

TEST_CASE("a joint that reads too far from where it was sent sends the robot home, and a hand's breadth does not") {
  // Proves the deviation and its duration at their boundaries, for a robot that holds a pose.
  const double near = RobotFaults::largestDeviation - 0.1, far = RobotFaults::largestDeviation + 0.1;
  const int allowed = int(RobotFaults::longestDeviation / 0.012);
  Out rig;
  rig.robot.stuck[yaw] = true;
  rig.robot.state.angles[yaw] = radians(40 - near);
  rig.cycles(5 * cyclesOfASecond);
  CHECK(rig.see.player->reason.empty());
  rig.robot.state.angles[yaw] = radians(40 + far);
  rig.cycles(allowed - 1);
  CHECK(rig.see.player->reason.empty());
  rig.robot.state.angles[yaw] = radians(40);
  rig.cycles(2); // the time starts anew
  rig.robot.state.angles[yaw] = radians(40 - far);
  rig.cycles(allowed - 1);
  CHECK(rig.see.player->reason.empty());
  rig.cycles(3);
  CHECK(rig.see.player->reason.starts_with("HeadYaw does not follow: it was sent to 40 degrees and reads 25."));
}

TEST_CASE("an inertial unit that gives no true values sends the robot home") {
  // Proves it for readings of nothing, of too much and of no number, at the boundary of their duration.
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (const Eigen::Vector3d& reading : {Eigen::Vector3d{0, 0, 0}, {0, 0, 100}, {0, 0, none}}) {
    Out rig;
    rig.robot.state.accelerometer = reading;
    rig.cycles(int(RobotFaults::longestNonsense / 0.012));
    CHECK(rig.see.player->reason.empty());
    rig.cycles(3);
    CHECK(rig.see.player->reason == "The inertial unit gives no true values, so that a fall would not be noticed. The "
                                    "robot goes back to its stand: look after it.");
    CHECK(rig.comesHome("The inertial unit"));
  }
  Out rig;
  rig.robot.state.torsoAngles.x() = none;
  rig.cycles(2 * cyclesOfASecond);
  CHECK(rig.comesHome("The inertial unit"));
}

TEST_CASE("a robot that had to be held is held on its way home after a fault, too") {
  // Proves it for a hot joint's, a stuck joint's and the inertial unit's fault: the robot asks for hands first.
  for (const int fault : {0, 1, 2}) {
    MotionRig rig;
    rig.stand();
    rig.ask(Kind::go, {MotionRig::looking(40, 0)}, true);
    REQUIRE(rig.untilDone());
    rig.ask(Kind::go, {MotionRig::looking(35, 0)}); // let go
    REQUIRE(rig.untilDone());
    if (fault == 0) {
      rig.robot.state.temperature[knee] = 90;
    } else if (fault == 1) {
      rig.robot.stuck[yaw] = true;
      rig.robot.state.angles[yaw] = 0;
    } else {
      rig.robot.state.accelerometer.setZero();
    }
    rig.cycles(2 * cyclesOfASecond);
    CHECK(rig.see.player->held);
    CHECK(rig.see.player->reason.find("Take hold of it by its trunk") != std::string::npos);
    CHECK(rig.see.player->phase == PlayerState::Phase::holding);
    rig.press();
    CHECK(rig.untilHome());
  }
}

TEST_CASE("a clock that is set neither moves a robot nor lets it jump") {
  // Proves it for a state's time that goes back and ahead by an hour in the middle of a motion: the commands go on as
  // smoothly as before, and the motion ends where it should.
  for (const auto jump : {std::chrono::hours{-1}, std::chrono::hours{1}}) {
    MotionRig rig;
    rig.stand();
    rig.ask(Kind::go, {MotionRig::looking(40, 0)});
    rig.cycles(40);
    const std::size_t before = rig.robot.sent.size();
    rig.robot.state.time += jump;
    REQUIRE(rig.untilDone());
    for (std::size_t i = before; i < rig.robot.sent.size(); ++i) {
      const double step = rig.robot.sent[i].angles[yaw] - rig.robot.sent[i - 1].angles[yaw];
      CHECK(step >= 0);
      CHECK(step < radians(3));
    }
    CHECK(rig.robot.state.angles[yaw] == Approx(radians(40)));
    CHECK(rig.see.player->reason.empty());
  }
}

} // namespace naocal

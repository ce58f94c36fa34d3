#include "MotionRig.hpp"

#include <catch2/catch.hpp>

namespace naocal {
TEST_CASE("an offset changes what perception sees in the next cycle, and what motors are sent without a jump") {
  // Proves the path from parameter to angles and command in the shipped thread, by sign, without a restart: 4 degrees
  // take 0.4 s at the shipped 10 degrees per second.
  MotionRig rig;
  rig.stand();
  const double desired = rig.see.desired->angles[knee];
  CHECK(rig.robot.sent.back().angles[knee] == Approx(desired));
  rig.configuration.set("Motion.JointCalibrationProvider", "lKneePitch", 4.0);
  rig.motion.cycle();
  CHECK((*rig.see.angles)[knee] == Approx(desired - radians(4)));
  CHECK(rig.robot.sent.back().angles[knee] == Approx(desired + radians(10) * 0.012));
  rig.cycles(32);
  CHECK(rig.robot.sent.back().angles[knee] < desired + radians(4));
  rig.cycles(2);
  CHECK(rig.robot.sent.back().angles[knee] == Approx(desired + radians(4)));
  rig.cycles(1); // the scripted robot follows immediately
  CHECK((*rig.see.angles)[knee] == Approx(desired));
}

TEST_CASE("an offset that changes while the robot is on one foot moves it only once it is back") {
  // Proves it for a robot that was held on its way onto one foot and then released: no command changes before it is at
  // its stand.
  MotionRig rig;
  rig.stand();
  rig.ask(PoseRequest::Kind::go, {MotionRig::looking(40, 0)}, true);
  rig.untilDone();
  rig.ask(PoseRequest::Kind::go, {MotionRig::looking(40, 20)});
  rig.untilDone();
  const RawAngles before = rig.robot.sent.back().angles;
  rig.configuration.set("Motion.JointCalibrationProvider", "lKneePitch", 4.0);
  rig.cycles(100);
  CHECK(rig.robot.sent.back().angles[knee] == before[knee]);
  rig.ask(PoseRequest::Kind::home, {}, true);
  CHECK(rig.untilHome());
  rig.cycles(100);
  CHECK(rig.robot.sent.back().angles[knee] == Approx(MotionRig::home()[knee] + radians(4)));
}

TEST_CASE("both hip yaw-pitches have the left one's offset") {
  // Proves that different offsets for the one motor are reported, and that the left one is used.
  MotionRig rig;
  rig.stand();
  rig.configuration.set("Motion.JointCalibrationProvider", "lHipYawPitch", -2.0);
  rig.configuration.set("Motion.JointCalibrationProvider", "rHipYawPitch", 1.0);
  rig.cycles(20);
  CHECK(rig.robot.sent.back().angles[leftHip] == Approx(radians(-2)));
  CHECK(rig.robot.sent.back().angles[rightHip] == rig.robot.sent.back().angles[leftHip]);
  CHECK((*rig.see.angles)[rightHip] == (*rig.see.angles)[leftHip]);
  CHECK(*rig.see.offsetProblem == "rHipYawPitch (1 degrees) differs from lHipYawPitch (-2 degrees); one motor drives "
                                  "both, so the left one's counts: make them equal.");
  rig.configuration.set("Motion.JointCalibrationProvider", "rHipYawPitch", -2.0);
  rig.cycles(1);
  CHECK(rig.see.offsetProblem->empty());
}

TEST_CASE("an offset that no robot has is refused") {
  // Pins the message. Values up to 30 pass, so radians typed as degrees are not noticed.
  MotionRig rig;
  CHECK_THROWS_WITH(rig.configuration.set("Motion.JointCalibrationProvider", "headYaw", 57.0),
                    "Motion.JointCalibrationProvider: headYaw: expected an offset from -30 to 30 degrees, found 57.0");
}

TEST_CASE("the history keeps raw and compensated angles of every cycle and interpolates them") {
  // Proves both at a time between two cycles of a motion.
  MotionRig rig;
  rig.configuration.set("Motion.JointCalibrationProvider", "headYaw", 3.0);
  rig.stand();
  rig.ask(PoseRequest::Kind::go, {MotionRig::looking(40, 0)});
  rig.cycles(20);
  const auto newest = rig.see.moments->newest();
  REQUIRE(newest);
  CHECK(newest->time == rig.robot.state.time);
  const auto before = rig.see.moments->at(newest->time - std::chrono::milliseconds{12});
  const auto between = rig.see.moments->at(newest->time - std::chrono::milliseconds{3});
  REQUIRE(before);
  REQUIRE(between);
  CHECK(newest->value.raw[yaw] > before->raw[yaw]);
  CHECK(between->raw[yaw] == Approx(0.25 * before->raw[yaw] + 0.75 * newest->value.raw[yaw]));
  CHECK(between->angles[yaw] == Approx(between->raw[yaw] - radians(3)));
  CHECK_FALSE(rig.see.moments->at(newest->time + std::chrono::milliseconds{1}));
}

TEST_CASE("a robot is still once neither joints nor torso move, and as soon as one does it is not") {
  // Proves it at the end of a motion and for a rotating torso, in the module's production and in the history.
  MotionRig rig;
  rig.stand();
  rig.cycles(60);
  CHECK(*rig.see.stillFor > 0.5);
  rig.ask(PoseRequest::Kind::go, {MotionRig::looking(20, 0)});
  rig.cycles(20);
  CHECK(*rig.see.stillFor == 0);
  CHECK(rig.untilDone());
  rig.cycles(60);
  CHECK(*rig.see.stillFor > 0.5);
  CHECK(rig.see.moments->newest()->value.stillFor == *rig.see.stillFor);
  rig.robot.state.gyroscope.y() = 0.2;
  rig.cycles(1);
  CHECK(*rig.see.stillFor == 0);
}

TEST_CASE("without states the motion thread goes on, sends nothing and says nothing new") {
  // Proves that a silent robot neither ends the thread nor gets commands computed from an old state.
  MotionRig rig;
  rig.stand();
  rig.robot.silent = true;
  const std::size_t sent = rig.robot.sent.size();
  const auto time = rig.see.moments->newest()->time;
  rig.cycles(5);
  CHECK(rig.robot.sent.size() == sent);
  CHECK(rig.see.moments->newest()->time == time);
}

} // namespace naocal

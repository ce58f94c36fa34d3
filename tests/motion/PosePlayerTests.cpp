#include "MotionRig.hpp"

#include <catch2/catch.hpp>

namespace naocal {
namespace {

using Kind = PoseRequest::Kind;
using Phase = PlayerState::Phase;

double farthest(const CompensatedAngles& one, const CompensatedAngles& other) {
  double distance = 0;
  for (std::size_t joint = 0; joint < jointCount; ++joint) {
    distance = std::max(distance, std::abs(one[joint] - other[joint]));
  }
  return distance;
}

} // namespace

TEST_CASE("a way is smooth, within the allowed speed, and ends where it should") {
  // Proves the speed limit (a quarter of a joint's maximum) and the continuity of speed, by differences along a path
  // with a corner.
  const JointLimits limits{v6()};
  const CompensatedAngles start = MotionRig::looking(-60, 10), corner = MotionRig::looking(60, -20),
                          end = MotionRig::looking(0, 0);
  const PoseMotion motion{start, {corner, end}, limits, 0.25};
  const double step = 0.001;
  double lastSpeed = 0, fastest = 0, jump = 0;
  for (double time = 0; time < motion.duration() + 0.1; time += step) {
    const double speed = (motion.at(time + step)[yaw] - motion.at(time)[yaw]) / step;
    fastest = std::max(fastest, std::abs(speed));
    jump = std::max(jump, std::abs(speed - lastSpeed));
    lastSpeed = speed;
  }
  CHECK(fastest <= 0.25 * limits.maxSpeed(yaw) * 1.0001);
  CHECK(fastest > 0.24 * limits.maxSpeed(yaw));
  CHECK(jump < 0.02 * fastest);
  CHECK(motion.at(0) == start);
  CHECK(farthest(motion.at(motion.duration()), end) < 1e-12);
  CHECK(motion.passedPoints(0) == 0);
  CHECK(motion.passedPoints(motion.duration()) == 2);
}

TEST_CASE("motors stay off until something is asked for, and then start from where the joints are") {
  // Proves that motors start without a jerk: the first command with stiffness equals the measured angles.
  MotionRig rig;
  rig.robot.state.angles.values = MotionRig::looking(5, 0).values;
  rig.cycles(10);
  CHECK(rig.see.player->phase == Phase::off);
  CHECK(rig.robot.sent.back().stiffness[yaw] == 0);
  rig.ask(Kind::home);
  CHECK(rig.robot.sent.back().stiffness[yaw] == 0.9);
  CHECK(rig.robot.sent.back().angles[yaw] == Approx(radians(5)).margin(1e-6));
  CHECK(rig.untilDone());
  CHECK(rig.see.player->atHome);
  CHECK(rig.robot.sent.back().angles[yaw] == Approx(0).margin(1e-9));
}

TEST_CASE("a robot that is not at its stand does not move and says why") {
  // Pins the message for a robot lying or sitting.
  MotionRig rig;
  rig.ask(Kind::go, {MotionRig::looking(20, 0)});
  CHECK(rig.see.player->phase == Phase::off);
  CHECK(rig.see.player->reason ==
        "The pose was refused: the robot is not at its stand. Put it there (each joint within "
        "12 degrees) and start again.");
  CHECK(rig.robot.sent.back().stiffness[yaw] == 0);
}

TEST_CASE("points that joints cannot take are refused before anything moves") {
  // Proves it for a limit that depends on another joint, for NaN, and for an empty path.
  MotionRig rig;
  rig.stand();
  rig.ask(Kind::go, {MotionRig::looking(20, 0), MotionRig::looking(87, -30)});
  CHECK(rig.see.player->reason == "The pose was refused: HeadPitch cannot take -30.0 degrees there.");
  rig.cycles(50);
  CHECK(rig.robot.sent.back().angles[yaw] == Approx(0).margin(1e-9));
  rig.ask(Kind::go, {MotionRig::looking(std::nan(""), 0)});
  CHECK(rig.see.player->reason == "The pose was refused: HeadYaw cannot take nan degrees there.");
  rig.ask(Kind::go, {});
  CHECK(rig.see.player->reason == "The pose was refused: it names no angles.");
}

TEST_CASE("an abort at any moment leads back along the way that was taken") {
  // Proves for aborts at every tenth of a path with two corners, each repeated on the way home, that the robot ends at
  // its stand and stays within 0.02 rad of the checked path.
  const CompensatedAngles one = MotionRig::looking(40, 0), two = MotionRig::looking(40, 20),
                          three = MotionRig::looking(-20, 20);
  const PoseMotion way{MotionRig::home(), {one, two, three}, JointLimits{v6()}, 0.15};
  const auto distance = [&](const RawAngles& sent) {
    double nearest = 10;
    for (double time = 0; time <= way.duration(); time += 0.004) {
      nearest = std::min(nearest, farthest(CompensatedAngles{sent.values}, way.at(time)));
    }
    return nearest;
  };
  for (int tenth = 0; tenth <= 10; ++tenth) {
    MotionRig rig;
    rig.stand();
    rig.ask(Kind::go, {one, two, three});
    rig.cycles(static_cast<int>(way.duration() / 0.012 * tenth / 10));
    rig.ask(Kind::home);
    rig.cycles(30);
    rig.ask(Kind::home); // repeated on the way
    const std::size_t from = rig.robot.sent.size();
    CHECK(rig.untilDone());
    CHECK(rig.see.player->atHome);
    CHECK(farthest(rig.see.desired->angles, MotionRig::home()) < 1e-9);
    for (std::size_t i = from; i < rig.robot.sent.size(); i += 10) {
      REQUIRE(distance(rig.robot.sent[i].angles) < 0.02);
    }
  }
}

TEST_CASE("a touched robot stops and holds until its chest button sends it home") {
  // Proves it during a motion, with the messages; touching a robot that does not move has no effect.
  MotionRig rig;
  rig.stand();
  rig.robot.state.touch.headFront = true;
  rig.cycles(5);
  CHECK(rig.see.player->reason.empty());
  rig.robot.state.touch.headFront = false;
  rig.ask(Kind::go, {MotionRig::looking(40, 0)});
  rig.cycles(40);
  rig.robot.state.touch.leftFootLeft = true;
  rig.cycles(1);
  rig.robot.state.touch.leftFootLeft = false;
  CHECK(rig.see.player->phase == Phase::holding);
  CHECK(rig.see.player->reason == "The robot was touched and stopped. Press its chest button to have it go back to its "
                                  "stand.");
  const double held = rig.robot.sent.back().angles[yaw];
  CHECK(held > 0.01);
  rig.cycles(20);
  CHECK(rig.robot.sent.back().angles[yaw] == held);
  rig.robot.state.touch.chestButton = true;
  rig.cycles(3);
  rig.robot.state.touch.chestButton = false;
  CHECK(rig.see.player->reason == "The chest button was pressed: the robot goes back to its stand.");
  CHECK(rig.untilDone());
  CHECK(rig.see.player->atHome);
}

TEST_CASE("a tilted robot's motors become weak, and it starts again only from its stand") {
  // Proves the reaction to a fall, that it is counted once, and the restart.
  MotionRig rig;
  rig.stand();
  rig.ask(Kind::go, {MotionRig::looking(40, 0)});
  rig.cycles(40);
  rig.robot.state.torsoAngles.y() = radians(50);
  rig.cycles(1);
  CHECK(rig.see.player->phase == Phase::fallen);
  CHECK(rig.robot.sent.back().stiffness[yaw] == 0.1);
  CHECK(rig.see.player->reason == "The torso is tilted by 50 degrees, so the motors are weak. Stand the robot up and "
                                  "start again.");
  rig.cycles(5);
  CHECK(rig.see.player->falls == 1);
  rig.robot.state.torsoAngles.y() = 0;
  rig.ask(Kind::go, {MotionRig::looking(0, 10)});
  CHECK(rig.see.player->phase == Phase::fallen); // its head is still turned
  rig.stand();
  CHECK(rig.see.player->atHome);
}

TEST_CASE("a joint that gets too hot sends the robot home and off rests it") {
  // Proves the way home with its message, and that a rest request switches the motors off.
  MotionRig rig;
  rig.stand();
  rig.ask(Kind::go, {MotionRig::looking(40, 0)});
  CHECK(rig.untilDone());
  rig.robot.state.temperature[*jointIndex("RKneePitch")] = 80;
  rig.cycles(1);
  CHECK(rig.see.player->reason == "RKneePitch is 80 degrees Celsius hot: the robot goes back to its stand. Let it cool "
                                  "down.");
  CHECK_FALSE(rig.see.player->atHome);
  CHECK(rig.untilHome());
  rig.ask(Kind::rest);
  CHECK(rig.see.player->phase == Phase::off);
  CHECK(rig.robot.sent.back().stiffness[yaw] == 0);
}

TEST_CASE("a way home leaves out loops") {
  // Proves that a robot that has returned to an earlier point of its path goes home from there, without repeating the
  // loop.
  MotionRig rig;
  rig.stand();
  const CompensatedAngles hub = MotionRig::looking(0, 10);
  rig.ask(Kind::go, {hub, MotionRig::looking(60, 10)});
  rig.untilDone();
  rig.ask(Kind::go, {hub, MotionRig::looking(-60, 10)});
  rig.untilDone();
  rig.ask(Kind::home);
  double farthestLeft = 0;
  for (int i = 0; i < 5000 && !rig.see.player->done; ++i) {
    rig.cycles(1);
    farthestLeft = std::max(farthestLeft, rig.robot.sent.back().angles[yaw]);
  }
  CHECK(rig.see.player->atHome);
  CHECK(farthestLeft < radians(1));
}

TEST_CASE("a program that is being ended brings the robot to its stand first") {
  // Proves that the shutdown waits for the stand, and does not wait for a robot whose motors are off.
  MotionRig rig;
  rig.cycles(1);
  CHECK(rig.ending.atRest);
  rig.stand();
  rig.ask(Kind::go, {MotionRig::looking(60, 10)});
  rig.cycles(30);
  CHECK(!rig.ending.atRest);
  rig.ending.asked = true;
  rig.untilDone();
  CHECK(rig.see.player->reason == "The program is being ended: the robot goes back to its stand.");
  CHECK(rig.see.player->atHome);
  CHECK(rig.ending.atRest);
}

TEST_CASE("the chest button's presses at the stand are told on, those that send the robot home are not") {
  // Proves both, and that a button held down counts once.
  MotionRig rig;
  const auto press = [&] {
    rig.robot.state.touch.chestButton = true;
    rig.cycles(20);
    rig.robot.state.touch.chestButton = false;
    rig.cycles(1);
  };
  press();
  CHECK(rig.see.player->presses == 1);
  rig.stand();
  press();
  CHECK(rig.see.player->presses == 2);
  rig.ask(Kind::go, {MotionRig::looking(60, 10)});
  rig.cycles(30);
  press();
  CHECK(rig.see.player->presses == 2);
  rig.untilDone();
  CHECK(rig.see.player->atHome);
}

TEST_CASE("a robot that was held on its way out asks for hands before it goes home") {
  // Proves for each reason for going home that the robot waits with its eyes yellow for 10 s; that a press shortens the
  // wait; and that it does not ask again at its stand or while it is held.
  const CompensatedAngles one = MotionRig::looking(40, 0), two = MotionRig::looking(40, 20);
  for (const char* reason : {"asked", "pressed", "hot", "ended", "held"}) {
    INFO(reason);
    const std::string why{reason};
    MotionRig rig;
    rig.stand();
    rig.ask(Kind::go, {one}, true);
    rig.untilDone();
    CHECK(rig.see.player->held);
    rig.ask(Kind::go, {two});
    rig.untilDone();
    CHECK_FALSE(rig.see.player->held);
    if (why == "asked" || why == "held") {
      rig.ask(Kind::home, {}, why == "held");
    } else if (why == "pressed") {
      rig.press();
    } else if (why == "hot") {
      rig.robot.state.temperature[knee] = 90;
    } else {
      rig.ending.asked = true;
    }
    rig.cycles(50);
    CHECK(rig.see.player->held);
    CHECK((rig.see.player->phase == Phase::holding) == (why != "held"));
    if (why != "held") {
      CHECK(
          rig.see.player->reason.find("Take hold of it by its trunk: its eyes are yellow. It steps back onto both feet "
                                      "in 10 s, or at once when its chest button is pressed.") != std::string::npos);
      CHECK(rig.robot.sent.back().leds.leftEye.front() == holdMeColour);
      rig.cycles(static_cast<int>(10 / 0.012) - 60);
      CHECK(rig.see.player->phase == Phase::holding);
      why == "hot" ? rig.press() : rig.cycles(20);
    }
    CHECK(rig.see.player->phase == Phase::moving);
    CHECK(rig.untilHome());
    CHECK_FALSE(rig.see.player->held);
    rig.robot.state.temperature[knee] = 30;
    rig.ask(Kind::go, {two});
    rig.ask(Kind::home);
    CHECK(rig.see.player->phase == Phase::moving);
  }
}

TEST_CASE("while an answer is waited for, the chest button gives it") {
  // Proves it away from the stand, that a held robot stays held, and that after the next request the button sends the
  // robot home again.
  MotionRig rig;
  rig.stand();
  rig.ask(Kind::go, {MotionRig::looking(40, 0)}, true);
  rig.untilDone();
  rig.ask(Kind::wait);
  rig.press();
  CHECK(rig.see.player->presses == 1);
  CHECK(rig.see.player->held);
  CHECK(rig.see.player->reason.empty());
  rig.ask(Kind::go, {MotionRig::looking(40, 20)}, true);
  rig.press();
  CHECK(rig.see.player->presses == 1);
  CHECK(rig.see.player->reason == "The chest button was pressed: the robot goes back to its stand.");
}

TEST_CASE("silence in a motion is no jump, and joints that were moved meanwhile make motors weak") {
  // Proves that after a second without states the motion continues within four steps of a cycle, and the message for a
  // robot whose joints were moved.
  for (const bool bent : {false, true}) {
    MotionRig rig;
    rig.stand();
    rig.ask(Kind::go, {MotionRig::looking(60, 0)});
    rig.cycles(40);
    const double before = rig.robot.sent.back().angles[yaw];
    rig.cycles(1);
    const double step = rig.robot.sent.back().angles[yaw] - before;
    rig.robot.state.time += std::chrono::seconds{1};
    if (bent) {
      rig.robot.state.angles[knee] += radians(20);
    }
    rig.cycles(1);
    if (bent) {
      CHECK(rig.see.player->phase == Phase::fallen);
      CHECK(rig.see.player->reason == "Nothing was heard of the robot for 1.0 s, and its joints were moved meanwhile, "
                                      "so the motors are weak. Stand "
                                      "the robot up and start again.");
      CHECK(rig.robot.sent.back().stiffness[yaw] == 0.1);
    } else {
      CHECK(rig.robot.sent.back().angles[yaw] - before - step < 4 * step);
      CHECK(rig.untilDone());
    }
  }
}

TEST_CASE("a player's parameters are refused where they would be dangerous") {
  // Pins the messages.
  MotionRig rig;
  const auto refusal = [&](const char* key, const nlohmann::json& value) -> std::string {
    try {
      rig.configuration.set("Motion.PosePlayer", key, value);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "taken";
  };
  CHECK(refusal("speed", -1) == "Motion.PosePlayer: speed: expected a number above 0, at most 1, found -1");
  CHECK(refusal("speed", 3) == "Motion.PosePlayer: speed: expected a number above 0, at most 1, found 3");
  CHECK(refusal("largestTilt", 1000) == "Motion.PosePlayer: largestTilt: expected a number from 10 to 90, found 1000");
  CHECK(refusal("stand", {{"LKnee", 50}}) == "Motion.PosePlayer: stand: expected an angle in degrees for each joint, "
                                             "named as in HeadYaw; LKnee is none, found "
                                             "{\"LKnee\":50}");
}

} // namespace naocal

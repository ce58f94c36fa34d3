#include "blind/NaoV6.hpp"
#include "world/Mechanism.hpp"
#include "world/Pictures.hpp"
#include "writer/Question.hpp"

#include <catch2/catch.hpp>

namespace blind {
namespace {

Question soundRobot(int poses = 8) {
  RandomStream chance{7, "mechanism"};
  return drawQuestion(naoV6(), {"control", "", 0, poses, "clean"}, chance);
}

} // namespace

TEST_CASE("a link in a gap stays until it is pushed, and a load drives it to the gap's end") {
  // Proves the play operator: memory inside the gap, pushing at its ends, and gravity against friction.
  Play play{0.02};
  play.start(0);
  play.pushTo(0.005);
  CHECK(play.link() == 0);
  play.pushTo(0.015);
  CHECK(play.link() == Approx(0.005));
  play.pushTo(0.0);
  CHECK(play.link() == Approx(0.005));
  play.pushTo(-0.02);
  CHECK(play.link() == Approx(-0.01));
  play.applyLoad(-0.02, 0.01); // weaker than friction
  CHECK(play.link() == Approx(-0.01));
  play.applyLoad(-0.02, -1);
  CHECK(play.link() == Approx(-0.03));
}

TEST_CASE("a gear that sticks keeps its side until the load beats its friction") {
  // Proves both regimes of gear play: beyond the friction the load decides the side, below it the last motion.
  Question question = soundRobot(20);
  const int hip = naoV6().joint(question.plan.mainSide == 0 ? "LHipPitch" : "RHipPitch");
  constexpr double play = 0.01, friction = 0.4;
  Robot loose = question.robot;
  loose.flaws.joints[hip].gap = play;
  loose.flaws.joints[hip].gapFriction = friction;
  const Skeleton skeleton{naoV6(), loose.flaws};
  const auto tight = trueAngles(question.robot, question.session, skeleton);
  const auto angles = trueAngles(loose, question.session, skeleton);
  int byLoad = 0, byMotion = 0;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const int side = question.session.stances[question.session.readings[i].stance].side;
    const Skeleton::Posture posture = skeleton.posture(tight[i]);
    const double torque = skeleton.torques(posture, side, skeleton.torsoFromSole(posture, side).turn.col(2))[hip];
    const double moved = angles[i][hip] - tight[i][hip], approach = question.session.readings[i].excursion[hip];
    if (std::abs(torque) > friction + 0.02) {
      CHECK(moved == Approx(torque > 0 ? play / 2 : -play / 2));
      byLoad += moved * approach < 0;
    } else if (std::abs(torque) < friction - 0.1) { // clearly below the friction during the whole last motion
      CHECK(std::abs(moved) == Approx(play / 2));
      byMotion += moved * approach > 0;
    }
  }
  CHECK(byLoad > 0);
  CHECK(byMotion > 0);
}

TEST_CASE("readings that jitter leave the robot where it stands, and vary by as much as they are told") {
  // Proves the jitter's level in readings of both kinds of repeats, quantisation to encoder steps, and that jitter
  // leaves the true angles unchanged.
  const std::string kind = GENERATE("rest", "reapproach");
  RandomStream chance{11, "jitter"};
  const Question question = drawQuestion(naoV6(), {"jitter", kind, 0, 20, "jitter 0.10"}, chance);
  const Skeleton skeleton{naoV6(), question.robot.flaws};
  const auto angles = trueAngles(question.robot, question.session, skeleton);
  const int knee = naoV6().joint("LKneePitch");
  double square = 0;
  int count = 0;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const Reading& reading = question.session.readings[i];
    REQUIRE((reading.repeat == 0 || (reading.kind == RepeatKind::rest) == (kind == "rest")));
    CHECK(std::abs(std::remainder(reading.measured[knee], encoderStep)) < 1e-12);
    const double wrong = reading.measured[knee] - question.robot.offsets[knee] - angles[i][knee];
    square += wrong * wrong;
    ++count;
    if (reading.repeat > 0 && kind == "rest") {
      CHECK(angles[i][knee] == Approx(angles[i - 1][knee]).margin(1e-12));
    }
  }
  const double expected = std::hypot(0.1 * M_PI / 180, encoderStep / std::sqrt(12.0));
  CHECK(std::sqrt(square / count) == Approx(expected).epsilon(0.25)); // 60 readings: 9 % (1 sigma)
}

TEST_CASE("an encoder's displaced magnet errs by a sin q + b cos q to first order") {
  // Proves the signs of the first-order formula; the exact geometry is tested against its own inverse.
  JointFlaws flaws;
  flaws.magnetX = 0.004;
  flaws.magnetY = -0.006;
  for (const double read : {-1.2, -0.3, 0.0, 0.8, 2.0}) {
    const double expected = read + 0.004 * std::sin(read) + 0.006 * std::cos(read);
    CHECK(linkAngle(read, flaws) == Approx(expected).margin(1e-4));
    const double angle = linkAngle(read, flaws);
    CHECK(std::atan2(std::sin(angle) - 0.006, std::cos(angle) + 0.004) == Approx(read).margin(1e-12));
  }
}

TEST_CASE("a spring carries the torque of the posture that it sagged to") {
  // Proves the equilibrium, not its first order: deflection = c tau, with tau at the deflected posture.
  const Question question = soundRobot();
  Robot soft = question.robot;
  const int knee = naoV6().joint(question.plan.mainSide == 0 ? "LKneePitch" : "RKneePitch");
  soft.flaws.joints[knee].compliance = 0.01;
  const Skeleton skeleton{naoV6(), soft.flaws};
  const auto stiffAngles = trueAngles(question.robot, question.session, skeleton);
  const auto softAngles = trueAngles(soft, question.session, skeleton);
  for (std::size_t i = 0; i < softAngles.size(); ++i) {
    const int side = question.session.stances[question.session.readings[i].stance].side;
    const Skeleton::Posture posture = skeleton.posture(softAngles[i]);
    const Eigen::VectorXd torques = skeleton.torques(posture, side, skeleton.torsoFromSole(posture, side).turn.col(2));
    CHECK(softAngles[i][knee] - stiffAngles[i][knee] == Approx(0.01 * torques[knee]).margin(1e-6));
  }
}

TEST_CASE("friction's play leaves a joint half a gap short of where it came to") {
  // Proves the sign of hysteresis relative to the recorded approach.
  const Question question = soundRobot();
  Robot lagging = question.robot;
  const int hip = naoV6().joint("LHipYawPitch");
  lagging.flaws.joints[hip].lag = 0.01;
  const Skeleton skeleton{naoV6(), lagging.flaws};
  const auto angles = trueAngles(question.robot, question.session, skeleton);
  const auto behind = trueAngles(lagging, question.session, skeleton);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double approach = question.session.readings[i].excursion[hip] > 0 ? -1 : 1;
    CHECK(behind[i][hip] - angles[i][hip] == Approx(-0.005 * approach));
  }
}

TEST_CASE("a soft sole tips until it carries the weight where it then is") {
  // Proves the equilibrium of the sole and the contract's signs: pitch = +c x, roll = -c y.
  SoleFlaws flaws;
  flaws.compliance = 0.2;
  const Eigen::Vector3d centre{0.04, 0.01, 0.25};
  const Eigen::Matrix3d tilt = soleTilt(flaws, centre);
  const Eigen::Vector3d moved = tilt * centre;
  const double pitch = std::asin(-tilt(2, 0)), roll = std::atan2(tilt(2, 1), tilt(2, 2));
  CHECK(pitch == Approx(0.2 * moved.x()).margin(1e-6));
  CHECK(roll == Approx(-0.2 * moved.y()).margin(1e-6));
  CHECK(pitch > 0.2 * centre.x()); // tilting forward moves the centre of mass further forward
}

} // namespace blind

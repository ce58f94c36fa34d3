#include "hardware/simulated/Servo.hpp"

#include "RobotV6.hpp"

#include <catch2/catch.hpp>

using namespace naocal;

namespace {

constexpr Seconds step{0.002};

const Joint& knee() {
  return v6().joints[*v6().jointIndex("LKneePitch")];
}

void run(Servo& servo, double seconds, double torque, RandomStream& chance) {
  for (double time = 0; time < seconds; time += step.count()) {
    servo.advance(step, torque, chance);
  }
}

} // namespace

// Proves the limits of speed and range.
TEST_CASE("a servo turns no faster than its motor and no farther than its stops") {
  RandomStream chance{1, "servo"};
  Servo servo{knee(), 0, {}, 0};
  servo.command(10, 1);
  double fastest = 0, before = servo.motor();
  for (int i = 0; i < 1000; ++i) {
    servo.advance(step, 0, chance);
    fastest = std::max(fastest, (servo.motor() - before) / step.count());
    before = servo.motor();
  }
  CHECK(fastest == Approx(knee().maxSpeed));
  CHECK(std::abs(servo.motor() - knee().limits.upper) <= ServoMechanics{}.startBand);
}

// Proves stiction: a motor stops short of its target on the side it comes from, and commands within the start band do
// not move it.
TEST_CASE("a servo stops short of its target and ignores what is smaller than its friction") {
  RandomStream chance{1, "servo"};
  double sum = 0;
  for (int draw = 0; draw < 100; ++draw) {
    for (const double from : {0.2, 0.8}) {
      Servo servo{knee(), 0, {}, from};
      servo.command(0.5, 1);
      run(servo, 1, 0, chance);
      const double shortBy = std::copysign(1, 0.5 - from) * (0.5 - servo.motor());
      CHECK(shortBy >= -1e-4);
      CHECK(shortBy < ServoMechanics{}.startBand);
      sum += shortBy / 200;
      const double rested = servo.motor();
      servo.command(rested + 0.9 * ServoMechanics{}.startBand, 1);
      run(servo, 1, 0, chance);
      CHECK(servo.motor() == rested);
    }
  }
  CHECK(sum > 0.3 * ServoMechanics{}.stopBand);
}

// Proves the deflection under a torque, inversely proportional to stiffness.
TEST_CASE("a servo yields to a torque, the more the less stiff it is") {
  ServoMechanics frictionless;
  frictionless.stopBand = frictionless.startBand = 0;
  RandomStream chance{1, "servo"};
  for (const double stiffness : {1.0, 0.5}) {
    Servo servo{knee(), 0, frictionless, 0.4};
    servo.command(0.5, stiffness);
    run(servo, 2, 3, chance);
    CHECK(servo.motor() == Approx(0.5 + frictionless.droop * 3 / stiffness).epsilon(1e-6));
  }
}

// Proves the side of the gear's play: that of the torque, or, without torque, of the last motion.
TEST_CASE("a joint stands on the torque's side of its gear's play, and without a torque behind the last motion") {
  constexpr double play = 0.01;
  RandomStream chance{1, "servo"};
  for (const double torque : {-1.0, 1.0}) {
    for (const double from : {0.2, 0.8}) {
      Servo servo{knee(), play, {}, from};
      servo.command(0.5, 1);
      run(servo, 1, torque, chance);
      CHECK(servo.gap() == Approx(std::copysign(play / 2, torque)));
    }
  }
  for (const double from : {0.2, 0.8}) {
    Servo servo{knee(), play, {}, from};
    servo.command(0.5, 1);
    run(servo, 1, 0, chance);
    CHECK(servo.gap() == Approx(from < 0.5 ? -play / 2 : play / 2));
  }
}

// Proves that a motor without stiffness does not move.
TEST_CASE("a servo that is switched off stays where it is") {
  RandomStream chance{1, "servo"};
  Servo servo{knee(), 0, {}, 0.4};
  servo.command(0.9, -1);
  run(servo, 1, 2, chance);
  CHECK(servo.motor() == 0.4);
}

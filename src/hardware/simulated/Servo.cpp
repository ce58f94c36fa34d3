#include "hardware/simulated/Servo.hpp"

#include <algorithm>
#include <cmath>

namespace naocal {

Servo::Servo(const Joint& joint, double play, const ServoMechanics& mechanics, double motorAngle)
    : limits_{joint.limits}, maxSpeed_{joint.maxSpeed}, play_{play},
      mechanics_{mechanics}, motor_{motorAngle}, target_{motorAngle} {}

void Servo::command(double motorTarget, double stiffness) {
  target_ = std::clamp(motorTarget, limits_.lower, limits_.upper); // mechanical stops
  stiffness_ = std::clamp(stiffness, 0.0, 1.0);
}

void Servo::advance(Seconds step, double torque, RandomStream& chance) {
  if (stiffness_ == 0) {
    speed_ = 0;
    moving_ = false;
    movePlay(step, torque, 0);
    return;
  }
  const double error = target_ + mechanics_.droop / stiffness_ * torque - motor_;
  if (!moving_ && std::abs(error) > mechanics_.startBand) {
    moving_ = true;
    stopWithin_ = std::min(std::abs(chance.normal(mechanics_.stopBand)), mechanics_.startBand);
  }
  const double brisk = std::clamp(error / mechanics_.lag.count(), -maxSpeed_, maxSpeed_);
  const double most = mechanics_.maxAcceleration * step.count();
  speed_ = moving_ ? std::clamp(brisk, speed_ - most, speed_ + most) : 0;
  if (moving_ && std::abs(error) <= stopWithin_ && std::abs(speed_) * mechanics_.lag.count() <= mechanics_.startBand) {
    moving_ = false;
    speed_ = 0;
  }
  const double before = motor_;
  motor_ = std::clamp(motor_ + speed_ * step.count(), limits_.lower, limits_.upper);
  movePlay(step, torque, motor_ - before);
}

void Servo::movePlay(Seconds step, double torque, double turned) {
  gap_ -= turned; // the joint lags behind
  if (std::abs(torque) > mechanics_.gearFriction) {
    gap_ += std::copysign(play_ * (step / mechanics_.throughPlay) + std::abs(turned), torque);
  }
  gap_ = std::clamp(gap_, -play_ / 2, play_ / 2);
}

} // namespace naocal

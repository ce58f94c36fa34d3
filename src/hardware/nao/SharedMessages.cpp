#include "hardware/nao/SharedMessages.hpp"

#include "hardware/nao/Finite.hpp"
#include "hardware/nao/TouchOrder.hpp"

#include <algorithm>

namespace naocal {

namespace {

void copy(const Rgb& light, float (&to)[3]) {
  to[0] = light.red;
  to[1] = light.green;
  to[2] = light.blue;
}

template <typename List> Eigen::Vector3d vector(const List& numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

} // namespace

RobotState fromShared(const shared::State& from) {
  RobotState state;
  const auto seconds = std::int64_t(std::uint64_t{from.secondsHigh} << 32 | from.secondsLow);
  state.time = TimePoint{std::chrono::seconds{seconds} + std::chrono::nanoseconds{from.nanoseconds}};
  std::copy_n(from.angles, jointCount, state.angles.values.begin());
  std::copy_n(from.stiffness, jointCount, state.stiffness.begin());
  std::copy_n(from.current, jointCount, state.current.begin());
  std::copy_n(from.temperature, jointCount, state.temperature.begin());
  std::transform(from.status, from.status + jointCount, state.status.begin(), statusNumber);
  state.accelerometer = vector(from.accelerometer);
  state.gyroscope = vector(from.gyroscope);
  state.torsoAngles = {from.torsoAngles[0], from.torsoAngles[1]};
  std::copy_n(from.forces, state.forces.size(), state.forces.begin());
  std::copy_n(from.sonar, state.sonar.size(), state.sonar.begin());
  for (std::size_t i = 0; i < touchOrder.size(); ++i) {
    state.touch.*touchOrder[i] = from.touch[i] > 0.5f;
  }
  state.battery = {from.battery[0], from.battery[1], from.battery[2], from.battery[3]};
  return state;
}

shared::Command toShared(const RobotCommand& command) {
  shared::Command to{};
  for (std::size_t joint = 0; joint < jointCount; ++joint) {
    to.angles[joint] = float(command.angles[joint]);
    to.stiffness[joint] = motorStiffness(command.stiffness[joint]);
  }
  copy(command.leds.chest, to.chest);
  copy(command.leds.leftFoot, to.leftFoot);
  copy(command.leds.rightFoot, to.rightFoot);
  for (std::size_t i = 0; i < command.leds.leftEye.size(); ++i) {
    copy(command.leds.leftEye[i], to.leftEye[i]);
    copy(command.leds.rightEye[i], to.rightEye[i]);
  }
  std::copy(command.leds.leftEar.begin(), command.leds.leftEar.end(), to.leftEar);
  std::copy(command.leds.rightEar.begin(), command.leds.rightEar.end(), to.rightEar);
  std::copy(command.leds.skull.begin(), command.leds.skull.end(), to.skull);
  return to;
}

} // namespace naocal

#include "motion/JointHistory.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace naocal {
bool JointHistory::isStill(const JointSample& moment) const {
  const auto slow = [](double limit) { return [limit](double speed) { return std::abs(speed) <= limit; }; };
  return std::all_of(moment.speeds.begin(), moment.speeds.end(), slow(*fastestJoint_)) &&
         std::all_of(moment.turning.begin(), moment.turning.end(), slow(*fastestTurn_));
}

void JointHistory::cycle() {
  if (!measured_->isNew) {
    return;
  }
  const RobotState& state = measured_->state;
  JointSample moment{.raw = state.angles, .angles = *angles_, .sent = *sent_};
  moment.temperatures = state.temperature;
  moment.currents = state.current;
  moment.tilt = {state.torsoAngles.x(), state.torsoAngles.y()};
  moment.turning = {state.gyroscope.x(), state.gyroscope.y(), state.gyroscope.z()};
  moment.forces = state.forces;
  const auto before = moments_->at(state.time - fromSeconds(*window_));
  for (std::size_t joint = 0; joint < jointCount && before; ++joint) {
    moment.speeds[joint] = (moment.raw[joint] - before->raw[joint]) / *window_;
  }
  if (!before || !isStill(moment)) {
    stillSince_.reset();
  } else if (!stillSince_) {
    stillSince_ = state.time;
  }
  moment.stillFor = stillSince_ ? toSeconds(state.time - *stillSince_) : 0;
  stillFor_ = moment.stillFor;
  moments_.edit().push(state.time, moment);
}

} // namespace naocal

#include "motion/JointHistory.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

template <std::size_t Size>
std::array<double, Size> between(const std::array<double, Size>& from, const std::array<double, Size>& to,
                                 double fraction) {
  std::array<double, Size> result;
  for (std::size_t i = 0; i < Size; ++i) {
    result[i] = from[i] + (to[i] - from[i]) * fraction;
  }
  return result;
}

} // namespace

JointMoment interpolated(const JointMoment& from, const JointMoment& to, double fraction) {
  JointMoment moment;
  moment.raw = interpolated(from.raw, to.raw, fraction);
  moment.angles = interpolated(from.angles, to.angles, fraction);
  moment.speeds = between(from.speeds, to.speeds, fraction);
  moment.sent = fraction < 0.5 ? from.sent : to.sent;
  moment.temperatures = between(from.temperatures, to.temperatures, fraction);
  moment.currents = between(from.currents, to.currents, fraction);
  moment.tilt = between(from.tilt, to.tilt, fraction);
  moment.turning = between(from.turning, to.turning, fraction);
  moment.forces = between(from.forces, to.forces, fraction);
  moment.stillFor = from.stillFor > 0 && to.stillFor > 0 ? from.stillFor + (to.stillFor - from.stillFor) * fraction : 0;
  return moment;
}

void to_json(nlohmann::json& out, const JointMoment& moment) {
  out = {{"angles", moment.angles.values}, {"speeds", moment.speeds}, {"stillFor", moment.stillFor}};
}

bool JointHistory::isStill(const JointMoment& moment) const {
  const auto slow = [](double limit) { return [limit](double speed) { return std::abs(speed) <= limit; }; };
  return std::all_of(moment.speeds.begin(), moment.speeds.end(), slow(*fastestJoint_)) &&
         std::all_of(moment.turning.begin(), moment.turning.end(), slow(*fastestTurn_));
}

void JointHistory::cycle() {
  if (!measured_->isNew) {
    return;
  }
  const RobotState& state = measured_->state;
  JointMoment moment{.raw = state.angles, .angles = *angles_, .sent = sent_->values};
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
  moment.stillFor = stillSince_ ? seconds(state.time - *stillSince_) : 0;
  stillFor_ = moment.stillFor;
  moments_.edit().push(state.time, moment);
}

} // namespace naocal

#include "hardware/messages/JointSample.hpp"

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

JointSample interpolate(const JointSample& from, const JointSample& to, double fraction) {
  JointSample moment;
  moment.raw = interpolate(from.raw, to.raw, fraction);
  moment.angles = interpolate(from.angles, to.angles, fraction);
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

void to_json(nlohmann::json& out, const JointSample& moment) {
  out = {{"angles", moment.angles.values}, {"speeds", moment.speeds}, {"stillFor", moment.stillFor}};
}

} // namespace naocal

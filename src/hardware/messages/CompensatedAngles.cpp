#include "hardware/messages/CompensatedAngles.hpp"

#include <nlohmann/json.hpp>

namespace naocal {
namespace {

template <class Angles> Angles between(const Angles& from, const Angles& to, double fraction) {
  Angles result;
  for (std::size_t joint = 0; joint < jointCount; ++joint) {
    result[joint] = from[joint] + (to[joint] - from[joint]) * fraction;
  }
  return result;
}

} // namespace

CompensatedAngles interpolate(const CompensatedAngles& from, const CompensatedAngles& to, double fraction) {
  return between(from, to, fraction);
}
RawAngles interpolate(const RawAngles& from, const RawAngles& to, double fraction) {
  return between(from, to, fraction);
}

void to_json(nlohmann::json& out, const CompensatedAngles& angles) {
  out = angles.values;
}
void to_json(nlohmann::json& out, const RawAngles& angles) {
  out = angles.values;
}
} // namespace naocal

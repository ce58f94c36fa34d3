#pragma once

#include "hardware/Joints.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// Angles of the joints themselves, offsets taken out [rad]; hands [1]. What perception and planning use.
struct CompensatedAngles {
  PerJoint<double> values{};

  double& operator[](std::size_t joint) { return values[joint]; }
  double operator[](std::size_t joint) const { return values[joint]; }
  bool operator==(const CompensatedAngles&) const = default;
};
CompensatedAngles interpolate(const CompensatedAngles& from, const CompensatedAngles& to, double fraction);
RawAngles interpolate(const RawAngles& from, const RawAngles& to, double fraction);
void to_json(nlohmann::json& out, const CompensatedAngles& angles);
void to_json(nlohmann::json& out, const RawAngles& angles);

/// Makes the right hip yaw-pitch what the left one is: one motor drives both.
template <class Angles> void coupleHipYawPitch(Angles& angles) {
  constexpr std::size_t left = *jointIndex("LHipYawPitch"), right = *jointIndex("RHipYawPitch");
  angles.values[right] = angles.values[left];
}

} // namespace naocal

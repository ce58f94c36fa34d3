#pragma once

#include "hardware/Joints.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// True joint angles, without offsets [rad]; hands [1]. Used by perception and planning.
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

/// Copies the left hip yaw-pitch to the right one: one motor drives both.
template <class Angles> void coupleHipYawPitch(Angles& angles) {
  constexpr std::size_t left = *jointIndex("LHipYawPitch"), right = *jointIndex("RHipYawPitch");
  angles.values[right] = angles.values[left];
}

} // namespace naocal

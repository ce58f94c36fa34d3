#pragma once

#include "protocol/JointOrder.hpp"

#include <array>
#include <cstddef>

namespace naocal {

template <typename Value> using PerJoint = std::array<Value, jointCount>;

/// Angles as read by encoders and sent to motors, including offsets [rad]; hands [1]. Perception and planning use
/// CompensatedAngles; the separate types prevent mixing the two.
struct RawAngles {
  PerJoint<double> values{};

  double& operator[](std::size_t joint) { return values[joint]; }
  double operator[](std::size_t joint) const { return values[joint]; }
  bool operator==(const RawAngles&) const = default;
};

} // namespace naocal

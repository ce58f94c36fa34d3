#pragma once

#include "protocol/JointOrder.hpp"

#include <array>
#include <cstddef>

namespace naocal {

template <typename Value> using PerJoint = std::array<Value, jointCount>;

/// Angles as encoders show them and motors take them, offsets included [rad]; hands [1]. Perception and planning use
/// angles that are compensated for the offsets, which are of another type, so that the two cannot be mixed.
struct RawAngles {
  PerJoint<double> values{};

  double& operator[](std::size_t joint) { return values[joint]; }
  double operator[](std::size_t joint) const { return values[joint]; }
  bool operator==(const RawAngles&) const = default;
};

} // namespace naocal

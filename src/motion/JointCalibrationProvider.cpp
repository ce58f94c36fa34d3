#include "motion/JointCalibrationProvider.hpp"

#include "math/Angles.hpp"

#include <cctype>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

std::string plausible(const double& degrees) {
  return std::abs(degrees) <= largestOffset ? "" : fmt::format("an offset from -{0} to {0} degrees", largestOffset);
}

} // namespace

JointCalibrationProvider::JointCalibrationProvider() : Module{"JointCalibrationProvider"} {
  for (const std::string_view joint : jointNames) {
    degrees_.emplace_back(*this, offsetKey(joint), plausible);
  }
}

void JointCalibrationProvider::onParametersChanged() {
  for (std::size_t joint = 0; joint < jointCount; ++joint) {
    offsets_.values[joint] = radians(*degrees_[joint]);
  }
  constexpr std::size_t left = *jointIndex("LHipYawPitch"), right = *jointIndex("RHipYawPitch");
  problem_ =
      *degrees_[left] == *degrees_[right]
          ? std::string{}
          : fmt::format("rHipYawPitch ({} degrees) differs from lHipYawPitch ({} degrees); one motor drives both, "
                        "so the left one's counts: make them equal.",
                        *degrees_[right], *degrees_[left]);
  coupleHipYawPitch(offsets_);
}

void JointCalibrationProvider::cycle() {
  publishedOffsets_ = offsets_;
  problem_.edit();
  if (measured_->isNew) {
    angles_ = compensate(measured_->state.angles, offsets_);
  }
}

} // namespace naocal

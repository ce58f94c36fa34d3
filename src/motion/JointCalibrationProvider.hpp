#pragma once

#include "framework/core/Module.hpp"
#include "framework/core/Parameter.hpp"
#include "motion/JointOffsets.hpp"
#include "motion/SensorProvider.hpp"
#include "protocol/JointOrder.hpp"

#include <deque>
#include <string>
#include <string_view>

namespace naocal {

/// Subtracts joint offsets from encoder readings. The offsets are HULKs' parameters [deg], by joint; changes take
/// effect between cycles. RHipYawPitch uses the offset of LHipYawPitch: one motor drives both.
class JointCalibrationProvider final : public Module {
public:
  JointCalibrationProvider();
  void cycle() override;
  void onParametersChanged() override;

private:
  std::deque<Parameter<double>> degrees_; // same order as `jointNames`
  JointOffsets offsets_;
  Dependency<SensorFrame> measured_{*this, "measured"};
  Production<JointOffsets> publishedOffsets_{*this, "JointCalibrationData"};
  Production<CompensatedAngles> angles_{*this, "angles"};
  Production<std::string> problem_{*this, "JointCalibrationProvider.problem"}; // one sentence; empty: no problem
};

} // namespace naocal

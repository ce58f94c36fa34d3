#pragma once

#include "framework/core/Module.hpp"
#include "framework/core/Parameter.hpp"
#include "motion/JointOffsets.hpp"
#include "motion/SensorProvider.hpp"

#include <deque>
#include <string>
#include <string_view>

namespace naocal {

/// The key of a joint's offset in JointCalibrationProvider.json: its name with a small first letter.
std::string offsetKey(std::string_view joint);

/// Takes the joints' offsets out of what the encoders show. The offsets are HULKs' parameters, in degrees, by joint;
/// they take effect between two cycles. The right hip yaw-pitch's is that of the left: one motor drives both.
class JointCalibrationProvider final : public Module {
public:
  JointCalibrationProvider();
  void cycle() override;
  void onParametersChanged() override;

private:
  std::deque<Parameter<double>> degrees_; // in the order of `jointNames`
  JointOffsets offsets_;
  Dependency<SensorFrame> measured_{*this, "measured"};
  Production<JointOffsets> offsetsShown_{*this, "JointCalibrationData"};
  Production<CompensatedAngles> angles_{*this, "angles"};
  Production<std::string> problem_{*this, "JointCalibrationProvider.problem"}; // one sentence, empty when all is well
};

} // namespace naocal

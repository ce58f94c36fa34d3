#pragma once

#include "brain/Projection.hpp"
#include "brain/StillPicture.hpp"
#include "framework/Checks.hpp"
#include "framework/Dependency.hpp"
#include "framework/Module.hpp"
#include "framework/Parameter.hpp"
#include "framework/Production.hpp"
#include "hardware/exchange/JointMoment.hpp"

#include <deque>

namespace naocal {

/// Pairs each picture with what the robot measured in the middle of its exposure, and passes on those that were taken
/// while nothing moved. A picture whose moment the motion thread has not reported yet waits for it.
///
/// The middle of the exposure lies `latency` after the driver's stamp. Joints are interpolated between the two readings
/// around it.
class CaptureCollector final : public Module {
public:
  CaptureCollector() : Module{"CaptureCollector"} {}
  void cycle() override;
  void parametersChanged() override { latencyShown_ = *latency_; }

private:
  Parameter<double> latency_{*this, "latency",
                             within<-1, 1>}; // from a picture's stamp to the middle of its exposure [s]
  Dependency<NewFrame> frame_{*this, "frame"};
  Dependency<JointMoments> moments_{*this, "Motion.jointHistory"};
  Production<StillPicture> picture_{*this, "stillPicture"};
  Production<double> latencyShown_{*this, "captureLatency"}; // [s]
  std::deque<CameraFrame> waiting_;
};

/// The capture of a picture and the moment in the middle of its exposure: all that was measured then, raw.
Capture captureOf(const CameraFrame& frame, TimePoint middle, const JointMoment& moment);

} // namespace naocal

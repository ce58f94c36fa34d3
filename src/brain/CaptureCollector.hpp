#pragma once

#include "brain/ImageReader.hpp"
#include "brain/Projection.hpp"
#include "data/Capture.hpp"
#include "framework/core/Module.hpp"
#include "framework/core/Parameter.hpp"
#include "hardware/messages/JointSample.hpp"
#include "io/GreyImage.hpp"

#include <deque>

namespace naocal {

/// A picture that was taken while nothing moved, with what the robot measured in the middle of its exposure.
struct StillImage {
  bool isNew = false;
  bool isMoving = false; // instead: one came, but something moved
  CameraFrame frame;
  Capture capture;     // without pose and corners
  double stillFor = 0; // how long nothing had moved by then [s]
};
void to_json(nlohmann::json& out, const StillImage& picture);

/// Pairs each picture with what the robot measured in the middle of its exposure, and passes on those that were taken
/// while nothing moved. A picture whose moment the motion thread has not reported yet waits for it.
///
/// The middle of the exposure lies `latency` after the driver's stamp. Joints are interpolated between the two readings
/// around it.
class CaptureCollector final : public Module {
public:
  CaptureCollector() : Module{"CaptureCollector"} {}
  void cycle() override;
  void onParametersChanged() override { latencyShown_ = *latency_; }

private:
  Parameter<double> latency_{*this, "latency",
                             checkWithin<-1, 1>}; // from a picture's stamp to the middle of its exposure [s]
  Dependency<NewFrame> frame_{*this, "frame"};
  Dependency<JointSampleHistory> moments_{*this, "Motion.jointHistory"};
  Production<StillImage> picture_{*this, "stillPicture"};
  Production<double> latencyShown_{*this, "captureLatency"}; // [s]
  std::deque<CameraFrame> waiting_;
};

/// The capture of a picture and the moment in the middle of its exposure: all that was measured then, raw.
Capture makeCapture(const CameraFrame& frame, TimePoint middle, const JointSample& moment);

/// How far two pictures of a camera differ where they differ most [grey levels]: of blocks of 16 by 16 pixels the
/// difference of their means, less the median of the blocks beside it (lamps flicker from row to row); 19 of 20 blocks
/// differ by less. Noise of single pixels averages out. Infinite for pictures of different sizes.
double imageDifference(const GreyPicture& one, const GreyPicture& other);

} // namespace naocal

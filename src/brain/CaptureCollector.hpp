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

/// An image taken while the robot was still, with the measurements at mid-exposure.
struct StillImage {
  bool isNew = false;
  bool isMoving = false; // an image arrived, but the robot moved
  CameraFrame frame;
  Capture capture;     // without pose and corners
  double stillFor = 0; // time since the last motion [s]
};
void to_json(nlohmann::json& out, const StillImage& picture);

/// Pairs each image with the measurements at mid-exposure; publishes those taken while the robot was still. An image
/// waits until the motion thread has reported measurements up to its mid-exposure.
///
/// Mid-exposure is `latency` after the driver's stamp. Joints are interpolated between the neighbouring readings.
class CaptureCollector final : public Module {
public:
  CaptureCollector() : Module{"CaptureCollector"} {}
  void cycle() override;
  void onParametersChanged() override { latencyShown_ = *latency_; }

private:
  Parameter<double> latency_{*this, "latency", checkWithin<-1, 1>}; // from an image's stamp to its mid-exposure [s]
  Dependency<NewFrame> frame_{*this, "frame"};
  Dependency<JointSampleHistory> moments_{*this, "Motion.jointHistory"};
  Production<StillImage> picture_{*this, "stillPicture"};
  Production<double> latencyShown_{*this, "captureLatency"}; // [s]
  std::deque<CameraFrame> waiting_;
};

/// Difference of two images of one camera [grey levels], robust to pixel noise and lamp flicker: the 95 % quantile over
/// blocks of 16 by 16 pixels of |d - median of d in the block's row|, where d is the difference of the block means.
/// Infinite for images of different sizes.
double imageDifference(const GreyPicture& one, const GreyPicture& other);

} // namespace naocal

#include "brain/CaptureFaults.hpp"

#include "io/GreyImage.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace naocal {
namespace {

bool showsTheSame(const CameraFrame& one, const CameraFrame& other) {
  const auto some = completeBytes(one), others = completeBytes(other);
  return !some.empty() && std::equal(some.begin(), some.end(), others.begin(), others.end());
}

double meanOf(const GreyPicture& picture) {
  const double sum = std::accumulate(picture.pixels.begin(), picture.pixels.end(), 0.0);
  return sum / std::max<double>(1, double(picture.pixels.size()));
}

/// Load on both feet [kg]; 0 without readings.
double loadIn(const Capture& capture) {
  return capture.fsr ? std::accumulate(capture.fsr->begin(), capture.fsr->end(), 0.0) : 0;
}

} // namespace

std::string CaptureFaults::findCameraFault(const CameraFrame& frame, const std::string& pose) const {
  const auto last = last_.find(frame.camera);
  if (last != last_.end() && last->second.pose != pose && showsTheSame(last->second.frame, frame)) {
    return fmt::format("the {} camera takes new pictures: it repeats one, so restart the robot",
                       toString(frame.camera));
  }
  const auto picture = toGreyImage(frame);
  return picture && meanOf(*picture) < darkestMean
             ? fmt::format("the {} camera sees something: its pictures are black, so uncover it or make light",
                           toString(frame.camera))
             : "";
}

void CaptureFaults::note(const CameraFrame& frame, const Capture& capture) {
  last_[frame.camera] = {frame, capture.pose};
  feltLoad_ = feltLoad_ || loadIn(capture) >= lightestLoad;
}

bool CaptureFaults::isLifted(const Capture& still) const {
  return feltLoad_ && loadIn(still) < lightestLoad;
}

} // namespace naocal

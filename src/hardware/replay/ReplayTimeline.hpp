#pragma once

#include "data/Capture.hpp"
#include "hardware/CameraInterface.hpp"

#include <vector>

namespace naocal {

/// Timeline of a replayed capture set: a state every 12 ms, plus one exactly at each mid-exposure with exactly the
/// recorded readings. Between captures the state is that of the capture nearer in time, so it changes halfway in one
/// step. Of a gap of more than two minutes the middle is left out.
struct ReplayTimeline {
  struct Moment {
    TimePoint time;
    std::size_t capture; // index of the capture with the state's readings
  };
  struct Picture {
    CameraFrame frame;
    TimePoint arrives; // arrival, after the exposure
    std::size_t capture;
  };
  std::vector<Moment> moments;   // ascending
  std::vector<Picture> pictures; // by arrival
};

/// `latency`: from a frame's stamp to its mid-exposure. Images are read lazily from `folder`. Throws InputError if a
/// capture has no image, or a camera other than top or bottom.
ReplayTimeline buildTimeline(const CaptureSet& set, const std::filesystem::path& folder, Duration latency);

/// The robot state at a capture. Joints that the set lacks or did not record are 0.
RobotState stateAtCapture(const CaptureSet& set, const Capture& capture, TimePoint time);

} // namespace naocal

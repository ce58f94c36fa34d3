#pragma once

#include "data/Capture.hpp"
#include "hardware/CameraInterface.hpp"

#include <vector>

namespace naocal {

/// A capture set as a robot would have lived through it: states every 12 ms, and one exactly in the middle of every
/// exposure with exactly what was recorded. Between captures the robot rests in the one that is nearer in time, so it
/// jumps halfway.
struct ReplayTimeline {
  struct Moment {
    TimePoint time;
    std::size_t capture; // whose readings hold
  };
  struct Picture {
    CameraFrame frame;
    TimePoint arrives; // after the exposure
    std::size_t capture;
  };
  std::vector<Moment> moments;   // ascending
  std::vector<Picture> pictures; // by arrival
};

/// `latency`: from a frame's stamp to the middle of its exposure. Pictures are read from `folder` when somebody looks
/// at them. Throws InputError where a capture has no picture, or a camera is neither top nor bottom.
ReplayTimeline buildTimeline(const CaptureSet& set, const std::filesystem::path& folder, Duration latency);

/// What the robot reported at a capture. Joints that the set does not have, or did not record, are 0.
RobotState stateAtCapture(const CaptureSet& set, const Capture& capture, TimePoint time);

} // namespace naocal

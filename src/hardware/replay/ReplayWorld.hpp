#pragma once

#include "hardware/CameraInterface.hpp"
#include "hardware/RobotInterface.hpp"

#include <filesystem>
#include <memory>

namespace naocal {

struct Capture;
struct CaptureSet;
struct ReplayShared;

/// How a recording is played.
struct ReplayOptions {
  Duration latency = std::chrono::milliseconds{17}; // from a picture's stamp to the middle of its exposure, as the
                                                    // program that sees the replay has it configured
  bool realPace = false;                            // at the wall's pace instead of as fast as the program
};

/// A capture set, such as a session's recording, as a robot behind the two interfaces: every picture with the readings
/// that belong to it, to the last bit, in the order in which they were taken. Commands are heard by nobody.
class ReplayWorld {
public:
  /// `folder`: with captures.json and pictures. Throws InputError.
  explicit ReplayWorld(const std::filesystem::path& folder, const ReplayOptions& options = {});

  /// Its two sides, each for one thread; they may outlive it. After the last capture both have `hasEnded()`.
  std::unique_ptr<RobotInterface> robot();
  std::unique_ptr<CameraInterface> cameras();

  /// The set that is played, and the capture that a frame of it belongs to; nullptr for other frames.
  const CaptureSet& set() const;
  const Capture* captureOf(const CameraFrame& frame) const;

private:
  std::shared_ptr<ReplayShared> shared_;
};

} // namespace naocal

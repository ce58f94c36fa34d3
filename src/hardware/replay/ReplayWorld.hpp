#pragma once

#include "hardware/CameraInterface.hpp"
#include "hardware/RobotInterface.hpp"

#include <filesystem>
#include <memory>

namespace naocal {

struct Capture;
struct CaptureSet;
struct ReplayShared;

/// Replay options.
struct ReplayOptions {
  Duration latency = std::chrono::milliseconds{17}; // from an image's stamp to its mid-exposure; must equal the
                                                    // replaying program's setting
  bool realPace = false;                            // in real time instead of as fast as the program runs
};

/// Replays a capture set, such as a session's recording, as a robot behind the two interfaces: every image with its
/// recorded readings, bit for bit, in recorded order. Commands are ignored.
class ReplayWorld {
public:
  /// `folder`: contains captures.json and images. Throws InputError.
  explicit ReplayWorld(const std::filesystem::path& folder, const ReplayOptions& options = {});

  /// The interfaces for the motion and the camera thread; they may outlive this object. After the last capture both
  /// return `hasEnded()`.
  std::unique_ptr<RobotInterface> robot();
  std::unique_ptr<CameraInterface> cameras();

  /// The replayed set, and the capture that a frame belongs to; nullptr for unknown frames.
  const CaptureSet& set() const;
  const Capture* captureOf(const CameraFrame& frame) const;

private:
  std::shared_ptr<ReplayShared> shared_;
};

} // namespace naocal

#pragma once

#include "hardware/CameraFrame.hpp"

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace naocal {

/// How a camera fares.
struct CameraLink {
  std::uint64_t frames = 0;  // given to the program
  std::uint64_t skipped = 0; // taken, but a newer one was there when the program asked
  std::uint64_t lost = 0;    // that the driver took and never delivered: gaps of its sequence numbers
  std::uint64_t undated = 0; // whose driver's time means nothing here: they count from when they came
  std::uint64_t broken = 0;  // delivered but marked as damaged by the driver; not given to the program
  std::uint64_t reopened = 0;
  std::string problem; // one sentence while the camera gives nothing, or when it refused a setting; else empty
};

/// The cameras of a robot: real, replayed or simulated.
///
/// Threads: made and destroyed by whoever starts the camera loop's thread, while that does not run; all other calls
/// come from that thread alone. It never waits for the motion thread, nor that for it. Nothing throws after
/// construction: a camera that is gone is absence and a sentence in `link()`, and it is opened again by the next calls
/// while the other one goes on.
class CameraInterface {
public:
  virtual ~CameraInterface() = default;

  /// Blocks until one of the cameras has a picture that was not given yet; of several pictures of one camera the
  /// newest, of both cameras the older. Absent after `timeout` (wall time), or at the end of a replay.
  virtual std::optional<CameraFrame> waitForFrame(std::chrono::milliseconds timeout) = 0;

  /// Nothing will come any more: a replay is over.
  virtual bool ended() const { return false; }

  /// A camera's settings by the names of nao/VideoOptions.hpp, such as exposure; cameras that have none ignore them.
  /// What a camera refuses stands in `link`.
  virtual void configure(CameraName, const std::map<std::string, int>& /*settings*/) {}

  virtual CameraLink link(CameraName camera) const = 0;
};

} // namespace naocal

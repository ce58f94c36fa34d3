#pragma once

#include "brain/CalibrationRecorder.hpp"
#include "brain/CaptureCollector.hpp"
#include "framework/core/Module.hpp"
#include "hardware/replay/ReplayWorld.hpp"
#include "math/Worker.hpp"

#include <optional>

namespace naocal {

/// Repeats a recording's calibration during replay: pairs, detects and solves as on the robot. Data that the replay
/// does not provide (pose, commanded angles, approach directions) comes from the recording.
class ReplayedCalibration final : public Module {
public:
  /// `folder`: new recording; `model`: effects estimated in addition to offsets and mounts. All arguments must
  /// outlive the module.
  ReplayedCalibration(const Robot& drawing, const ReplayWorld& world, std::filesystem::path folder, ModelFile model);
  void cycle() override;

  /// Solves, and compares the estimates with a recorded result; returns one sentence. Call it after the replay's thread
  /// has ended. Rethrows the worker's first exception.
  std::string compareWith(const std::filesystem::path& recordedResult);

private:
  const ReplayWorld& world_;
  Dependency<StillImage> picture_{*this, "stillPicture"};
  std::optional<CalibrationRecorder> session_;
  std::exception_ptr failure_;             // first exception of the worker
  Worker worker_{Worker::AtEnd::allTasks}; // last: uses the members above
};

} // namespace naocal

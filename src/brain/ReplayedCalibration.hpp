#pragma once

#include "brain/CalibrationRecorder.hpp"
#include "brain/CaptureCollector.hpp"
#include "framework/core/Module.hpp"
#include "hardware/replay/ReplayWorld.hpp"
#include "math/Worker.hpp"

#include <optional>

namespace naocal {

/// Takes a recording's captures anew while it is replayed: pairing, detection and solving as on the robot. What no
/// replay tells (which pose it was, what was commanded, how joints moved) is taken from the recording.
class ReplayedCalibration final : public Module {
public:
  /// `folder`: for the new recording; `model`: what is estimated beside offsets and mounts. Everything must outlive it.
  ReplayedCalibration(const Robot& drawing, const ReplayWorld& world, std::filesystem::path folder, ModelFile model);
  void cycle() override;

  /// Once the replay is over and its thread has ended: solves, and says in a sentence how the estimates compare with a
  /// recorded result. Throws what was thrown on the way.
  std::string compareWith(const std::filesystem::path& recordedResult);

private:
  const ReplayWorld& world_;
  Dependency<StillImage> picture_{*this, "stillPicture"};
  std::optional<CalibrationRecorder> session_;
  std::exception_ptr failure_;             // the worker's first
  Worker worker_{Worker::AtEnd::allTasks}; // last: it uses the others
};

} // namespace naocal

#pragma once

#include "brain/CalibrationRunner.hpp"
#include "framework/core/Thread.hpp"
#include "hardware/CameraInterface.hpp"

namespace naocal {

/// The brain thread's modules; the cameras and what `context` refers to must outlive the thread.
void addBrainModules(Thread& brain, CameraInterface& cameras, const CalibrationContext& context);

} // namespace naocal

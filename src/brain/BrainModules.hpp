#pragma once

#include "brain/CalibrationRunner.hpp"
#include "framework/core/Thread.hpp"
#include "hardware/CameraInterface.hpp"

namespace naocal {

/// Adds the brain thread's modules. The cameras and everything `context` refers to must outlive the thread.
void addBrainModules(Thread& brain, CameraInterface& cameras, const CalibrationContext& context);

} // namespace naocal

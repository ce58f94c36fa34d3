#pragma once

#include "estimation/Model.hpp"
#include "measurements/Measurements.hpp"
#include "simulation/Renderer.hpp"

namespace naocal {

/// Throws InputError for what rendered pictures cannot show: no camera, boards without a ChArUco pattern, and effects
/// of a board's shape or of the shutter.
void requireRenderable(const CaptureSet& set, const Model& model);

/// The lens of a camera in a state; `drawn`: as the set tells it.
CameraIntrinsics lensIn(const ModelState& state, const CameraIntrinsics& drawn);

/// The boards before the camera of a picture.
RenderedScene boardsBefore(const ImageObservation& picture, const Measurements& measurements, const PosedRobot& posed);

} // namespace naocal

#pragma once

#include "residuals/Measurements.hpp"
#include "residuals/ModelFile.hpp"

#include <filesystem>

namespace naocal {

/// What a calibration on the robot estimates beside offsets and mounts: models/V6.json (and so on) in the
/// configuration's folder, a model file as the laptop's tools write it. Throws InputError.
ModelFile calibrationModel(const std::filesystem::path& configuration, const Robot& drawing);

/// The model for these captures: none of its effects where the robot stood on both feet, for there the loads of the
/// joints are not known.
ModelFile modelFor(const Measurements& measurements, const ModelFile& model);

} // namespace naocal

#pragma once

#include "estimation/ModelFile.hpp"
#include "measurements/Measurements.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace naocal {

/// What a calibration on the robot estimates beside offsets and mounts: models/V6.json (and so on) in the
/// configuration's folder, a model file as the laptop's tools write it. Throws InputError.
ModelFile calibrationModel(const std::filesystem::path& configuration, const Robot& drawing);

/// A model without what captures know nothing of: the other leg's effects, those whose drivers were not recorded; none
/// of its effects where the robot stood on both feet, for there the loads of the joints are not known.
struct FittingModel {
  ModelFile model;
  std::vector<std::string> leftOut; // "with E@P", "without E@P" of what could have been told on one foot
};
FittingModel modelFor(const Measurements& measurements, const ModelFile& model);

} // namespace naocal

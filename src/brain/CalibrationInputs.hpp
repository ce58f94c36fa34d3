#pragma once

#include "data/Capture.hpp"
#include "estimation/ModelFile.hpp"
#include "measurements/Measurements.hpp"

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace naocal {

/// The content of a pose file to play; validated when it is played.
struct RequestedPoses {
  std::string content;
  std::vector<SupportFoot> feet; // support feet of its poses, left before right; empty: no pose stands on one foot
};
void from_json(const nlohmann::json& json, RequestedPoses& poses);

/// The boards on the floor, in the format of a capture set.
struct CalibrationBoards {
  std::vector<Board> boards;
};
/// Throws InputError that names the wrong entry and the problem.
void from_json(const nlohmann::json& json, CalibrationBoards& boards);

/// A kind of calibration that can be started.
struct CalibrationKind {
  std::string run;               // value of the parameter `run` that starts it
  std::string title, sentence;   // for display
  std::vector<SupportFoot> feet; // support feet, one stance each: both feet at once, or one foot
};
void to_json(nlohmann::json& out, const CalibrationKind& kind);

/// All kinds, in display order.
const std::vector<CalibrationKind>& calibrationKinds();

/// nullptr if no kind has this name.
const CalibrationKind* findCalibrationKind(std::string_view run);

/// Reads the effects that a calibration on the robot estimates in addition to offsets and mounts: models/V6.json (or
/// another robot model) in the configuration's folder, a model file as written by `naocal`. Throws InputError.
ModelFile loadCalibrationModel(const std::filesystem::path& configuration, const Robot& drawing);

/// Reduces a model to the effects that the captures can determine: leaves out effects of the other leg and those whose
/// drivers were not recorded. Leaves out all effects if the robot stood on both feet, because joint loads are then
/// unknown.
struct ReducedModel {
  ModelFile model;
  std::vector<std::string> leftOut; // "with E@P", "without E@P"; empty on both feet
};
ReducedModel reduceModel(const Measurements& measurements, const ModelFile& model);

} // namespace naocal

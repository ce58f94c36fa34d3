#pragma once

#include "data/Capture.hpp"
#include "estimation/ModelFile.hpp"
#include "measurements/Measurements.hpp"

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace naocal {

/// Poses that a person asks a robot to take: a pose file's content. What is in it is checked when it is played.
struct RequestedPoses {
  std::string content;
  std::vector<SupportFoot> feet; // that its poses stand on, left before right; none: it has no poses on one foot
};
void from_json(const nlohmann::json& json, RequestedPoses& poses);

/// The boards on the floor, as a capture set describes them.
struct CalibrationBoards {
  std::vector<Board> boards;
};
/// Throws InputError that says which entry is wrong and how.
void from_json(const nlohmann::json& json, CalibrationBoards& boards);

/// What can be calibrated at once.
struct CalibrationKind {
  std::string run;               // the value of the parameter `run` that starts it
  std::string title, sentence;   // for people
  std::vector<SupportFoot> feet; // that the robot stands on, one after the other: both at once, or one foot
};
void to_json(nlohmann::json& out, const CalibrationKind& kind);

/// In the order to offer them.
const std::vector<CalibrationKind>& calibrationKinds();

/// nullptr: there is none of that name.
const CalibrationKind* findCalibrationKind(std::string_view run);

/// What a calibration on the robot estimates beside offsets and mounts: models/V6.json (and so on) in the
/// configuration's folder, a model file as the laptop's tools write it. Throws InputError.
ModelFile loadCalibrationModel(const std::filesystem::path& configuration, const Robot& drawing);

/// A model without what captures know nothing of: the other leg's effects, those whose drivers were not recorded; none
/// of its effects where the robot stood on both feet, for there the loads of the joints are not known.
struct ReducedModel {
  ModelFile model;
  std::vector<std::string> leftOut; // "with E@P", "without E@P" of what could have been told on one foot
};
ReducedModel reduceModel(const Measurements& measurements, const ModelFile& model);

} // namespace naocal

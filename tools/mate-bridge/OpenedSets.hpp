#pragma once

#include "calibrate/ResultFile.hpp"
#include "captures/Capture.hpp"
#include "model/Robot.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace naocal {

/// What a person opened: capture sets, and the model to begin with.
struct OpenedSets {
  std::vector<CaptureSet> sets;
  ResultInputs inputs;
  std::map<std::string, std::filesystem::path> folders; // by the set's name
  Robot robot;
  std::vector<std::string> terms; // of the result that was opened; empty for capture sets: the base model
  std::string definitions = "[]"; // the person's own effects: a list of JSON
};

/// Opens folders with captures.json, or one RESULT.json together with the sets that it was made from (as they are
/// written there, or beside it). Throws InputError that names file, what was expected and found.
OpenedSets openSets(const std::vector<std::string>& paths);

} // namespace naocal

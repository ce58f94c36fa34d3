#pragma once

#include "calibration/ResultFile.hpp"
#include "data/Capture.hpp"
#include "robot/Robot.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace naocal {

/// Capture sets as a command was given them.
struct GivenSets {
  std::vector<CaptureSet> sets;
  ResultInputs inputs;
  Robot robot; // the drawing of the sets' model
};

/// Reads the sets; captures that were left out (`skipBad`) are told on standard error.
GivenSets readSets(const std::vector<std::string>& folders, bool skipBad);

/// Writes JSON to a file, or to standard output for "-". Throws InputError for a file that holds another format.
void writeJson(const nlohmann::json& json, const std::string& file);

} // namespace naocal

#pragma once

#include "runs/Run.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace naocal {

/// RUN.json (`naocal-run`): one run; angles in radians, times in UTC.
nlohmann::json runJson(const Run& run);

/// Parses it; `id` becomes the run's id, and `name` stands for the file in messages. Throws InputError with file,
/// place, expected and found.
Run parseRun(const nlohmann::json& document, const std::string& id, const std::string& name);

/// Whether a text can be a run's id: 1 to 120 letters, digits, ".", "-" and "_", and no "." first.
bool isRunId(const std::string& text);

/// The joint offsets of a RESULT.json that its captures determine (learned >= 0.5): the encoder's zero, averaged over
/// what may be missing where the result says so, with sigma and degrees of freedom. Throws InputError.
std::map<std::string, RunOffset> offsetsOfResult(const nlohmann::json& result, const std::string& name);

} // namespace naocal

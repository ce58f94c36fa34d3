#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// Consequence of a problem: the set, or a capture, is refused; results are doubtful; nothing, but worth knowing.
enum class Severity { refused, doubtful, remark };

/// File value of a severity.
std::string_view toString(Severity severity);

/// A problem of a capture set.
struct SetProblem {
  Severity severity = Severity::remark;
  std::string kind;     // "refused", "unknown-key", "degrees", ...; stable, for files
  std::string sentence; // place, what was found, what to do
};

struct CaptureSetCheck {
  std::size_t captures = 0, poses = 0; // in the file; different poses among the captures that can be read
  std::vector<SetProblem> problems;    // by severity, then by subject and place
};

/// Called with the number of pictures looked at and the total; false stops looking at pictures.
using CheckProgress = std::function<bool(std::size_t done, std::size_t all)>;

/// Lists all problems of the set in a folder: everything that reading refuses (surveyCaptureSet), the first refusal of
/// a calibration (buildMeasurements) if reading refuses nothing, and what is valid but doubtful. Pictures are decoded.
/// Throws InputError if the file cannot be read, is no JSON, or has another format.
CaptureSetCheck checkCaptureSet(const std::filesystem::path& folder, const CheckProgress& progress = {});

} // namespace naocal

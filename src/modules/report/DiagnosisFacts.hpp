#pragma once

#include "calibration/ReadingErrors.hpp"
#include "io/JsonReader.hpp"
#include "report/ResultFacts.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// All verdicts, as diagnosis files name them.
const std::vector<std::string_view>& verdicts();

/// Whether what is suggested may be chance, so that further poses come first.
bool isTentative(const JsonCursor& diagnosis);

/// Level of the first finding: "stop", "act" or "note"; empty in files of earlier versions.
std::string verdictLevel(const JsonCursor& diagnosis);

/// The verdict as a headline.
std::string verdictHeadline(const JsonCursor& diagnosis);

/// Name of the noise floor: with joint scatter if the last model needs it.
std::string noiseFloorName(const JsonCursor& diagnosis);

/// The figures behind the verdict, the most important first: held-out error, bound at the task, evidence of what is
/// suggested, false-alarm probability, lack of fit, scatter.
std::vector<Fact> diagnosisFacts(const JsonCursor& diagnosis, const ErrorUnit& errors);

} // namespace naocal

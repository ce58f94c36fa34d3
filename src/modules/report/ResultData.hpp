#pragma once

#include "io/JsonReader.hpp"
#include "report/SourceCaptures.hpp"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// A result's estimates grouped by effect and unit, so that each group shares an axis. [{"title": "joint offset",
/// "unit": "°", "rows": [{"name": "LKneePitch", "value", "sigma", "low", "high", "learned"}]}] with the standard error
/// and the ends of the 95 % interval.
nlohmann::json estimatesData(const JsonCursor& effects);

/// Data of a result page, in display units (degrees, millimetres, pixels).
nlohmann::json resultData(const JsonCursor& result, const SourceCaptures& sources);

/// Rounds to a number of decimals.
double roundToDecimals(double value, int decimals);

/// An image's corners for figures [px]: per board `measured` (u, v of all corners in sequence), the prediction error
/// with joint readings as they are (`reported`) and with readings adjusted within their noise (`fitted`), and, if some
/// corners are downweighted, each weight (`weight`).
nlohmann::json pictureJson(const PictureRecord& seen);

/// A figure and the sentence that explains it.
struct Fact {
  std::string figure, sentence;
};

/// The library's verdict, split into "Usable, but a cause is missing." and the rest, "The error is ...".
struct VerdictWords {
  std::string headline, sentence;
};
VerdictWords verdictWords(const JsonCursor& result);

/// Key figures of a result with explanations. `pictures`: number of images with corners; `drawingRms`: error of the
/// same corners with the drawing alone [px].
std::vector<Fact> facts(const JsonCursor& result, std::size_t pictures, std::optional<double> drawingRms);

} // namespace naocal

#pragma once

#include "io/JsonReader.hpp"
#include "report/SourceCaptures.hpp"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// A result's estimates by effect and unit: what can share an axis stands together. [{"title": "joint offset",
/// "unit": "°", "rows": [{"name": "LKneePitch", "value", "sigma", "low", "high", "learned"}]}] with the standard error
/// and the ends of the 95 % interval.
nlohmann::json estimatesData(const JsonCursor& effects);

/// What the page's figures show, in the units that they show it in (degrees, millimetres, pixels).
nlohmann::json resultData(const JsonCursor& result, const SourceCaptures& sources);

/// A number with as many decimals as a figure can show.
double roundToDecimals(double value, int decimals);

/// A picture's corners as figures show them [px]: per board `measured` (u, v of one corner after the other), how far
/// off they are predicted with the joints' readings as they are (`reported`) and with these moved as far as their
/// noise allows (`fitted`), and, where some count less, how far each counts (`weight`).
nlohmann::json pictureJson(const PictureRecord& seen);

/// A number to remember and the sentence that says what it means.
struct Fact {
  std::string figure, sentence;
};

/// The verdict as the library said it: "Usable, but a cause is missing." and what follows, "The error is ...".
struct VerdictWords {
  std::string headline, sentence;
};
VerdictWords verdictWords(const JsonCursor& result);

/// What a result is worth, in plain words. `pictures`: how many show corners; `drawingRms`: of the same
/// corners with the drawing alone [px].
std::vector<Fact> facts(const JsonCursor& result, std::size_t pictures, std::optional<double> drawingRms);

} // namespace naocal

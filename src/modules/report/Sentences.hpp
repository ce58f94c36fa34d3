#pragma once

#include "io/JsonReader.hpp"

#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// A number to remember and the sentence that says what it means.
struct Fact {
  std::string figure, sentence;
};

/// The verdict as the library said it: "Usable, but a cause is missing." and what follows, "The error is ...".
struct VerdictWords {
  std::string headline, sentence;
};
VerdictWords verdictWords(const JsonPlace& result);

/// What a result is worth, in plain words. `pictures`: how many show corners; `drawingRms`: of the same
/// corners with the drawing alone [px].
std::vector<Fact> facts(const JsonPlace& result, std::size_t pictures, std::optional<double> drawingRms);

} // namespace naocal

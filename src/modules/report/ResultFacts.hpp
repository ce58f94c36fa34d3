#pragma once

#include "calibration/ReadingErrors.hpp"
#include "io/JsonReader.hpp"

#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// A figure and the sentence that explains it.
struct Fact {
  std::string figure, sentence;
};

/// The library's verdict, split into "Usable, but a cause is missing." and the rest, "The error is ...".
struct VerdictWords {
  std::string headline, sentence;
};
VerdictWords verdictWords(const JsonCursor& result);

/// The bound carried to the task, beside its tolerance; absent without a task.
std::optional<Fact> taskFact(const JsonCursor& document);

/// Errors of a result's captures with the drawing alone, where the captures are still there.
struct DrawingErrors {
  double rmsPx = 0; // of corners [px]; 0 without any
  ReadingErrors readings;
};

/// Key figures of a result with explanations: every kind of measurement that it has, in its own unit. `pictures`:
/// number of images with corners; `drawing`: errors of the same captures with the drawing alone.
std::vector<Fact> facts(const JsonCursor& result, std::size_t pictures, const std::optional<DrawingErrors>& drawing);

} // namespace naocal

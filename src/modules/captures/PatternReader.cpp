#include "captures/PatternReader.hpp"

#include "captures/CaptureWords.hpp"
#include "captures/MarkerDictionary.hpp"

#include <fmt/format.h>

namespace naocal {
namespace {

/// A sheet has a marker in every white square.
int markers(const CharucoPattern& pattern) {
  return pattern.squaresX * pattern.squaresY / 2;
}

void requirePrintable(const CharucoPattern& pattern, const JsonPlace& place) {
  const auto available = markerCount(pattern.dictionary);
  if (!available) {
    place.at("dictionary").refuse("the name of one of OpenCV's predefined dictionaries, such as DICT_4X4_100");
  }
  if (pattern.markerLength >= pattern.squareLength) {
    place.refuse("a markerLength below the squareLength",
                 fmt::format("{} and {} m", pattern.markerLength, pattern.squareLength));
  }
  if (pattern.firstMarkerId + markers(pattern) > *available) {
    place.refuse(fmt::format("marker ids below {}, as many as {} has", *available, pattern.dictionary),
                 fmt::format("{} markers from firstMarkerId {} on", markers(pattern), pattern.firstMarkerId));
  }
}

} // namespace

CharucoPattern readPattern(const JsonPlace& place) {
  CharucoPattern pattern;
  const auto read = [&](const char* key, auto& value, auto reading) {
    if (const auto given = place.find(key)) {
      value = reading(*given);
    }
  };
  const auto squares = [](const JsonPlace& given) { return given.integer(2, 100); };
  const auto length = [](const JsonPlace& given) { return given.number(positiveLengthRange); };
  read("dictionary", pattern.dictionary, [](const JsonPlace& given) { return given.text(); });
  read("squaresX", pattern.squaresX, squares);
  read("squaresY", pattern.squaresY, squares);
  read("squareLength", pattern.squareLength, length);
  read("markerLength", pattern.markerLength, length);
  read("firstMarkerId", pattern.firstMarkerId, [](const JsonPlace& given) { return given.integer(0, 100000); });
  read("legacyPattern", pattern.legacyPattern, [](const JsonPlace& given) { return given.boolean(); });
  requirePrintable(pattern, place);
  return pattern;
}

void requireDistinctMarkers(const std::vector<Board>& boards, const JsonPlace& place) {
  for (std::size_t i = 0; i < boards.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const auto &one = boards[k].pattern, &other = boards[i].pattern;
      if (one && other && one->dictionary == other->dictionary &&
          one->firstMarkerId < other->firstMarkerId + markers(*other) &&
          other->firstMarkerId < one->firstMarkerId + markers(*one)) {
        place.elements()[i].refuse(
            fmt::format("markers of {} that no other board has (see firstMarkerId)", one->dictionary),
            fmt::format("ids {} to {}, some of them also on board \"{}\"", other->firstMarkerId,
                        other->firstMarkerId + markers(*other) - 1, boards[k].id));
      }
    }
  }
}

} // namespace naocal

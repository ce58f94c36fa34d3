#include "data/BoardFile.hpp"

#include "data/Board.hpp"
#include "data/CaptureSetFile.hpp"
#include "io/JsonWriter.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

/// Required keys of a placement; a single mark has no orientation.
enum class Required { all, position, none };

Placement readPlacement(const JsonCursor& place, bool onFloor, Required required, Range lengths, Range angles) {
  Placement placement;
  for (const PlacementKey& key : placementKeys) {
    const auto number = place.find(key.key);
    if (onFloor && !key.onFloor) {
      if (number && number->number({-1e6, 1e6, ""}) != 0) {
        number->refuse("no such key or 0, as a placement on the floor has x, y and yaw only");
      }
    } else if (number) {
      placement.*key.value = number->number(key.isAngle ? angles : lengths);
    } else if (required == Required::all || (required == Required::position && !key.isAngle)) {
      place.at(key.key);
    }
  }
  return placement;
}

std::vector<Eigen::Vector3d> readPoints(const JsonCursor& place, const JsonCursor& board) {
  for (const char* key :
       {"dictionary", "squaresX", "squaresY", "squareLength", "markerLength", "firstMarkerId", "legacyPattern"}) {
    if (board.find(key)) {
      board.refuse("either `points` or the keys of a ChArUco board", fmt::format("`points` and `{}`", key));
    }
  }
  std::vector<Eigen::Vector3d> points;
  for (const JsonCursor& point : place.elements()) {
    const auto xyz = point.numbers(3, lengthRange, "x, y, z");
    points.emplace_back(xyz[0], xyz[1], xyz[2]);
  }
  if (points.empty()) {
    place.refuse("at least one point [x, y, z]");
  }
  return points;
}

std::string readLink(const JsonCursor& place) {
  std::string link = place.text();
  const bool isName = std::all_of(link.begin(), link.end(), [](unsigned char c) { return std::isgraph(c) != 0; });
  if (!isName) {
    place.refuse("\"floor\", \"world\" or the name of a link, such as LSole or tool0");
  }
  return link;
}

/// Number of markers of a sheet: one per white square.
int markers(const CharucoPattern& pattern) {
  return pattern.squaresX * pattern.squaresY / 2;
}

void requirePrintable(const CharucoPattern& pattern, const JsonCursor& place) {
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

/// Reads the ChArUco keys of a board; absent keys keep the defaults of CharucoPattern. Refuses unprintable patterns.
CharucoPattern readPattern(const JsonCursor& place) {
  CharucoPattern pattern;
  const auto read = [&](const char* key, auto& value, auto reading) {
    if (const auto given = place.find(key)) {
      value = reading(*given);
    }
  };
  const auto squares = [](const JsonCursor& given) { return given.integer(2, 100); };
  const auto length = [](const JsonCursor& given) { return given.number(positiveLengthRange); };
  read("dictionary", pattern.dictionary, [](const JsonCursor& given) { return given.text(); });
  read("squaresX", pattern.squaresX, squares);
  read("squaresY", pattern.squaresY, squares);
  read("squareLength", pattern.squareLength, length);
  read("markerLength", pattern.markerLength, length);
  read("firstMarkerId", pattern.firstMarkerId, [](const JsonCursor& given) { return given.integer(0, 100000); });
  read("legacyPattern", pattern.legacyPattern, [](const JsonCursor& given) { return given.boolean(); });
  requirePrintable(pattern, place);
  return pattern;
}

using nlohmann::json;
using Written = nlohmann::ordered_json;

/// `zeros`: keys of value 0 are written, too.
Written placementJson(const Placement& placement, bool onFloor, const json& read, bool zeros = true) {
  auto known = Written::object(); // null, which turns into an object, crashes where memory is exhausted
  for (const PlacementKey& key : placementKeys) {
    const double value = placement.*key.value;
    const bool isWritten = (key.onFloor || !onFloor) && (zeros || value != 0);
    known[key.key] = isWritten ? Written(value) : Written();
  }
  return mergeUnknownKeys(known, read);
}

} // namespace

Placement readFloorPlacement(const JsonCursor& place) {
  return readPlacement(place, true, Required::all, lengthRange, angleRange);
}

Placement readSparsePlacement(const JsonCursor& place) {
  return readPlacement(place, false, Required::none, lengthRange, angleRange);
}

Placement readSigma(const JsonCursor& place, bool onFloor) {
  if (!place.value().is_number()) {
    return readPlacement(place, onFloor, Required::none, positiveLengthRange, positiveAngleRange);
  }
  const double sigma = place.number(positiveLengthRange);
  return {.x = sigma, .y = sigma, .z = onFloor ? 0 : sigma};
}

Board readBoard(const JsonCursor& place) {
  Board board;
  board.id = place.at("id").text();
  if (const auto link = place.find("link")) {
    board.link = readLink(*link);
  }
  if (const auto points = place.find("points")) {
    board.points = readPoints(*points, place);
  } else {
    board.pattern = readPattern(place);
    board.points = innerCorners(*board.pattern);
  }
  const bool onFloor = board.link == "floor";
  if (const auto placement = place.find("placement")) {
    const auto required = board.points.size() == 1 ? Required::position : Required::all;
    board.placement = readPlacement(*placement, onFloor, required, lengthRange, angleRange);
  }
  if (const auto guess = place.find("placementGuess")) {
    board.placementGuess = readPlacement(*guess, onFloor, Required::none, lengthRange, angleRange);
    board.hasGuess = true;
  }
  if (const auto sigma = place.find("placementSigma")) {
    board.placementSigma = readSigma(*sigma, onFloor);
  }
  return board;
}

void requireDistinctMarkers(const std::vector<Board>& boards, const JsonCursor& place) {
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

nlohmann::ordered_json toJson(const Placement& placement, bool onFloor, const nlohmann::json& read) {
  return placementJson(placement, onFloor, read);
}

nlohmann::ordered_json sigmaJson(const Placement& sigma, bool onFloor, const nlohmann::json& read) {
  const bool isNumber = sigma.x > 0 && sigma.x == sigma.y && (onFloor || sigma.x == sigma.z) && sigma.roll == 0 &&
                        sigma.pitch == 0 && sigma.yaw == 0 && !read.is_object();
  return isNumber ? Written(sigma.x) : placementJson(sigma, onFloor, read, false);
}

nlohmann::ordered_json toJson(const Board& board, const nlohmann::json& read) {
  const bool onFloor = board.link == "floor";
  Written known{{"id", board.id}, {"link", board.link}};
  const CharucoPattern pattern = board.pattern.value_or(CharucoPattern{});
  const auto ofPattern = [&](auto value) { return board.pattern ? Written(value) : Written(); };
  known["dictionary"] = ofPattern(pattern.dictionary);
  known["squaresX"] = ofPattern(pattern.squaresX);
  known["squaresY"] = ofPattern(pattern.squaresY);
  known["squareLength"] = ofPattern(pattern.squareLength);
  known["markerLength"] = ofPattern(pattern.markerLength);
  known["firstMarkerId"] = ofPattern(pattern.firstMarkerId);
  known["legacyPattern"] = ofPattern(pattern.legacyPattern);
  known["points"] = board.pattern ? Written() : Written::array();
  if (!board.pattern) {
    for (const Eigen::Vector3d& point : board.points) {
      known["points"].push_back({point.x(), point.y(), point.z()});
    }
  }
  const auto placement = [&](const char* key, const std::optional<Placement>& given) {
    known[key] = given ? placementJson(*given, onFloor, childOrNull(read, key)) : Written();
  };
  placement("placement", board.placement);
  placement("placementGuess", board.hasGuess ? std::optional{board.placementGuess} : std::nullopt);
  known["placementSigma"] =
      board.placementSigma ? sigmaJson(*board.placementSigma, onFloor, childOrNull(read, "placementSigma")) : Written();
  return mergeUnknownKeys(known, read);
}

} // namespace naocal

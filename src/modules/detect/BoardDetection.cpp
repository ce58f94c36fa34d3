#include "detect/BoardDetection.hpp"

#include "detect/BoardLayout.hpp"
#include "detect/BoardSearch.hpp"
#include "detect/MarkerAgreement.hpp"
#include "detect/PrintCheck.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>

namespace naocal {
namespace {

constexpr std::size_t fewestCorners = 6;       // fewer cannot check each other
constexpr std::size_t fewestForHomography = 4; // of a board that has no more
constexpr double leastLikeness = 0.55;         // 0.7 at the limit of sight, below 0.5 where half the markers are others

/// Whether too few of the markers that were read agree with the board's description.
bool contradicted(std::size_t agreeing, std::size_t read) {
  return read >= 3 && 2 * agreeing < read;
}

class BoardDetection {
public:
  BoardDetection(const Board& board, const SmoothPicture& picture, const Lens& lens, Detection& detection)
      : board_{board}, pattern_{*board.pattern}, picture_{picture}, lens_{lens}, detection_{detection} {}

  /// `markers`: the board's own.
  void run(const std::vector<Marker>& markers) {
    if (markers.empty()) {
      return;
    }
    CharucoPattern other = pattern_;
    other.legacyPattern = !pattern_.legacyPattern;
    const auto asStated = search(markers, pattern_);
    const auto asOther = pattern_.squaresY % 2 == 0 ? search(markers, other) : std::nullopt;
    if (asOther && (!asStated || asOther->likeness > asStated->likeness)) {
      add(FindingKind::wrongPattern,
          fmt::format("board {} is printed in the {} pattern for even row counts: set its \"legacyPattern\" to {}",
                      board_.id, other.legacyPattern ? "legacy (OpenCV before 4.6)" : "current (OpenCV 4.6 and later)",
                      other.legacyPattern));
    } else if (asStated) {
      report(asStated->board);
    } else {
      reportNothing(markers);
    }
  }

private:
  struct Candidate {
    BoardSearchResult board;
    double likeness = 0; // of the markers' print
  };

  std::size_t enough() const {
    return std::clamp(std::size_t(cornerCount(pattern_)), fewestForHomography, fewestCorners);
  }

  /// The board's corners if it is printed in `pattern` and enough of it is seen.
  std::optional<Candidate> search(std::vector<Marker> markers, const CharucoPattern& pattern) const {
    const std::size_t read = markers.size();
    // A marker misread in the floor's texture may come first; the board itself is among the others then.
    while (!markers.empty()) {
      const MarkerAgreement agreement = markerAgreement(markers, pattern, lens_);
      if (agreement.agreeing.empty() || contradicted(agreement.agreeing.size(), read)) {
        break;
      }
      const BoardSearchResult board = boardSearch(picture_, lens_, pattern, agreement.corners);
      if (board.corners.size() >= enough()) {
        const double likeness = printLikeness(picture_, lens_, pattern, board.corners);
        if (likeness >= leastLikeness) {
          return Candidate{board, likeness};
        }
      }
      markers = agreement.others;
    }
    return std::nullopt;
  }

  void reportNothing(const std::vector<Marker>& markers) {
    const std::size_t agreeing = markerAgreement(markers, pattern_, lens_).agreeing.size();
    if (contradicted(agreeing, markers.size())) {
      add(FindingKind::otherBoard,
          fmt::format("board {}: its markers do not lie as on a board of {} x {} squares of {} m with markers of {} m; "
                      "check what is printed",
                      board_.id, pattern_.squaresX, pattern_.squaresY, pattern_.squareLength, pattern_.markerLength));
    } else {
      add(FindingKind::tooFewCorners,
          fmt::format("board {}: {} of its markers were read, but fewer than {} corners could be confirmed", board_.id,
                      markers.size(), enough()));
    }
  }

  void report(const BoardSearchResult& result) {
    BoardCorners corners{board_.id, {}, {}};
    for (const auto& [id, place] : result.corners) {
      corners.ids.push_back(id);
      corners.uv.push_back(place);
    }
    detection_.boards.push_back(corners);
    for (const RefusedCorner& refused : result.refused) {
      detection_.findings.push_back({refused.seen ? FindingKind::falseCorner : FindingKind::hiddenCorner,
                                     fmt::format("board {}, corner {} at ({:.1f}, {:.1f}): {}", board_.id, refused.id,
                                                 refused.place.x(), refused.place.y(), refused.reason),
                                     board_.id, refused.id, refused.place});
    }
  }

  void add(FindingKind kind, const std::string& sentence) {
    detection_.findings.push_back({kind, sentence, board_.id});
  }

  const Board& board_;
  const CharucoPattern& pattern_;
  const SmoothPicture& picture_;
  const Lens& lens_;
  Detection& detection_;
};

} // namespace

void detectBoard(const Board& board, const std::vector<Marker>& markers, const SmoothPicture& picture, const Lens& lens,
                 Detection& detection) {
  BoardDetection{board, picture, lens, detection}.run(markers);
}

} // namespace naocal

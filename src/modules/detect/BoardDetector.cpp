#include "detect/BoardDetector.hpp"

#include "data/Board.hpp"
#include "data/CaptureSetFile.hpp"
#include "detect/BoardSearch.hpp"
#include "detect/CornerRefinement.hpp"
#include "detect/LensDistortion.hpp"
#include "detect/MarkerDetector.hpp"
#include "detect/PrintCheck.hpp"
#include "io/GreyImage.hpp"
#include "io/InputError.hpp"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <mutex>
#include <opencv2/core/utility.hpp>
#include <optional>
#include <set>
#include <thread>
#include <vector>

namespace naocal {

namespace {

constexpr std::size_t fewestCorners = 6; // required corners; fewer cannot check each other

constexpr std::size_t fewestForHomography = 4; // for boards with fewer corners

constexpr double leastLikeness = 0.55; // correlation; 0.7 at the limit of visibility, below 0.5 with half wrong markers

/// Whether at least three markers were read and fewer than half of them agree with the board's description.
bool isContradicted(std::size_t agreeing, std::size_t read) {
  return read >= 3 && 2 * agreeing < read;
}

class BoardDetection {
public:
  BoardDetection(const Board& board, const SmoothImage& picture, const LensDistortion& lens, Detection& detection)
      : board_{board}, pattern_{*board.pattern}, picture_{picture}, lens_{lens}, detection_{detection} {}

  /// `markers`: those of this board.
  void run(const std::vector<Marker>& markers) {
    if (markers.empty()) {
      return;
    }
    CharucoPattern other = pattern_;
    other.legacyPattern = !pattern_.legacyPattern;
    const auto asStated = search(markers, pattern_);
    const auto asOther = pattern_.squaresY % 2 == 0 ? search(markers, other) : std::nullopt;
    if (asOther && (!asStated || asOther->explainsBetterThan(*asStated))) {
      add(IssueKind::wrongPattern,
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
    std::size_t agreeing = 0; // markers that lie as in this layout
    double likeness = 0;      // correlation with the markers' print

    /// By markers first: with an odd number of columns the other layout, one column aside, has all markers at their
    /// places but those at the rows' ends, and its print looks alike.
    bool explainsBetterThan(const Candidate& other) const {
      return agreeing != other.agreeing ? agreeing > other.agreeing : likeness > other.likeness;
    }
  };

  std::size_t requiredCorners() const {
    return std::clamp(std::size_t(cornerCount(pattern_)), fewestForHomography, fewestCorners);
  }

  /// Searches the board in layout `pattern`; absent if too little of it is visible.
  std::optional<Candidate> search(std::vector<Marker> markers, const CharucoPattern& pattern) const {
    const std::size_t read = markers.size();
    // A marker misread in the floor texture may come first; the board is then found among the others.
    while (!markers.empty()) {
      const MarkerAgreement agreement = findAgreeingMarkers(markers, pattern, lens_);
      if (agreement.agreeing.empty() || isContradicted(agreement.agreeing.size(), read)) {
        break;
      }
      const BoardSearchResult board = searchBoard(picture_, lens_, pattern, agreement.corners);
      if (board.corners.size() >= requiredCorners()) {
        const double likeness = printCorrelation(picture_, lens_, pattern, board.corners);
        if (likeness >= leastLikeness) {
          return Candidate{board, agreement.agreeing.size(), likeness};
        }
      }
      markers = agreement.others;
    }
    return std::nullopt;
  }

  void reportNothing(const std::vector<Marker>& markers) {
    const std::size_t agreeing = findAgreeingMarkers(markers, pattern_, lens_).agreeing.size();
    if (isContradicted(agreeing, markers.size())) {
      add(IssueKind::otherBoard,
          fmt::format("board {}: its markers do not lie as on a board of {} x {} squares of {} m with markers of {} m; "
                      "check what is printed",
                      board_.id, pattern_.squaresX, pattern_.squaresY, pattern_.squareLength, pattern_.markerLength));
    } else {
      add(IssueKind::tooFewCorners,
          fmt::format(
              "board {}: only {} marker{} read, fewer than {} corners confirmed; board not used in this picture",
              board_.id, markers.size(), markers.size() == 1 ? "" : "s", requiredCorners()));
    }
  }

  void report(const BoardSearchResult& result) {
    BoardCorners corners{board_.id, {}, {}};
    for (const auto& [id, place] : result.corners) {
      corners.ids.push_back(id);
      corners.uv.push_back(place);
    }
    detection_.boards.push_back(corners);
    for (const RejectedCorner& refused : result.refused) {
      detection_.findings.push_back({refused.seen ? IssueKind::falseCorner : IssueKind::hiddenCorner,
                                     fmt::format("board {}, corner {} at ({:.1f}, {:.1f}): {}", board_.id, refused.id,
                                                 refused.place.x(), refused.place.y(), refused.reason),
                                     board_.id, refused.id, refused.place});
    }
  }

  void add(IssueKind kind, const std::string& sentence) { detection_.findings.push_back({kind, sentence, board_.id}); }

  const Board& board_;
  const CharucoPattern& pattern_;
  const SmoothImage& picture_;
  const LensDistortion& lens_;
  Detection& detection_;
};

/// Adds one board's corners and issues to `detection`. Accepts corners if at least six were found (fewer on a small
/// board), half of the markers read agree with them, and the print beside them matches the pattern. `markers`: those of
/// this board. Requires `board.pattern`.
void detectBoard(const Board& board, const std::vector<Marker>& markers, const SmoothImage& picture,
                 const LensDistortion& lens, Detection& detection) {
  BoardDetection{board, picture, lens, detection}.run(markers);
}

constexpr double smoothing = 0.8; // [px] sigma of the blur before corner refinement

bool isOn(const CharucoPattern& pattern, int id) {
  return id >= pattern.firstMarkerId && id < pattern.firstMarkerId + markerCount(pattern);
}

void reportUnknown(const std::string& dictionary, const std::vector<Marker>& markers, const std::vector<Board>& boards,
                   Detection& detection) {
  std::set<int> unknown;
  for (const Marker& marker : markers) {
    const bool known = std::any_of(boards.begin(), boards.end(), [&](const Board& board) {
      return board.pattern && board.pattern->dictionary == dictionary && isOn(*board.pattern, marker.id);
    });
    if (!known) {
      unknown.insert(marker.id);
    }
  }
  if (!unknown.empty()) {
    detection.findings.push_back(
        {IssueKind::unknownMarkers,
         fmt::format("{} markers that belong to none of the boards: {}", dictionary, fmt::join(unknown, ", "))});
  }
}

/// Result of one picture; empty if it was not reached.
struct Outcome {
  std::optional<Detection> detection;
  std::string unreadable;
};

Outcome detectInCapture(const Capture& capture, const CaptureSet& set, const std::filesystem::path& folder) {
  try {
    const CameraIntrinsics& camera = set.cameras.at(capture.camera);
    const GreyPicture picture = readImage(pictureFile(capture, folder), PictureSize{camera.width, camera.height});
    return {detectBoards(picture, set.boards, camera), {}};
  } catch (const InputError& error) {
    return {std::nullopt, fmt::format("capture {}: {}", capture.id, error.what())};
  }
}

/// Corners to keep: those of targets without a pattern, which cannot be detected.
std::vector<BoardCorners> keepOtherCorners(const Capture& capture, const CaptureSet& set) {
  std::vector<BoardCorners> result;
  for (const BoardCorners& corners : capture.corners.value_or(std::vector<BoardCorners>{})) {
    const auto board = std::find_if(set.boards.begin(), set.boards.end(),
                                    [&](const Board& candidate) { return candidate.id == corners.board; });
    if (board != set.boards.end() && !board->pattern) {
      result.push_back(corners);
    }
  }
  return result;
}

} // namespace

Detection detectBoards(const GreyPicture& picture, const std::vector<Board>& boards,
                       const CameraIntrinsics& intrinsics) {
  Detection detection;
  if (picture.width != intrinsics.width || picture.height != intrinsics.height) {
    detection.findings.push_back(
        {IssueKind::wrongImageSize,
         fmt::format("the picture has {} x {} pixels, but its camera is described with {} x {}", picture.width,
                     picture.height, intrinsics.width, intrinsics.height)});
    return detection;
  }
  const SmoothImage smooth{picture, smoothing};
  const LensDistortion lens{intrinsics};
  std::map<std::string, std::vector<Marker>> markers; // by dictionary
  for (const Board& board : boards) {
    if (board.pattern && !markers.count(board.pattern->dictionary)) {
      markers[board.pattern->dictionary] = detectMarkers(picture, board.pattern->dictionary);
    }
  }
  for (const Board& board : boards) {
    if (board.pattern) {
      std::vector<Marker> own;
      std::copy_if(markers[board.pattern->dictionary].begin(), markers[board.pattern->dictionary].end(),
                   std::back_inserter(own), [&](const Marker& marker) { return isOn(*board.pattern, marker.id); });
      detectBoard(board, own, smooth, lens, detection);
    }
  }
  for (const auto& [dictionary, all] : markers) {
    reportUnknown(dictionary, all, boards, detection);
  }
  return detection;
}

std::string toString(IssueKind kind) {
  switch (kind) {
  case IssueKind::wrongImageSize:
    return "wrong-image-size";
  case IssueKind::wrongPattern:
    return "wrong-pattern";
  case IssueKind::otherBoard:
    return "other-board";
  case IssueKind::tooFewCorners:
    return "too-few-corners";
  case IssueKind::falseCorner:
    return "false-corner";
  case IssueKind::hiddenCorner:
    return "hidden-corner";
  case IssueKind::unknownMarkers:
    return "unknown-markers";
  }
  assert(false);
  return {};
}

SetDetection detectInSet(CaptureSet& set, const std::filesystem::path& folder, unsigned threads,
                         const DetectionProgress& progress) {
  std::vector<std::size_t> withImage;
  for (std::size_t i = 0; i < set.captures.size(); ++i) {
    if (!set.captures[i].image.empty()) {
      withImage.push_back(i);
    }
  }
  cv::setNumThreads(1); // parallel over pictures instead
  std::vector<Outcome> outcomes(withImage.size());
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> goOn = true;
  std::size_t done = 0;
  std::mutex mutex; // guards `done` and `progress`
  const auto work = [&] {
    for (std::size_t i = next++; i < withImage.size() && goOn; i = next++) {
      outcomes[i] = detectInCapture(set.captures[withImage[i]], set, folder);
      const std::lock_guard lock{mutex};
      goOn = progress(++done, withImage.size()) && goOn;
    }
  };
  {
    std::vector<std::jthread> workers;
    for (unsigned i = 0; i < std::max(1u, threads); ++i) {
      workers.emplace_back(work);
    }
  }
  SetDetection result;
  for (std::size_t i = 0; i < withImage.size(); ++i) {
    Capture& capture = set.captures[withImage[i]];
    if (!outcomes[i].unreadable.empty()) {
      result.unreadable.push_back(outcomes[i].unreadable);
      result.unreadableCaptures.push_back(capture.id);
    }
    if (const auto& detection = outcomes[i].detection) {
      ++result.pictures;
      auto corners = keepOtherCorners(capture, set);
      corners.insert(corners.end(), detection->boards.begin(), detection->boards.end());
      capture.corners = corners;
      for (const DetectionIssue& finding : detection->findings) {
        result.findings.push_back({capture.id, finding});
      }
    }
  }
  return result;
}

} // namespace naocal

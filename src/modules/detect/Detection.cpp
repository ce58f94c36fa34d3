#include "detect/Detection.hpp"

#include "detect/BoardDetection.hpp"
#include "detect/BoardLayout.hpp"
#include "detect/Markers.hpp"

#include <algorithm>
#include <cassert>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <set>

namespace naocal {
namespace {

constexpr double smoothing = 0.8; // [px] before corners are fitted

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
        {FindingKind::unknownMarkers,
         fmt::format("{} markers that belong to none of the boards: {}", dictionary, fmt::join(unknown, ", "))});
  }
}

} // namespace

Detection detect(const GreyPicture& picture, const std::vector<Board>& boards, const CameraIntrinsics& intrinsics) {
  Detection detection;
  if (picture.width != intrinsics.width || picture.height != intrinsics.height) {
    detection.findings.push_back(
        {FindingKind::wrongImageSize,
         fmt::format("the picture has {} x {} pixels, but its camera is described with {} x {}", picture.width,
                     picture.height, intrinsics.width, intrinsics.height)});
    return detection;
  }
  const SmoothPicture smooth{picture, smoothing};
  const Lens lens{intrinsics};
  std::map<std::string, std::vector<Marker>> markers; // by dictionary
  for (const Board& board : boards) {
    if (board.pattern && !markers.count(board.pattern->dictionary)) {
      markers[board.pattern->dictionary] = markersIn(picture, board.pattern->dictionary);
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

std::string name(FindingKind kind) {
  switch (kind) {
  case FindingKind::wrongImageSize:
    return "wrong-image-size";
  case FindingKind::wrongPattern:
    return "wrong-pattern";
  case FindingKind::otherBoard:
    return "other-board";
  case FindingKind::tooFewCorners:
    return "too-few-corners";
  case FindingKind::falseCorner:
    return "false-corner";
  case FindingKind::hiddenCorner:
    return "hidden-corner";
  case FindingKind::unknownMarkers:
    return "unknown-markers";
  }
  assert(false);
  return {};
}

} // namespace naocal

#pragma once

#include "data/Capture.hpp"
#include "detect/CornerRefinement.hpp"
#include "detect/LensDistortion.hpp"
#include "detect/MarkerDetector.hpp"

#include <map>
#include <string>
#include <vector>

namespace naocal {

/// An expected corner that was rejected.
struct RejectedCorner {
  int id = 0;
  Eigen::Vector2d place; // [px] detected or else expected position
  bool seen = false;     // a corner was detected, but in the wrong position
  std::string reason;    // "lies 2.3 px from where its neighbours put it"
};

/// Corners of one board, found by region growing from the markers that were read.
struct BoardSearchResult {
  std::map<int, Eigen::Vector2d> corners; // by id [px]
  std::vector<RejectedCorner> refused;
};

/// Region growing from the marker corners: predicts a corner from those around it, refines it, and requires a crossing
/// of four squares with black and white as printed. Finally each corner must lie within 0.3 to 0.7 px (six times the
/// median) of the position predicted by the others; the worst is removed first. Thus distant boards with few readable
/// markers are found completely.
///
/// `markerCorners`: corners of markers that were read and agree with each other.
BoardSearchResult searchBoard(const SmoothImage& picture, const LensDistortion& lens, const CharucoPattern& pattern,
                              const std::vector<PointMatch>& markerCorners);

/// Markers consistent with one flat board, and the others of the same board.
struct MarkerAgreement {
  std::vector<Marker> agreeing, others;
  std::vector<PointMatch> corners; // corners of the agreeing markers
};

/// The largest group of a board's markers that one homography maps onto the pattern, each corner within 3 px or a tenth
/// of its marker's side, whichever is larger. All `markers` must belong to the board.
MarkerAgreement findAgreeingMarkers(const std::vector<Marker>& markers, const CharucoPattern& pattern,
                                    const LensDistortion& lens);

} // namespace naocal

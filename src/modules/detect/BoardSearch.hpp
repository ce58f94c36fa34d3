#pragma once

#include "data/Capture.hpp"
#include "detect/CornerRefinement.hpp"
#include "detect/LensDistortion.hpp"
#include "detect/MarkerDetector.hpp"

#include <map>
#include <string>
#include <vector>

namespace naocal {

/// A corner that should be in the picture and was not taken.
struct RejectedCorner {
  int id = 0;
  Eigen::Vector2d place; // [px] where it was seen, or else should have been
  bool seen = false;     // whether something like a corner is there, but in the wrong place
  std::string reason;    // "lies 2.3 px from where its neighbours put it"
};

/// The corners of one board, found by walking over it from the markers that could be read.
struct BoardSearchResult {
  std::map<int, Eigen::Vector2d> corners; // by id [px]
  std::vector<RejectedCorner> refused;
};

/// Walks from the markers' corners outwards: a corner is predicted from what was found around it, fitted, and must be a
/// crossing of four squares with black and white as printed. At the end each corner must lie within 0.3 to 0.7 px
/// (six times the median) of where the others put it; the worst is taken out first. Thus distant boards, of which few
/// markers can be read, are found whole.
///
/// `markerCorners`: corners of markers that were read and agree with each other.
BoardSearchResult searchBoard(const SmoothImage& picture, const LensDistortion& lens, const CharucoPattern& pattern,
                              const std::vector<PointMatch>& markerCorners);

/// Markers that lie in the picture as one flat board's do, and those of the same board that do not.
struct MarkerAgreement {
  std::vector<Marker> agreeing, others;
  std::vector<PointMatch> corners; // of the agreeing ones
};

/// The largest group of a board's markers that one homography maps onto the pattern, each corner within 3 px (or a
/// tenth of its marker's side). All `markers` must be on the board.
MarkerAgreement findAgreeingMarkers(const std::vector<Marker>& markers, const CharucoPattern& pattern,
                                    const LensDistortion& lens);

} // namespace naocal

#pragma once

#include "data/Capture.hpp"

#include <memory>
#include <vector>

namespace naocal {

/// What is painted on a plane: convex cells of one brightness each, so that an area whose corners lie in one cell is of
/// its brightness throughout. Places beyond the edge belong to cells, too.
class FlatTexture {
public:
  virtual ~FlatTexture() = default;

  /// Which cell a place [m] is in.
  virtual std::size_t cellAt(float x, float y) const = 0;

  /// 0 ink, 1 paper, negative: beyond the edge. From behind all is paper.
  float brightness(std::size_t cell, bool fromBehind) const {
    const float front = brightness_[cell];
    return fromBehind && front >= 0 ? 1 : front;
  }

protected:
  std::vector<float> brightness_; // by cell
};

/// The printed sheet of a ChArUco board; x to the right and y up from the pattern's top left corner.
///
/// The first square of the first row is black; in the legacy pattern with an even number of rows it is white.
/// White squares hold the markers, numbered along rows from the top left, upright and centred.
std::shared_ptr<const FlatTexture> makeBoardTexture(const CharucoPattern& pattern, double margin);

/// One grey, spanning x and y by +-half [m].
std::shared_ptr<const FlatTexture> makePatchTexture(double halfX, double halfY, double brightness);

} // namespace naocal

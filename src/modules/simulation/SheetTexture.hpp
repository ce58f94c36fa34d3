#pragma once

#include "data/Capture.hpp"

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace naocal {

/// Texture of a plane: convex cells of constant brightness, so that an area whose corners lie in one cell has its
/// brightness throughout. The outside is divided into cells as well.
class FlatTexture {
public:
  virtual ~FlatTexture() = default;

  static constexpr std::size_t behindCamera = std::numeric_limits<std::size_t>::max();

  /// Index of the cell at a point [m].
  virtual std::size_t cellAt(float x, float y) const = 0;
  /// The cells that rays, (x, y) at z = 1, see; `behindCamera` where they do not meet the plane. `planeFromRay`: one
  /// for all rays, or one for each.
  virtual void findCells(std::span<const Eigen::Matrix3f> planeFromRay, std::span<const Eigen::Vector2f> rays,
                         std::span<std::size_t> cells) const = 0;
  /// The same of rays along a row of pixels: rays between two that see the same cell see it, too, since a row is next
  /// to straight.
  virtual void findCellsOfRow(const Eigen::Matrix3f& planeFromRay, std::span<const Eigen::Vector2f> rays,
                              std::span<std::size_t> cells) const = 0;

  /// 0 ink, 1 paper, negative: outside. The back is all paper.
  float brightness(std::size_t cell, bool fromBehind) const {
    const float front = brightness_[cell];
    return fromBehind && front >= 0 ? 1 : front;
  }

protected:
  std::vector<float> brightness_; // by cell
};

/// The printed sheet of a ChArUco board; x right, y up from the pattern's top left corner.
///
/// The first square of the first row is black; in the legacy pattern with an even number of rows it is white.
/// White squares hold the markers, numbered along rows from the top left, upright and centred.
std::shared_ptr<const FlatTexture> makeBoardTexture(const CharucoPattern& pattern, double margin);

/// A single grey level within +-half in x and y [m].
std::shared_ptr<const FlatTexture> makePatchTexture(double halfX, double halfY, double brightness);

} // namespace naocal

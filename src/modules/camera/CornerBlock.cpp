#include "camera/CornerBlock.hpp"

namespace naocal {

CornerBlocks packCorners(const Board& board, const BoardCorners& corners) {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double squaredReach = 1;
  if (board.pattern) {
    const CharucoPattern& pattern = *board.pattern;
    centre = {pattern.squaresX * pattern.squareLength / 2, -pattern.squaresY * pattern.squareLength / 2, 0};
    squaredReach = centre.squaredNorm();
  }
  const std::size_t count = corners.ids.size();
  CornerBlocks blocks((count + 3) / 4);
  for (std::size_t i = 0; i < 4 * blocks.size(); ++i) {
    CornerBlock& block = blocks[i / 4];
    const auto lane = static_cast<Eigen::Index>(i % 4);
    const std::size_t corner = i < count ? i : 0;
    const Eigen::Vector3d& point = board.points[static_cast<std::size_t>(corners.ids[corner])];
    block.x[lane] = point.x();
    block.y[lane] = point.y();
    block.z[lane] = point.z();
    block.bulge[lane] = board.pattern ? 1 - (point - centre).squaredNorm() / squaredReach : 0;
    block.u[lane] = corners.uv[corner].x();
    block.v[lane] = corners.uv[corner].y();
    block.present[lane] = i < count ? 1 : 0;
  }
  return blocks;
}

} // namespace naocal

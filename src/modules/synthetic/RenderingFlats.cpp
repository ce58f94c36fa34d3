#include "synthetic/RenderingFlats.hpp"

#include "synthetic/RenderingLens.hpp"
#include "synthetic/RenderingSheet.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <utility>

namespace naocal {
namespace {

/// `lower` and `upper` are opposite corners of its outline in its own frame.
Flat flat(const RigidTransform& opticalFromFlat, const Eigen::Vector2d& lower, const Eigen::Vector2d& upper,
          const CameraIntrinsics& camera, std::function<float(float, float)> brightness) {
  Eigen::Matrix3d rayFromPlane;
  rayFromPlane << opticalFromFlat.rotation.leftCols<2>(), opticalFromFlat.translation;
  Flat result{rayFromPlane.inverse().cast<float>(), std::move(brightness), camera.width, -1, camera.height, -1};
  const bool back = opticalFromFlat.rotation.col(2).dot(opticalFromFlat.translation) > 0;
  if (back) {
    result.brightness = [front = result.brightness](float x, float y) { return front(x, y) < 0 ? -1.f : 1.f; };
  }
  constexpr int steps = 16; // along a side: distortion bends it
  for (int i = 0; i < 4 * steps; ++i) {
    const double share = double(i % steps) / steps;
    const Eigen::Vector2d along[4] = {{share, 0}, {1, share}, {1 - share, 1}, {0, 1 - share}};
    const Eigen::Vector2d p = lower + along[i / steps].cwiseProduct(upper - lower);
    const Eigen::Vector3d seen = opticalFromFlat * Eigen::Vector3d{p.x(), p.y(), 0};
    if (seen.z() < 0.01 || seen.head<2>().norm() > 2 * seen.z()) { // too far aside to tell: look everywhere
      result.left = result.top = 0;
      result.right = camera.width - 1;
      result.bottom = camera.height - 1;
      break;
    }
    const Eigen::Vector2d uv = renderedPixel(seen, camera);
    result.left = std::max(0, std::min(result.left, int(uv.x()) - 3));
    result.right = std::min(camera.width - 1, std::max(result.right, int(uv.x()) + 3));
    result.top = std::max(0, std::min(result.top, int(uv.y()) - 3));
    result.bottom = std::min(camera.height - 1, std::max(result.bottom, int(uv.y()) + 3));
  }
  return result;
}

} // namespace

std::vector<Flat> flats(const RenderedScene& scene, const CameraIntrinsics& camera) {
  std::vector<Flat> result;
  for (const RenderedBoard& board : scene.boards) {
    const Eigen::Vector2d outside{board.margin, board.margin};
    const Eigen::Vector2d size{board.pattern.squaresX * board.pattern.squareLength,
                               board.pattern.squaresY * board.pattern.squareLength};
    const RenderingSheet sheet{board.pattern, board.margin};
    result.push_back(flat(board.cameraOpticalFromBoard, Eigen::Vector2d{0, -size.y()} - outside,
                          Eigen::Vector2d{size.x(), 0} + outside, camera,
                          [sheet](float x, float y) { return sheet.brightness(x, -y); }));
  }
  for (const Patch& patch : scene.patches) {
    const Eigen::Vector2d half = patch.size / 2;
    result.push_back(flat(patch.cameraOpticalFromPatch, -half, half, camera,
                          [half = half.cast<float>().eval(), grey = float(patch.brightness)](float x, float y) {
                            return std::abs(x) <= half.x() && std::abs(y) <= half.y() ? grey : -1.f;
                          }));
  }
  std::reverse(result.begin(), result.end());
  return result;
}

} // namespace naocal

#include "synthetic/RenderingFlats.hpp"

#include "synthetic/RenderingLens.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace naocal {
namespace {

/// A flat thing's opposite corners in its own frame.
struct Outline {
  Eigen::Vector2d lower, upper;
};

/// Adds where a flat thing is at one more instant.
void addInstant(Flat& flat, const RigidTransform& opticalFromFlat, const Outline& outline,
                const CameraIntrinsics& camera) {
  Eigen::Matrix3d rayFromPlane;
  rayFromPlane << opticalFromFlat.rotation.leftCols<2>(), opticalFromFlat.translation;
  flat.planeFromRay.push_back(rayFromPlane.inverse().cast<float>());
  constexpr int steps = 16; // along a side: distortion bends it
  for (int i = 0; i < 4 * steps; ++i) {
    const double share = double(i % steps) / steps;
    const Eigen::Vector2d along[4] = {{share, 0}, {1, share}, {1 - share, 1}, {0, 1 - share}};
    const Eigen::Vector2d p = outline.lower + along[i / steps].cwiseProduct(outline.upper - outline.lower);
    const Eigen::Vector3d seen = opticalFromFlat * Eigen::Vector3d{p.x(), p.y(), 0};
    if (seen.z() < 0.01 || seen.head<2>().norm() > 2 * seen.z()) { // too far aside to tell: look everywhere
      flat.left = flat.top = 0;
      flat.right = camera.width - 1;
      flat.bottom = camera.height - 1;
      break;
    }
    const Eigen::Vector2d uv = renderedPixel(seen, camera);
    flat.left = std::max(0, std::min(flat.left, int(uv.x()) - 3));
    flat.right = std::min(camera.width - 1, std::max(flat.right, int(uv.x()) + 3));
    flat.top = std::max(0, std::min(flat.top, int(uv.y()) - 3));
    flat.bottom = std::min(camera.height - 1, std::max(flat.bottom, int(uv.y()) + 3));
  }
}

bool seenFromBehind(const RigidTransform& opticalFromFlat) {
  return opticalFromFlat.rotation.col(2).dot(opticalFromFlat.translation) > 0;
}

} // namespace

Eigen::Matrix3f Flat::at(float share) const {
  const float place = share * float(planeFromRay.size() - 1);
  const std::size_t before = std::min(std::size_t(place), planeFromRay.size() - 2);
  return planeFromRay[before] + (place - float(before)) * (planeFromRay[before + 1] - planeFromRay[before]);
}

std::vector<Flat> flats(const std::vector<RenderedScene>& scenes, const CameraIntrinsics& camera) {
  const Flat nowhere{nullptr, false, camera.width, -1, camera.height, -1, {}};
  std::vector<Flat> result;
  for (std::size_t i = 0; i < scenes.front().boards.size(); ++i) {
    const RenderedBoard& board = scenes.front().boards[i];
    const Eigen::Vector2d outside{board.margin, board.margin};
    const Eigen::Vector2d size{board.pattern.squaresX * board.pattern.squareLength,
                               board.pattern.squaresY * board.pattern.squareLength};
    const Outline outline{Eigen::Vector2d{0, -size.y()} - outside, Eigen::Vector2d{size.x(), 0} + outside};
    Flat& flat = result.emplace_back(nowhere);
    flat.painting = paintedSheet(board.pattern, board.margin);
    flat.fromBehind = seenFromBehind(board.cameraOpticalFromBoard);
    for (const RenderedScene& scene : scenes) {
      addInstant(flat, scene.boards[i].cameraOpticalFromBoard, outline, camera);
    }
  }
  for (std::size_t i = 0; i < scenes.front().patches.size(); ++i) {
    const Patch& patch = scenes.front().patches[i];
    const Eigen::Vector2d half = patch.size / 2;
    Flat& flat = result.emplace_back(nowhere);
    flat.painting = paintedPatch(half.x(), half.y(), patch.brightness);
    flat.fromBehind = seenFromBehind(patch.cameraOpticalFromPatch);
    for (const RenderedScene& scene : scenes) {
      addInstant(flat, scene.patches[i].cameraOpticalFromPatch, {-half, half}, camera);
    }
  }
  std::reverse(result.begin(), result.end());
  return result;
}

} // namespace naocal

#include "synthetic/Rendering.hpp"

#include "synthetic/RenderingLens.hpp"
#include "synthetic/RenderingRow.hpp"
#include "synthetic/RenderingSensor.hpp"

namespace naocal {
Renderer::Renderer(const CameraIntrinsics& intrinsics, std::optional<std::uint64_t> floorSeed)
    : intrinsics_{intrinsics} {
  rays_.reserve(std::size_t(intrinsics.width + 1) * std::size_t(intrinsics.height + 1));
  for (int y = 0; y <= intrinsics.height; ++y) {
    for (int x = 0; x <= intrinsics.width; ++x) {
      rays_.push_back(renderedRay({x - 0.5, y - 0.5}, intrinsics).cast<float>());
    }
  }
  if (floorSeed) {
    std::mt19937_64 random{*floorSeed};
    blotches_ = blotches(intrinsics.width, intrinsics.height, random);
  }
}

GreyPicture Renderer::picture(const RenderedScene& scene, const Appearance& appearance, std::uint64_t seed) const {
  return picture(std::vector{scene}, 0, appearance, seed);
}

GreyPicture Renderer::picture(const std::vector<RenderedScene>& scenes, double exposureShare,
                              const Appearance& appearance, std::uint64_t seed) const {
  const int width = intrinsics_.width, height = intrinsics_.height;
  std::mt19937_64 random{seed};
  std::vector<float> light = blotches_.empty() ? blotches(width, height, random) : blotches_;
  for (float& floor : light) {
    floor = float(appearance.floorBrightness) + float(appearance.floorTexture) * floor;
  }
  const std::vector<Flat> all = flats(scenes, intrinsics_);
  RenderingRow row{all, rays_, width};
  for (int y = 0; y < height; ++y) {
    const float begin = float(y) / float(height - 1) * float(1 - exposureShare);
    row.paint(y, begin, begin + float(exposureShare), &light[std::size_t(y) * std::size_t(width)]);
  }
  return developed(std::move(light), width, height, appearance, random);
}

std::optional<Eigen::Vector2d> seenAt(const Eigen::Vector3d& pointInCameraOptical, const CameraIntrinsics& intrinsics) {
  if (pointInCameraOptical.z() <= 0) {
    return std::nullopt;
  }
  const Eigen::Vector2d uv = renderedPixel(pointInCameraOptical, intrinsics);
  // Far outside of what the lens was described for, its polynomial folds back into the picture.
  const bool folded = (renderedRay(uv, intrinsics) - pointInCameraOptical.hnormalized()).norm() > 1e-6;
  const bool inside =
      uv.x() >= -0.5 && uv.y() >= -0.5 && uv.x() < intrinsics.width - 0.5 && uv.y() < intrinsics.height - 0.5;
  return inside && !folded ? std::optional{uv} : std::nullopt;
}

BoardCorners trueCorners(const RenderedBoard& board, const CameraIntrinsics& intrinsics) {
  BoardCorners corners{board.id, {}, {}};
  const int perRow = board.pattern.squaresX - 1;
  for (int id = 0; id < perRow * (board.pattern.squaresY - 1); ++id) {
    const Eigen::Vector3d pointInBoard =
        board.pattern.squareLength * Eigen::Vector3d{id % perRow + 1.0, -(id / perRow + 1.0), 0};
    if (const auto uv = seenAt(board.cameraOpticalFromBoard * pointInBoard, intrinsics)) {
      corners.ids.push_back(id);
      corners.uv.push_back(*uv);
    }
  }
  return corners;
}

} // namespace naocal

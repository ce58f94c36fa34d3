#pragma once

#include "data/Capture.hpp"
#include "io/GreyImage.hpp"
#include "math/RigidTransform.hpp"
#include "simulation/SheetTexture.hpp"

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace naocal {

/// A board in front of a camera. Optical frames have OpenCV's axes: x right, y down, z forward.
struct RenderedBoard {
  std::string id;
  CharucoPattern pattern;
  RigidTransform cameraOpticalFromBoard;
  double margin = 0.01; // white paper around the pattern [m]
};

/// A flat patch of one grey level (white on its back): extends +-size/2 along x and y of its frame and covers objects
/// listed before it.
struct Patch {
  RigidTransform cameraOpticalFromPatch;
  Eigen::Vector2d size = {0.1, 0.1}; // [m]
  double brightness = 0;             // 0 as ink, 1 as paper
};

/// Objects in front of the camera. Later ones cover earlier ones, patches cover boards; the background is floor.
struct RenderedScene {
  std::vector<RenderedBoard> boards;
  std::vector<Patch> patches;
};

/// Image formation. Grey = vignetting * (black + (white - black) * brightness), box-averaged over the pixel's area,
/// blurred by a Gaussian, plus noise. The defaults are those of the detection benchmark.
struct Appearance {
  double black = 40, white = 190;                     // of ink and paper [grey level]
  double floorBrightness = 0.45, floorTexture = 0.05; // mean and standard deviation; 0 as ink, 1 as paper
  double blur = 0.7;                                  // sigma [px]
  double noise = 3;                                   // sigma [grey level]
  double vignetting = 0;                              // fraction of light lost in the image corners
  std::optional<int> jpegQuality;                     // 1 .. 100: lossy compression
};

/// Renders a camera's images of scenes; reproducible by seed.
///
/// The rays through all pixel corners are computed once: reuse a renderer for many images. Deliberately independent of
/// the calibration's projection, so that images can test it.
class Renderer {
public:
  /// `floorSeed`: seed of a floor texture common to all images; absent: a new texture per image.
  explicit Renderer(const CameraIntrinsics& intrinsics, std::optional<std::uint64_t> floorSeed = {});

  GreyPicture render(const RenderedScene& scene, const Appearance& appearance, std::uint64_t seed) const;

  /// Renders motion and rolling shutter. `scenes`: at least two instants, evenly spaced from the start of the first
  /// row's exposure to the end of the last row's, all with the same objects. `exposureShare`: exposure time of one row
  /// as a fraction of that span.
  GreyPicture render(const std::vector<RenderedScene>& scenes, double exposureShare, const Appearance& appearance,
                     std::uint64_t seed) const;

  const CameraIntrinsics& intrinsics() const { return intrinsics_; }

private:
  CameraIntrinsics intrinsics_;
  std::vector<Eigen::Vector2f> rays_; // (x, y) at z = 1 through the (width+1) x (height+1) pixel corners
  std::vector<float> blotches_;       // floor texture per pixel; empty: a new one per image
};

/// Projection of a point [px]; absent behind the camera or outside the image.
std::optional<Eigen::Vector2d> projectOptical(const Eigen::Vector3d& pointInCameraOptical,
                                              const CameraIntrinsics& intrinsics);

/// True positions of a board's inner corners inside the image, covered or not.
BoardCorners trueCorners(const RenderedBoard& board, const CameraIntrinsics& intrinsics);

/// A flat object prepared for rendering: texture, bounding box in the image, and ray-plane intersection.
struct FlatObject {
  std::shared_ptr<const FlatTexture> painting;
  bool fromBehind = false;                   // at the first instant
  int left, right, top, bottom;              // [px], inclusive, over all instants
  std::vector<Eigen::Matrix3f> planeFromRay; // by instant: (x, y, 1) / distance = planeFromRay * ray

  /// Interpolated at a fraction of the span between the first and the last instant.
  Eigen::Matrix3f at(float share) const;
};

/// All flat objects of a scene at several instants, front ones first.
std::vector<FlatObject> prepareFlats(const std::vector<RenderedScene>& scenes, const CameraIntrinsics& camera);

/// The point at z = 1 seen at a pixel, and the pixel of a point in front of the camera. Used for rendering only,
/// independent of the calibration's projection.
Eigen::Vector2d rayThroughPixel(const Eigen::Vector2d& pixel, const CameraIntrinsics& camera);
Eigen::Vector2d pixelOfPoint(const Eigen::Vector3d& pointInCameraOptical, const CameraIntrinsics& camera);

} // namespace naocal

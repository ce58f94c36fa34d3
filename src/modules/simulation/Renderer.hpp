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

/// A flat thing of one grey (white from behind): spans x and y of its frame by +-size/2 and hides what was listed
/// before it.
struct Patch {
  RigidTransform cameraOpticalFromPatch;
  Eigen::Vector2d size = {0.1, 0.1}; // [m]
  double brightness = 0;             // 0 as ink, 1 as paper
};

/// What lies before the camera. Later things hide earlier ones, patches hide boards; the rest is floor.
struct RenderedScene {
  std::vector<RenderedBoard> boards;
  std::vector<Patch> patches;
};

/// How the camera sees. Grey = vignetting * (black + (white - black) * brightness), box-averaged over the pixel's area,
/// blurred by a Gaussian, plus noise. The standard values are those of the detection benchmark.
struct Appearance {
  double black = 40, white = 190;                     // of ink and paper [grey level]
  double floorBrightness = 0.45, floorTexture = 0.05; // mean and standard deviation; 0 as ink, 1 as paper
  double blur = 0.7;                                  // sigma [px]
  double noise = 3;                                   // sigma [grey level]
  double vignetting = 0;                              // share of light lost in the picture's corner
  std::optional<int> jpegQuality;                     // 1 .. 100: lossy compression
};

/// The picture that a camera takes of a scene; the same seed gives the same picture.
///
/// Rays through the corners of all pixels are found once, so keep one renderer for many pictures of a camera.
/// Projection is written here for a second time, on purpose: pictures shall check the calibration's own.
class Renderer {
public:
  /// `floorSeed`: of the floor's texture, where all pictures show the same.
  explicit Renderer(const CameraIntrinsics& intrinsics, std::optional<std::uint64_t> floorSeed = {});

  GreyPicture render(const RenderedScene& scene, const Appearance& appearance, std::uint64_t seed) const;

  /// The same while camera or scene move and rows are exposed one after the other. `scenes`: at least two instants,
  /// evenly spread from the beginning of the first row's exposure to the end of the last row's, all of the same things.
  /// `exposureShare`: how much of that span one row is exposed.
  GreyPicture render(const std::vector<RenderedScene>& scenes, double exposureShare, const Appearance& appearance,
                     std::uint64_t seed) const;

  const CameraIntrinsics& intrinsics() const { return intrinsics_; }

private:
  CameraIntrinsics intrinsics_;
  std::vector<Eigen::Vector2f> rays_; // (x, y) at z = 1 through the (width+1) x (height+1) pixel corners
  std::vector<float> blotches_;       // of the floor in each pixel; empty: each picture has its own
};

/// Where a point is seen [px]; absent behind the camera or outside of the picture.
std::optional<Eigen::Vector2d> projectOptical(const Eigen::Vector3d& pointInCameraOptical,
                                              const CameraIntrinsics& intrinsics);

/// The true places of a board's inner corners that lie in the picture, hidden or not.
BoardCorners trueCorners(const RenderedBoard& board, const CameraIntrinsics& intrinsics);

/// A flat thing made ready: what is painted on it, which pixels it may touch, and where a ray meets its plane.
struct FlatObject {
  std::shared_ptr<const FlatTexture> painting;
  bool fromBehind = false;                   // as seen at the first instant
  int left, right, top, bottom;              // [px], inclusive, at all instants
  std::vector<Eigen::Matrix3f> planeFromRay; // by instant: (x, y, 1) / distance = planeFromRay * ray

  /// At a share of the span between the first and the last instant.
  Eigen::Matrix3f at(float share) const;
};

/// All flat things of a scene at several instants, those in front first.
std::vector<FlatObject> prepareFlats(const std::vector<RenderedScene>& scenes, const CameraIntrinsics& camera);

/// The point at z = 1 that is seen at a pixel, and the pixel where a point before the camera is seen.
/// Written for rendering alone, apart from the calibration's projection that the pictures shall check.
Eigen::Vector2d rayThroughPixel(const Eigen::Vector2d& pixel, const CameraIntrinsics& camera);
Eigen::Vector2d pixelOfPoint(const Eigen::Vector3d& pointInCameraOptical, const CameraIntrinsics& camera);

} // namespace naocal

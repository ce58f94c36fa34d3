#include "simulation/Renderer.hpp"

#include "io/GreyImage.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <boost/random/normal_distribution.hpp>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>
#include <span>
#include <vector>

namespace naocal {

namespace {

/// Renders flat objects over the floor, row by row: mean brightness over each pixel's area and exposure time.
class RowRenderer {
public:
  /// `rays`: (x, y) at z = 1 through all pixel corners, row by row; `width`: pixels per row.
  RowRenderer(const std::vector<FlatObject>& flats, const std::vector<Eigen::Vector2f>& rays, int width);

  /// `brightness`: in: floor, out: scene, per pixel of the row. The row is exposed from `begin` to `end`, fractions of
  /// the span between the first and the last instant; ignored for static scenes.
  void paint(int y, float begin, float end, float* brightness);

private:
  static constexpr int samples = 16; // one per 1/16 row, 1/16 column and 1/16 of the exposure

  /// A flat object in the row: its cells at the pixel corners at the start and the end of exposure, upper and lower
  /// edge, and its pose at each sample time.
  struct Candidate {
    const FlatObject* flat;
    std::array<std::vector<std::size_t>, 4> cells;
    std::vector<Eigen::Matrix3f> planeFromRay; // one for static scenes
  };
  /// Its brightness if constant over a pixel and its exposure; otherwise absent.
  static std::optional<float> uniform(const Candidate& candidate, int x);
  void prepare(Candidate& candidate, int y, float begin, float end) const;
  float sampleTexture(int x, int y, float floor) const;
  const Eigen::Vector2f& ray(int x, int y) const {
    return rays_[std::size_t(y) * std::size_t(width_ + 1) + std::size_t(x)];
  }

  const std::vector<Eigen::Vector2f>& rays_;
  int width_;
  bool moves_;
  std::vector<Candidate> all_;
  std::vector<const Candidate*> mixed_; // in the sampled pixel, front to back
};

/// Opposite corners of a flat object in its own frame.
struct Outline {
  Eigen::Vector2d lower, upper;
};

/// Adds a flat object's pose at one more instant.
void addInstant(FlatObject& flat, const RigidTransform& opticalFromFlat, const Outline& outline,
                const CameraIntrinsics& camera) {
  Eigen::Matrix3d rayFromPlane;
  rayFromPlane << opticalFromFlat.rotation.leftCols<2>(), opticalFromFlat.translation;
  flat.planeFromRay.push_back(rayFromPlane.inverse().cast<float>());
  constexpr int steps = 16; // per side: distortion bends the edge
  for (int i = 0; i < 4 * steps; ++i) {
    const double share = double(i % steps) / steps;
    const Eigen::Vector2d along[4] = {{share, 0}, {1, share}, {1 - share, 1}, {0, 1 - share}};
    const Eigen::Vector2d p = outline.lower + along[i / steps].cwiseProduct(outline.upper - outline.lower);
    const Eigen::Vector3d seen = opticalFromFlat * Eigen::Vector3d{p.x(), p.y(), 0};
    if (seen.z() < 0.01 || seen.head<2>().norm() > 2 * seen.z()) { // too far off-axis: covers the whole image
      flat.left = flat.top = 0;
      flat.right = camera.width - 1;
      flat.bottom = camera.height - 1;
      break;
    }
    const Eigen::Vector2d uv = pixelOfPoint(seen, camera);
    flat.left = std::max(0, std::min(flat.left, int(uv.x()) - 3));
    flat.right = std::min(camera.width - 1, std::max(flat.right, int(uv.x()) + 3));
    flat.top = std::max(0, std::min(flat.top, int(uv.y()) - 3));
    flat.bottom = std::min(camera.height - 1, std::max(flat.bottom, int(uv.y()) + 3));
  }
}

bool seenFromBehind(const RigidTransform& opticalFromFlat) {
  return opticalFromFlat.rotation.col(2).dot(opticalFromFlat.translation) > 0;
}

/// OpenCV's five-parameter distortion of a point at z = 1.
Eigen::Vector2d distort(const Eigen::Vector2d& p, const std::array<double, 5>& distortion) {
  const auto& [k1, k2, p1, p2, k3] = distortion;
  const double r2 = p.squaredNorm();
  const double radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
  return {p.x() * radial + 2 * p1 * p.x() * p.y() + p2 * (r2 + 2 * p.x() * p.x()),
          p.y() * radial + p1 * (r2 + 2 * p.y() * p.y()) + 2 * p2 * p.x() * p.y()};
}

float cellBrightness(const FlatObject& flat, std::size_t cell) {
  return cell == FlatTexture::behindCamera ? -1 : flat.painting->brightness(cell, flat.fromBehind);
}

/// Hash of a pixel's coordinates to [0, 1): shifts its samples, so that edges do not meet the same sample pattern in
/// all pixels.
float scatter(unsigned x, unsigned y) {
  unsigned hash = x * 0x9e3779b1u ^ y * 0x85ebca77u;
  hash = (hash ^ (hash >> 15)) * 0x2c1b3c6du;
  return float((hash ^ (hash >> 13)) >> 8) / float(1u << 24);
}

RowRenderer::RowRenderer(const std::vector<FlatObject>& flats, const std::vector<Eigen::Vector2f>& rays, int width)
    : rays_{rays}, width_{width}, moves_{!flats.empty() && flats.front().planeFromRay.size() > 1} {
  for (const FlatObject& flat : flats) {
    Candidate& candidate = all_.emplace_back(Candidate{&flat, {}, {}});
    candidate.cells.fill(std::vector<std::size_t>(std::size_t(width + 1), FlatTexture::behindCamera));
    candidate.planeFromRay.assign(moves_ ? samples : 1, flat.planeFromRay.front());
  }
}

void RowRenderer::prepare(Candidate& candidate, int y, float begin, float end) const {
  const FlatObject& flat = *candidate.flat;
  if (moves_) {
    constexpr std::array<int, samples> times{6, 13, 2, 9, 0, 11, 4, 15, 7, 12, 3, 8, 1, 10, 5, 14};
    for (std::size_t i = 0; i < samples; ++i) {
      candidate.planeFromRay[i] = flat.at(begin + (end - begin) * (float(times[i]) + 0.5f) / samples);
    }
  }
  const auto look = [&](std::vector<std::size_t>& cells, int row, const Eigen::Matrix3f& planeFromRay) {
    const auto count = std::size_t(flat.right + 2 - flat.left);
    flat.painting->findCellsOfRow(planeFromRay, {&ray(flat.left, row), count},
                                  std::span{cells}.subspan(std::size_t(flat.left), count));
  };
  const Eigen::Matrix3f first = moves_ ? flat.at(begin) : flat.planeFromRay.front();
  const Eigen::Matrix3f last = moves_ ? flat.at(end) : first;
  if (!moves_ && y > flat.top) {
    candidate.cells[0].swap(candidate.cells[1]); // the previous row's lower edge
  } else {
    look(candidate.cells[0], y, first);
  }
  look(candidate.cells[1], y + 1, first);
  if (moves_) {
    look(candidate.cells[2], y, last);
    look(candidate.cells[3], y + 1, last);
  }
}

std::optional<float> RowRenderer::uniform(const Candidate& candidate, int x) {
  const FlatObject& flat = *candidate.flat;
  if (x < flat.left || x > flat.right) {
    return -1;
  }
  const auto place = std::size_t(x);
  const std::size_t cell = candidate.cells[0][place];
  const std::size_t corners = candidate.planeFromRay.size() > 1 ? 4 : 2;
  for (std::size_t i = 0; i < corners; ++i) {
    if (candidate.cells[i][place] != cell || candidate.cells[i][place + 1] != cell) {
      return std::nullopt;
    }
  }
  return cellBrightness(flat, cell);
}

/// Mean over samples in the pixel's area and exposure; samples that hit no object see the floor.
float RowRenderer::sampleTexture(int x, int y, float floor) const {
  constexpr std::array<int, samples> rows{0, 8, 4, 12, 2, 10, 6, 14, 1, 9, 5, 13, 3, 11, 7, 15};
  const Eigen::Vector2f& corner = ray(x, y);
  const Eigen::Vector2f right = ray(x + 1, y) - corner, down = ray(x, y + 1) - corner;
  const float shift = scatter(unsigned(x), unsigned(y));
  std::array<Eigen::Vector2f, samples> through;
  for (std::size_t i = 0; i < samples; ++i) {
    through[i] = corner + (float(i) + shift) / samples * right + (float(rows[i]) + shift) / samples * down;
  }
  std::array<float, samples> seen;
  seen.fill(-1);
  std::array<std::size_t, samples> cells;
  for (const Candidate* candidate : mixed_) {
    candidate->flat->painting->findCells(candidate->planeFromRay, through, cells);
    for (std::size_t i = 0; i < samples; ++i) {
      seen[i] = seen[i] < 0 ? cellBrightness(*candidate->flat, cells[i]) : seen[i];
    }
  }
  float sum = 0;
  for (const float brightness : seen) {
    sum += brightness < 0 ? floor : brightness;
  }
  return sum / samples;
}

void RowRenderer::paint(int y, float begin, float end, float* brightness) {
  std::vector<const Candidate*> here;
  int left = width_, right = -1;
  for (Candidate& candidate : all_) {
    if (y >= candidate.flat->top && y <= candidate.flat->bottom) {
      prepare(candidate, y, begin, end);
      here.push_back(&candidate);
      left = std::min(left, candidate.flat->left);
      right = std::max(right, candidate.flat->right);
    }
  }
  for (int x = left; x <= right; ++x) {
    mixed_.clear();
    std::optional<float> whole;
    for (std::size_t k = 0; k < here.size() && !(whole && *whole >= 0); ++k) {
      whole = uniform(*here[k], x);
      if (!whole || *whole >= 0) {
        mixed_.push_back(here[k]);
      }
    }
    if (mixed_.size() == 1 && whole && *whole >= 0) {
      brightness[x] = *whole;
    } else if (!mixed_.empty()) {
      brightness[x] = sampleTexture(x, y, brightness[x]);
    }
  }
}

/// Noise texture per pixel, row by row: patches of several sizes, mean 0, standard deviation about 1, fixed to the
/// image.
std::vector<float> floorTexture(int width, int height, std::mt19937_64& random) {
  const cv::Size size{width, height};
  std::normal_distribution<float> normal;
  cv::Mat1f sum(size, 0.f);
  for (const int pixels : {160, 40, 10}) {
    cv::Mat1f coarse(size.height / pixels + 2, size.width / pixels + 2);
    std::generate(coarse.begin(), coarse.end(), [&] { return normal(random); });
    cv::Mat1f fine;
    cv::resize(coarse, fine, size, 0, 0, cv::INTER_CUBIC);
    sum += fine;
  }
  sum /= std::sqrt(3.f);
  return {sum.begin(), sum.end()};
}

/// Applies lens and sensor to the light (0 ink, 1 paper) on the pixels.
GreyPicture developImage(std::vector<float> light, int width, int height, const Appearance& appearance,
                         std::mt19937_64& random) {
  cv::Mat1f image(height, width, light.data());
  image = image * float(appearance.white - appearance.black) + float(appearance.black);
  if (appearance.vignetting > 0) {
    const float centreX = float(width - 1) / 2, centreY = float(height - 1) / 2;
    const float cornerSquared = centreX * centreX + centreY * centreY;
    image.forEach([&](float& grey, const int* at) {
      const float x = float(at[1]) - centreX, y = float(at[0]) - centreY;
      grey *= 1 - float(appearance.vignetting) * (x * x + y * y) / cornerSquared;
    });
  }
  if (appearance.blur > 0) {
    cv::GaussianBlur(image, image, {}, appearance.blur);
  }
  if (appearance.noise > 0) {
    // twice as fast as std::normal_distribution
    boost::random::normal_distribution<float> noise{0, float(appearance.noise)};
    std::for_each(image.begin(), image.end(), [&](float& grey) { grey += noise(random); });
  }
  cv::Mat1b grey;
  image.convertTo(grey, CV_8U);
  if (appearance.jpegQuality) {
    return decodeImage(encodeJpeg({grey.data, grey.total()}, width, height, *appearance.jpegQuality), "a picture");
  }
  return {grey.cols, grey.rows, {grey.begin(), grey.end()}};
}

} // namespace

Renderer::Renderer(const CameraIntrinsics& intrinsics, std::optional<std::uint64_t> floorSeed)
    : intrinsics_{intrinsics} {
  rays_.reserve(std::size_t(intrinsics.width + 1) * std::size_t(intrinsics.height + 1));
  for (int y = 0; y <= intrinsics.height; ++y) {
    for (int x = 0; x <= intrinsics.width; ++x) {
      rays_.push_back(rayThroughPixel({x - 0.5, y - 0.5}, intrinsics).cast<float>());
    }
  }
  if (floorSeed) {
    std::mt19937_64 random{*floorSeed};
    blotches_ = floorTexture(intrinsics.width, intrinsics.height, random);
  }
}

GreyPicture Renderer::render(const RenderedScene& scene, const Appearance& appearance, std::uint64_t seed) const {
  return render(std::vector{scene}, 0, appearance, seed);
}

GreyPicture Renderer::render(const std::vector<RenderedScene>& scenes, double exposureShare,
                             const Appearance& appearance, std::uint64_t seed) const {
  const int width = intrinsics_.width, height = intrinsics_.height;
  std::mt19937_64 random{seed};
  std::vector<float> light = blotches_.empty() ? floorTexture(width, height, random) : blotches_;
  for (float& floor : light) {
    floor = float(appearance.floorBrightness) + float(appearance.floorTexture) * floor;
  }
  const std::vector<FlatObject> all = prepareFlats(scenes, intrinsics_);
  RowRenderer row{all, rays_, width};
  for (int y = 0; y < height; ++y) {
    const float begin = float(y) / float(height - 1) * float(1 - exposureShare);
    row.paint(y, begin, begin + float(exposureShare), &light[std::size_t(y) * std::size_t(width)]);
  }
  return developImage(std::move(light), width, height, appearance, random);
}

std::optional<Eigen::Vector2d> projectOptical(const Eigen::Vector3d& pointInCameraOptical,
                                              const CameraIntrinsics& intrinsics) {
  if (pointInCameraOptical.z() <= 0) {
    return std::nullopt;
  }
  const Eigen::Vector2d uv = pixelOfPoint(pointInCameraOptical, intrinsics);
  // Far outside the calibrated field, the distortion polynomial folds back into the image.
  const bool folded = (rayThroughPixel(uv, intrinsics) - pointInCameraOptical.hnormalized()).norm() > 1e-6;
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
    if (const auto uv = projectOptical(board.cameraOpticalFromBoard * pointInBoard, intrinsics)) {
      corners.ids.push_back(id);
      corners.uv.push_back(*uv);
    }
  }
  return corners;
}

Eigen::Matrix3f FlatObject::at(float share) const {
  const float place = share * float(planeFromRay.size() - 1);
  const std::size_t before = std::min(std::size_t(place), planeFromRay.size() - 2);
  return planeFromRay[before] + (place - float(before)) * (planeFromRay[before + 1] - planeFromRay[before]);
}

std::vector<FlatObject> prepareFlats(const std::vector<RenderedScene>& scenes, const CameraIntrinsics& camera) {
  const FlatObject nowhere{nullptr, false, camera.width, -1, camera.height, -1, {}};
  std::vector<FlatObject> result;
  for (std::size_t i = 0; i < scenes.front().boards.size(); ++i) {
    const RenderedBoard& board = scenes.front().boards[i];
    const Eigen::Vector2d outside{board.margin, board.margin};
    const Eigen::Vector2d size{board.pattern.squaresX * board.pattern.squareLength,
                               board.pattern.squaresY * board.pattern.squareLength};
    const Outline outline{Eigen::Vector2d{0, -size.y()} - outside, Eigen::Vector2d{size.x(), 0} + outside};
    FlatObject& flat = result.emplace_back(nowhere);
    flat.painting = makeBoardTexture(board.pattern, board.margin);
    flat.fromBehind = seenFromBehind(board.cameraOpticalFromBoard);
    for (const RenderedScene& scene : scenes) {
      addInstant(flat, scene.boards[i].cameraOpticalFromBoard, outline, camera);
    }
  }
  for (std::size_t i = 0; i < scenes.front().patches.size(); ++i) {
    const Patch& patch = scenes.front().patches[i];
    const Eigen::Vector2d half = patch.size / 2;
    FlatObject& flat = result.emplace_back(nowhere);
    flat.painting = makePatchTexture(half.x(), half.y(), patch.brightness);
    flat.fromBehind = seenFromBehind(patch.cameraOpticalFromPatch);
    for (const RenderedScene& scene : scenes) {
      addInstant(flat, scene.patches[i].cameraOpticalFromPatch, {-half, half}, camera);
    }
  }
  std::reverse(result.begin(), result.end());
  return result;
}

Eigen::Vector2d rayThroughPixel(const Eigen::Vector2d& pixel, const CameraIntrinsics& camera) {
  const Eigen::Vector2d given{(pixel.x() - camera.cx) / camera.fx, (pixel.y() - camera.cy) / camera.fy};
  Eigen::Vector2d p = given; // p <- p + (given - distorted(p))
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector2d step = given - distort(p, camera.distortion);
    p += step;
    if (step.squaredNorm() < 1e-18) {
      break;
    }
  }
  return p;
}

Eigen::Vector2d pixelOfPoint(const Eigen::Vector3d& pointInCameraOptical, const CameraIntrinsics& camera) {
  const Eigen::Vector2d p = distort(pointInCameraOptical.hnormalized(), camera.distortion);
  return {camera.fx * p.x() + camera.cx, camera.fy * p.y() + camera.cy};
}

} // namespace naocal

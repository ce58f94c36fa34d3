#include "synthetic/Rendering.hpp"

#include "captures/InputError.hpp"
#include "synthetic/RenderingFlats.hpp"
#include "synthetic/RenderingLens.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <random>

namespace naocal {
namespace {

constexpr int samplesPerPixel = 16; // one in each of 16 rows and 16 columns of the pixel

/// Blotches of several sizes with mean 0 and standard deviation about 1, fixed to the picture.
cv::Mat1f blotches(cv::Size size, std::mt19937_64& random) {
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
  return sum;
}

/// A number in [0, 1) that looks random, from a pixel's place: it shifts the pixel's samples so that no edge meets the
/// same ones in all pixels.
float scatter(unsigned x, unsigned y) {
  unsigned hash = x * 0x9e3779b1u ^ y * 0x85ebca77u;
  hash = (hash ^ (hash >> 15)) * 0x2c1b3c6du;
  return float((hash ^ (hash >> 13)) >> 8) / float(1u << 24);
}

/// A flat thing at several instants: one `planeFromRay` each; brightness and edges are the first one's.
struct MovingFlat {
  Flat flat;
  std::vector<Eigen::Matrix3f> planeFromRay;

  /// At a share of the span between the first and the last instant.
  Eigen::Matrix3f at(float share) const {
    const float place = share * float(planeFromRay.size() - 1);
    const std::size_t before = std::min(std::size_t(place), planeFromRay.size() - 2);
    return planeFromRay[before] + (place - float(before)) * (planeFromRay[before + 1] - planeFromRay[before]);
  }
};

/// The mean brightness over a pixel's area; samples that hit nothing see the floor. `rays` are those through its
/// top-left, top-right and bottom-left corners; `planeFromRay(k, i)` is the k-th candidate's for the i-th sample.
template <typename Candidates, typename PlaneFromRay>
float pixelBrightness(const Candidates& candidates, const PlaneFromRay& planeFromRay,
                      const std::array<Eigen::Vector2f, 3>& rays, float floor, float shift) {
  float sum = 0;
  for (int i = 0; i < samplesPerPixel; ++i) {
    constexpr std::array<int, samplesPerPixel> rows{0, 8, 4, 12, 2, 10, 6, 14, 1, 9, 5, 13, 3, 11, 7, 15};
    const float u = (float(i) + shift) / samplesPerPixel, v = (float(rows[std::size_t(i)]) + shift) / samplesPerPixel;
    const Eigen::Vector2f ray = rays[0] + u * (rays[1] - rays[0]) + v * (rays[2] - rays[0]);
    float seen = -1;
    for (std::size_t k = 0; k < candidates.size() && seen < 0; ++k) {
      const Eigen::Vector3f p = planeFromRay(*candidates[k], i) * ray.homogeneous();
      seen = p.z() > 0 ? candidates[k]->flat.brightness(p.x() / p.z(), p.y() / p.z()) : -1;
    }
    sum += seen < 0 ? floor : seen;
  }
  return sum / samplesPerPixel;
}

/// The flats of several instants as one list, their places in the picture joined.
std::vector<MovingFlat> movingFlats(const std::vector<RenderedScene>& scenes, const CameraIntrinsics& camera) {
  std::vector<MovingFlat> result;
  for (const RenderedScene& scene : scenes) {
    std::vector<Flat> now = flats(scene, camera);
    for (std::size_t k = 0; k < now.size(); ++k) {
      if (k == result.size()) {
        result.push_back({now[k], {}});
      }
      Flat& flat = result[k].flat;
      flat.left = std::min(flat.left, now[k].left);
      flat.right = std::max(flat.right, now[k].right);
      flat.top = std::min(flat.top, now[k].top);
      flat.bottom = std::max(flat.bottom, now[k].bottom);
      result[k].planeFromRay.push_back(now[k].planeFromRay);
    }
  }
  return result;
}

/// What the lens and the sensor do to the light that falls on them.
GreyPicture developed(cv::Mat1f image, const Appearance& appearance, std::mt19937_64& random) {
  const float centreX = float(image.cols - 1) / 2, centreY = float(image.rows - 1) / 2;
  const float cornerSquared = centreX * centreX + centreY * centreY;
  image.forEach([&](float& grey, const int* at) {
    const float x = float(at[1]) - centreX, y = float(at[0]) - centreY;
    grey = float(appearance.black + (appearance.white - appearance.black) * double(grey));
    grey *= 1 - float(appearance.vignetting) * (x * x + y * y) / cornerSquared;
  });
  if (appearance.blur > 0) {
    cv::GaussianBlur(image, image, {}, appearance.blur);
  }
  if (appearance.noise > 0) {
    std::normal_distribution<float> noise{0, float(appearance.noise)};
    std::for_each(image.begin(), image.end(), [&](float& grey) { grey += noise(random); });
  }
  cv::Mat1b grey;
  image.convertTo(grey, CV_8U);
  if (appearance.jpegQuality) {
    std::vector<std::uint8_t> bytes;
    cv::imencode(".jpg", grey, bytes, {cv::IMWRITE_JPEG_QUALITY, *appearance.jpegQuality});
    grey = cv::imdecode(bytes, cv::IMREAD_GRAYSCALE);
  }
  return {grey.cols, grey.rows, {grey.begin(), grey.end()}};
}

} // namespace

Renderer::Renderer(const CameraIntrinsics& intrinsics) : intrinsics_{intrinsics} {
  rays_.reserve(std::size_t(intrinsics.width + 1) * std::size_t(intrinsics.height + 1));
  for (int y = 0; y <= intrinsics.height; ++y) {
    for (int x = 0; x <= intrinsics.width; ++x) {
      rays_.push_back(renderedRay({x - 0.5, y - 0.5}, intrinsics).cast<float>());
    }
  }
}

GreyPicture Renderer::picture(const RenderedScene& scene, const Appearance& appearance, std::uint64_t seed) const {
  return picture(std::vector{scene}, 0, appearance, seed);
}

GreyPicture Renderer::picture(const std::vector<RenderedScene>& scenes, double exposureShare,
                              const Appearance& appearance, std::uint64_t seed) const {
  std::mt19937_64 random{seed};
  std::mt19937_64 floorRandom{appearance.floorSeed.value_or(0)};
  cv::Mat1f image = blotches({intrinsics_.width, intrinsics_.height}, appearance.floorSeed ? floorRandom : random);
  image.convertTo(image, CV_32F, appearance.floorTexture, appearance.floorBrightness);
  const std::vector<MovingFlat> all = movingFlats(scenes, intrinsics_);
  std::vector<const MovingFlat*> candidates;
  for (int y = 0; y < intrinsics_.height; ++y) {
    const Eigen::Vector2f* above = &rays_[std::size_t(y) * std::size_t(intrinsics_.width + 1)];
    const Eigen::Vector2f* below = above + intrinsics_.width + 1;
    const float begin = float(y) / float(intrinsics_.height - 1) * float(1 - exposureShare);
    const auto still = [](const MovingFlat& flat, int) -> const Eigen::Matrix3f& { return flat.planeFromRay.front(); };
    const auto moving = [&](const MovingFlat& flat, int i) {
      constexpr std::array<int, samplesPerPixel> times{6, 13, 2, 9, 0, 11, 4, 15, 7, 12, 3, 8, 1, 10, 5, 14};
      const float within = (float(times[std::size_t(i)]) + 0.5f) / samplesPerPixel;
      return flat.at(begin + float(exposureShare) * within);
    };
    for (int x = 0; x < intrinsics_.width; ++x) {
      candidates.clear();
      for (const MovingFlat& one : all) {
        if (y >= one.flat.top && y <= one.flat.bottom && x >= one.flat.left && x <= one.flat.right) {
          candidates.push_back(&one);
        }
      }
      if (!candidates.empty()) {
        const std::array<Eigen::Vector2f, 3> rays{above[x], above[x + 1], below[x]};
        const float shift = scatter(unsigned(x), unsigned(y));
        image(y, x) = scenes.size() > 1 ? pixelBrightness(candidates, moving, rays, image(y, x), shift)
                                        : pixelBrightness(candidates, still, rays, image(y, x), shift);
      }
    }
  }
  return developed(image, appearance, random);
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

void writePicture(const GreyPicture& picture, const std::filesystem::path& file) {
  // OpenCV wants a mutable pointer but only reads.
  const cv::Mat image(picture.height, picture.width, CV_8U, const_cast<std::uint8_t*>(picture.pixels.data()));
  bool written = false;
  try {
    written = cv::imwrite(file.string(), image);
  } catch (const cv::Exception&) { // an ending that OpenCV does not know
  }
  if (!written) {
    throw InputError(fmt::format(
        "{}: the picture could not be written; is the folder there and the ending .png or .jpg?", file.string()));
  }
}

} // namespace naocal

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

/// The mean brightness over a pixel's area; samples that hit nothing see the floor.
/// `rays` are those through its top-left, top-right and bottom-left corners.
float pixelBrightness(const std::vector<const Flat*>& candidates, const std::array<Eigen::Vector2f, 3>& rays,
                      float floor, float shift) {
  float sum = 0;
  for (int i = 0; i < samplesPerPixel; ++i) {
    constexpr std::array<int, samplesPerPixel> rows{0, 8, 4, 12, 2, 10, 6, 14, 1, 9, 5, 13, 3, 11, 7, 15};
    const float u = (float(i) + shift) / samplesPerPixel, v = (float(rows[std::size_t(i)]) + shift) / samplesPerPixel;
    const Eigen::Vector2f ray = rays[0] + u * (rays[1] - rays[0]) + v * (rays[2] - rays[0]);
    float seen = -1;
    for (std::size_t k = 0; k < candidates.size() && seen < 0; ++k) {
      const Eigen::Vector3f p = candidates[k]->planeFromRay * ray.homogeneous();
      seen = p.z() > 0 ? candidates[k]->brightness(p.x() / p.z(), p.y() / p.z()) : -1;
    }
    sum += seen < 0 ? floor : seen;
  }
  return sum / samplesPerPixel;
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
  std::mt19937_64 random{seed};
  cv::Mat1f image = blotches({intrinsics_.width, intrinsics_.height}, random);
  image.convertTo(image, CV_32F, appearance.floorTexture, appearance.floorBrightness);
  const std::vector<Flat> all = flats(scene, intrinsics_);
  std::vector<const Flat*> candidates;
  for (int y = 0; y < intrinsics_.height; ++y) {
    const Eigen::Vector2f* above = &rays_[std::size_t(y) * std::size_t(intrinsics_.width + 1)];
    const Eigen::Vector2f* below = above + intrinsics_.width + 1;
    for (int x = 0; x < intrinsics_.width; ++x) {
      candidates.clear();
      for (const Flat& one : all) {
        if (y >= one.top && y <= one.bottom && x >= one.left && x <= one.right) {
          candidates.push_back(&one);
        }
      }
      if (!candidates.empty()) {
        image(y, x) = pixelBrightness(candidates, {above[x], above[x + 1], below[x]}, image(y, x),
                                      scatter(unsigned(x), unsigned(y)));
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

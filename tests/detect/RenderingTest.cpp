#include "Scenes.hpp"
#include "simulation/Renderer.hpp"

#include <catch2/catch.hpp>
#include <opencv2/aruco/charuco.hpp>

namespace naocal {
namespace {

constexpr int pixelsPerSquare = 96;

/// A board seen vertically from above, `pixelsPerSquare` pixels per square.
GreyPicture sheet(const CharucoPattern& pattern) {
  const int width = pattern.squaresX * pixelsPerSquare, height = pattern.squaresY * pixelsPerSquare;
  const double focal = pixelsPerSquare / pattern.squareLength; // at a distance of 1 m
  const CameraIntrinsics camera{width, height, focal, focal, -0.5, -0.5, {}};
  Eigen::Matrix3d opticalFromBoard = Eigen::Vector3d{1, -1, -1}.asDiagonal();
  Appearance plain;
  plain.blur = plain.noise = 0;
  plain.black = 0;
  plain.white = 255;
  return Renderer{camera}.render({{{"A", pattern, {opticalFromBoard, {0, 0, 1}}, 0}}, {}}, plain, 1);
}

} // namespace

// Compares the rendered sheet with OpenCV's, pixel by pixel, for odd and even row counts; the legacy pattern must
// differ for even ones. OpenCV's drawing is off by a pixel in places, hence the tolerance of 1 %.
TEST_CASE("a rendered board is the sheet that OpenCV draws") {
  for (const auto& [squaresX, squaresY] : {std::pair{7, 5}, std::pair{6, 4}}) {
    CharucoPattern pattern;
    pattern.squaresX = squaresX;
    pattern.squaresY = squaresY;
    const auto dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_100);
    cv::Mat1b drawn;
    cv::aruco::CharucoBoard::create(squaresX, squaresY, 0.08f, 0.06f, dictionary)
        ->draw({squaresX * pixelsPerSquare, squaresY * pixelsPerSquare}, drawn);
    const auto differing = [&](const GreyPicture& picture) {
      int count = 0;
      for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
          count += std::abs(int(picture.grey(x, y)) - int(drawn(y, x))) > 127;
        }
      }
      return double(count) / (picture.width * picture.height);
    };
    CHECK(differing(sheet(pattern)) < 0.01);
    pattern.legacyPattern = true;
    CHECK((differing(sheet(pattern)) > 0.3) == (squaresY % 2 == 0));
  }
}

// Proves that an edge is rendered where the projection puts it, including lens distortion: its sub-pixel position in an
// image row is within 0.03 px.
TEST_CASE("a rendered edge lies where its points project to") {
  CameraIntrinsics camera = plainCamera();
  camera.distortion = {-0.2, 0.05, 0.002, -0.001, 0.01};
  Appearance plain;
  plain.noise = 0;
  plain.floorTexture = 0;
  plain.floorBrightness = 0;
  const RigidTransform opticalFromPatch{rotationY(0.5) * rotationX(2.6) * rotationZ(0.3), {0.25, 0.1, 1.2}};
  const Patch patch{opticalFromPatch, {0.4, 0.3}, 1};
  const GreyPicture picture = Renderer{camera}.render({{}, {patch}}, plain, 1);
  for (const double share : {-0.4, 0., 0.4}) {
    const auto edge = projectOptical(opticalFromPatch * Eigen::Vector3d{-0.2, share * 0.3, 0}, camera);
    REQUIRE(edge);
    const int y = int(std::lround(edge->y()));
    // The light integrated along the row gives the crossing's sub-pixel position.
    const auto beside = projectOptical(opticalFromPatch * Eigen::Vector3d{-0.2, share * 0.3 + 0.01, 0}, camera);
    const double crossing = edge->x() + (y - edge->y()) * (beside->x() - edge->x()) / (beside->y() - edge->y());
    double light = 0;
    const int from = int(crossing) - 12, to = int(crossing) + 12;
    for (int x = from; x < to; ++x) {
      light += (picture.grey(x, y) - 40.) / 150;
    }
    const bool brightOnTheRight = picture.grey(to, y) > picture.grey(from, y);
    const double measured = brightOnTheRight ? to - 0.5 - light : from - 0.5 + light;
    CHECK(measured == Approx(crossing).margin(0.03));
  }
}

// Validates the shortcut for pixels of uniform brightness: every pixel of every seventh row of a moving scene (a tilted
// board, another behind it, a patch across both) equals its mean over 2304 rays and times, apart from the scatter of 16
// samples at edges. A feature missed by the shortcut would exceed the limits.
TEST_CASE("a rendered pixel is the mean over its area and the time of its exposure") {
  const CameraIntrinsics camera{200, 150, 180, 180, 99.5, 74.5, {}};
  Appearance plain;
  plain.noise = plain.blur = plain.floorTexture = 0;
  plain.black = 0;
  plain.white = 255;
  std::vector<RenderedScene> scenes;
  for (const double moved : {0., 1., 2.}) {
    const RenderedBoard near = boardOnFloor({}, 0.7 + 0.005 * moved, 20 + moved);
    const RenderedBoard far = boardOnFloor({}, 1.6, moved - 10, 30, 0.2);
    scenes.push_back({{far, near}, {patchOn(near, 0.2, -0.1 + 0.01 * moved, {0.03, 0.3}, 0.3)}});
  }
  constexpr double share = 0.3;
  const GreyPicture picture = Renderer{camera}.render(scenes, share, plain, 1);
  const std::vector<FlatObject> all = prepareFlats(scenes, camera);
  const auto brightness = [&](double x, double y, double time) {
    const Eigen::Vector3f ray = rayThroughPixel({x, y}, camera).cast<float>().homogeneous();
    for (const FlatObject& flat : all) {
      const Eigen::Vector3f p = flat.at(float(time)) * ray;
      const float shown =
          flat.painting->brightness(flat.painting->cellAt(p.x() / p.z(), p.y() / p.z()), flat.fromBehind);
      if (p.z() > 0 && shown >= 0) {
        return double(shown);
      }
    }
    return plain.floorBrightness;
  };
  constexpr int steps = 16, times = 9;
  double sum = 0, worst = 0;
  int count = 0;
  for (int y = 3; y < camera.height; y += 7) {
    for (int x = 0; x < camera.width; ++x) {
      double mean = 0;
      for (int i = 0; i < steps * steps * times; ++i) {
        const double u = (i % steps + 0.5) / steps - 0.5, v = (i / steps % steps + 0.5) / steps - 0.5;
        const double within = (i / steps / steps + 0.5) / times;
        mean += brightness(x + u, y + v, double(y) / (camera.height - 1) * (1 - share) + share * within);
      }
      const double difference = picture.grey(x, y) / 255. - mean / (steps * steps * times);
      sum += difference * difference;
      worst = std::max(worst, std::abs(difference));
      ++count;
    }
  }
  CHECK(worst < 0.2);
  CHECK(std::sqrt(sum / count) < 0.02);
}

TEST_CASE("the same seed renders the same picture and another seed does not") {
  // Proves repeatability on one machine. Other standard libraries have other normal distributions.
  const Renderer renderer{plainCamera()};
  const RenderedScene scene{{boardOnFloor({}, 0.7, 10)}, {}};
  CHECK(renderer.render(scene, {}, 7).pixels == renderer.render(scene, {}, 7).pixels);
  CHECK(renderer.render(scene, {}, 7).pixels != renderer.render(scene, {}, 8).pixels);
}

} // namespace naocal

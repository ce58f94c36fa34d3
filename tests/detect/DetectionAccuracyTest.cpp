#include "Scenes.hpp"

#include <catch2/catch.hpp>
#include <random>

namespace naocal {
namespace {

struct Spread {
  Eigen::Vector2d bias, rms;
  double largest = 0;
  double foundShare = 0;
};

/// Corner errors of boards at one distance, tilt and image width, at random orientations.
Spread spread(int width, double square, double distance, double tilt, int frames, const CameraIntrinsics& camera) {
  CharucoPattern pattern;
  pattern.squareLength = square;
  pattern.markerLength = 0.75 * square;
  const Renderer renderer{camera};
  std::mt19937 random{unsigned(width) + unsigned(1e3 * distance)};
  std::uniform_real_distribution<double> yaw{-40, 40};
  std::vector<Eigen::Vector2d> all;
  std::size_t possible = 0;
  for (int frame = 0; frame < frames; ++frame) {
    const RenderedBoard board = boardOnFloor(pattern, distance, yaw(random), tilt);
    const BoardCorners truth = trueCorners(board, camera);
    possible += truth.ids.size();
    const Detection detection =
        detectBoards(renderer.render({{board}, {}}, {}, std::uint64_t(frame)), {described("A", pattern)}, camera);
    for (const BoardCorners& corners : detection.boards) {
      const auto some = errors(corners, truth);
      REQUIRE(some.size() == corners.ids.size());
      all.insert(all.end(), some.begin(), some.end());
    }
  }
  REQUIRE(!all.empty());
  Eigen::Vector2d sum = Eigen::Vector2d::Zero(), squares = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& error : all) {
    sum += error;
    squares += error.cwiseAbs2();
  }
  return {sum / double(all.size()), (squares / double(all.size())).cwiseSqrt(), largest(all),
          double(all.size()) / double(possible)};
}

} // namespace

// Proves unbiasedness, precision and the absence of gross errors in standard conditions (blur 0.7 px, noise 3 grey
// levels), up to the limit of visibility. Not covered: blur of real lenses, motion, demosaicing, sharpening.
TEST_CASE("corners are unbiased and precise wherever a board is found", "[slow]") {
  struct Row {
    int width;
    double square, distance, tilt;
  };
  for (const Row& row : {Row{640, 0.04, 0.6, 0}, Row{640, 0.06, 1.0, 0}, Row{640, 0.08, 1.6, 0}, Row{640, 0.1, 1.6, 0},
                         Row{640, 0.08, 0.7, 30}, Row{640, 0.06, 2.0, 30}, Row{640, 0.06, 2.0, 60},
                         Row{1280, 0.04, 1.0, 0}, Row{1280, 0.08, 1.6, 0}, Row{1280, 0.1, 2.5, 30}}) {
    CAPTURE(row.width, row.square, row.distance, row.tilt);
    const Spread s = spread(row.width, row.square, row.distance, row.tilt, 10, plainCamera(row.width));
    CHECK(s.bias.cwiseAbs().maxCoeff() < 0.03);
    CHECK(s.rms.maxCoeff() < 0.1);
    CHECK(s.largest < 1);
  }
}

// Proves that the search continues from few readable markers. Not covered: larger distances, where no marker is
// readable.
TEST_CASE("an A2 board flat on the floor at 1.3 m yields most of its corners at 640 x 480") {
  CHECK(spread(640, 0.08, 1.3, 0, 20, plainCamera()).foundShare > 0.6);
}

// Proves that corners are predicted through the lens model, and for one lens that a wrong lens model still gives all
// corners.
TEST_CASE("a lens with distortion costs no accuracy, described or not") {
  CameraIntrinsics bent = plainCamera();
  bent.distortion = {-0.25, 0.08, 0.001, -0.002, 0};
  const Spread s = spread(640, 0.08, 0.7, 0, 10, bent);
  CHECK(s.foundShare > 0.99);
  CHECK(s.bias.cwiseAbs().maxCoeff() < 0.03);
  CHECK(s.rms.maxCoeff() < 0.1);

  const RenderedBoard board = boardOnFloor({}, 0.7, 20);
  const Detection detection =
      detectBoards(Renderer{bent}.render({{board}, {}}, {}, 1), {described("A", board.pattern)}, plainCamera());
  REQUIRE(detection.boards.size() == 1);
  CHECK(detection.boards[0].ids.size() == 24);
  CHECK(largest(errors(detection.boards[0], trueCorners(board, bent))) < 0.2);
}

} // namespace naocal

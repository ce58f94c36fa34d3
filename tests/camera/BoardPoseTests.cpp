#include "camera/BoardPose.hpp"

#include <catch2/catch.hpp>

namespace naocal {
namespace {

/// fx, fy, cx, cy of a plain lens without distortion.
Eigen::Matrix<double, 9, 1> plainLens() {
  Eigen::Matrix<double, 9, 1> lens = Eigen::Matrix<double, 9, 1>::Zero();
  lens.head<4>() << 598, 598, 320, 240;
  return lens;
}

/// Corners of a board with squares of 8 cm, in columns and rows counted from the first, as seen at pixels.
struct Sight {
  double column, row, u, v;
};

std::optional<RigidTransform> poseOf(const std::vector<Sight>& sights) {
  constexpr double square = 0.08; // [m]
  CornerBlocks blocks;
  for (const Sight& sight : sights) {
    CornerBlock& block = blocks.emplace_back(CornerBlock{});
    block.x[0] = square * sight.column;
    block.y[0] = square * sight.row;
    block.u[0] = sight.u;
    block.v[0] = sight.v;
    block.present[0] = 1;
  }
  return estimateBoardPose(blocks, plainLens());
}

} // namespace

TEST_CASE("corners of which all but one lie on a line give no pose of a board") {
  // Proves it on the corners of one sight of a simulated robot; taken for a pose, they put the board behind the camera.
  CHECK_FALSE(poseOf({{1, 1, 633.0, 429.5},
                      {2, 1, 622.5, 388.5},
                      {3, 1, 613.2, 354.4},
                      {4, 1, 605.7, 324.1},
                      {5, 1, 598.4, 298.6},
                      {6, 1, 593.0, 276.3},
                      {6, 2, 634.5, 293.6}}));
}

TEST_CASE("the pose of a board is that which shows its corners where they were seen") {
  // Proves the pose of a board that stands 1 m before the camera, parallel to the picture, against closed form.
  std::vector<Sight> sights;
  for (const double column : {0.0, 1.0, 2.0}) {
    for (const double row : {0.0, 1.0}) {
      sights.push_back({column, row, 320 + 598 * 0.08 * column, 240 + 598 * 0.08 * row});
    }
  }
  const auto pose = poseOf(sights);
  REQUIRE(pose);
  CHECK(pose->rotation.isIdentity(1e-6));
  CHECK(pose->translation.isApprox(Eigen::Vector3d{0, 0, 1}, 1e-6));
}

} // namespace naocal

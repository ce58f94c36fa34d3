#include "../SharedData.hpp"
#include "Scenes.hpp"
#include "io/GreyImage.hpp"

#include <catch2/catch.hpp>
#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>

namespace naocal {
namespace {

Board photographedBoard() {
  CharucoPattern pattern;
  pattern.dictionary = "DICT_6X6_250";
  pattern.squaresX = 5;
  pattern.squaresY = 7;
  pattern.squareLength = 0.04;
  pattern.markerLength = 0.02;
  return described("photographed", pattern);
}

CameraIntrinsics publishedCamera(const std::filesystem::path& file) {
  const cv::FileStorage storage{file.string(), cv::FileStorage::READ};
  cv::Mat matrix, distortion;
  storage["camera_matrix"] >> matrix;
  storage["distortion_coefficients"] >> distortion;
  CameraIntrinsics camera{
      640, 480, matrix.at<double>(0, 0), matrix.at<double>(1, 1), matrix.at<double>(0, 2), matrix.at<double>(1, 2), {}};
  std::copy_n(distortion.begin<double>(), 5, camera.distortion.begin());
  return camera;
}

/// Residuals of each corner after fitting the board's pose [px].
std::vector<Eigen::Vector2d> poseResiduals(const BoardCorners& corners, const CameraIntrinsics& camera) {
  const auto points = innerCorners(*photographedBoard().pattern);
  std::vector<cv::Point3d> onBoard;
  std::vector<cv::Point2d> seen, predicted;
  for (std::size_t i = 0; i < corners.ids.size(); ++i) {
    const Eigen::Vector3d& point = points[std::size_t(corners.ids[i])];
    onBoard.emplace_back(point.x(), point.y(), point.z());
    seen.emplace_back(corners.uv[i].x(), corners.uv[i].y());
  }
  const cv::Matx33d matrix{camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1};
  cv::Vec3d rotation, translation;
  cv::solvePnP(onBoard, seen, matrix, camera.distortion, rotation, translation);
  cv::projectPoints(onBoard, rotation, translation, matrix, camera.distortion, predicted);
  std::vector<Eigen::Vector2d> residuals;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    residuals.emplace_back(seen[i].x - predicted[i].x, seen[i].y - predicted[i].y);
  }
  return residuals;
}

double rms(const std::vector<Eigen::Vector2d>& residuals) {
  double squares = 0;
  for (const Eigen::Vector2d& residual : residuals) {
    squares += residual.squaredNorm();
  }
  return std::sqrt(squares / double(residuals.size()));
}

} // namespace

// Proves that corners in real photographs (another board, dictionary and lens; JPEG) agree with the published camera to
// 0.25 px rms. Absolute accuracy is not tested, as there is no ground truth.
TEST_CASE("photographs of a board agree with their published camera") {
  const auto folder = sharedData("charuco-photos");
  if (!folder) {
    return;
  }
  const CameraIntrinsics camera = publishedCamera(*folder / "tutorial_camera_charuco.yml");
  for (const char* name : {"calib_img_00.jpg", "calib_img_02.jpg"}) {
    CAPTURE(name);
    const Detection detection = detectBoards(readImage(*folder / name), {photographedBoard()}, camera);
    REQUIRE(detection.boards.size() == 1);
    CHECK(detection.boards[0].ids.size() >= 22);
    CHECK(rms(poseResiduals(detection.boards[0], camera)) < 0.25);
  }
}

// Proves that objects on a real board cause no false corners: all corners fit one pose within 1 px. Missed corners are
// not counted.
TEST_CASE("a photograph of a partly hidden board gives no false corner") {
  const auto folder = sharedData("charuco-photos");
  if (!folder) {
    return;
  }
  const CameraIntrinsics camera = publishedCamera(*folder / "tutorial_camera_charuco.yml");
  const Detection detection =
      detectBoards(readImage(*folder / "chocclusion_original.jpg"), {photographedBoard()}, camera);
  REQUIRE(detection.boards.size() == 1);
  CHECK(detection.boards[0].ids.size() >= 8);
  CHECK(detection.boards[0].ids.size() < 24);
  CHECK(largest(poseResiduals(detection.boards[0], camera)) < 1);
}

} // namespace naocal

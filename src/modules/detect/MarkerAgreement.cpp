#include "detect/MarkerAgreement.hpp"

#include "detect/BoardLayout.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>

namespace naocal {
namespace {

constexpr double leastTolerance = 3; // [px]
constexpr double toleranceInSides = 0.1;
constexpr double markerWeight = 0.04; // a marker's corner is about five times as far off as a fitted board's corner

std::vector<SeenPoint> sightings(const Marker& marker, const CharucoPattern& pattern, const Lens& lens) {
  const auto onBoard = *markerOnBoard(pattern, marker.id);
  std::vector<SeenPoint> result;
  for (std::size_t i = 0; i < 4; ++i) {
    result.push_back({onBoard[i], lens.withoutDistortion(marker.corners[i]), markerWeight});
  }
  return result;
}

} // namespace

MarkerAgreement markerAgreement(const std::vector<Marker>& markers, const CharucoPattern& pattern, const Lens& lens) {
  std::vector<cv::Point2d> onBoard, seenAt;
  for (const Marker& marker : markers) {
    for (const SeenPoint& corner : sightings(marker, pattern, lens)) {
      onBoard.emplace_back(corner.onBoard.x(), corner.onBoard.y());
      seenAt.emplace_back(corner.seenAt.x(), corner.seenAt.y());
    }
  }
  const cv::Mat found = cv::findHomography(onBoard, seenAt, cv::RANSAC, leastTolerance);
  MarkerAgreement result;
  if (found.empty()) {
    result.others = markers;
    return result;
  }
  Eigen::Matrix3d homography;
  cv::cv2eigen(found, homography);
  for (const Marker& marker : markers) {
    const auto corners = sightings(marker, pattern, lens);
    const double side = (marker.corners[0] - marker.corners[2]).norm() / std::sqrt(2);
    const double tolerance = std::max(leastTolerance, toleranceInSides * side);
    const bool agrees = std::all_of(corners.begin(), corners.end(), [&](const SeenPoint& corner) {
      return ((homography * corner.onBoard.homogeneous()).hnormalized() - corner.seenAt).norm() <= tolerance;
    });
    (agrees ? result.agreeing : result.others).push_back(marker);
    if (agrees) {
      result.corners.insert(result.corners.end(), corners.begin(), corners.end());
    }
  }
  return result;
}

} // namespace naocal

#include "detect/MarkerDetector.hpp"

#include "io/InputError.hpp"

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <utility>

#define NAOCAL_ARUCO_CLASSES (CV_VERSION_MAJOR * 100 + CV_VERSION_MINOR >= 407)
#if NAOCAL_ARUCO_CLASSES
#include <opencv2/objdetect/aruco_detector.hpp>
#else
#include <opencv2/aruco.hpp>
#endif

namespace naocal {
namespace {

cv::aruco::Dictionary findDictionary(const std::string& name) {
  namespace aruco = cv::aruco;
  static const std::vector<std::pair<std::string, int>> known{
      {"DICT_4X4_50", aruco::DICT_4X4_50},
      {"DICT_4X4_100", aruco::DICT_4X4_100},
      {"DICT_4X4_250", aruco::DICT_4X4_250},
      {"DICT_4X4_1000", aruco::DICT_4X4_1000},
      {"DICT_5X5_50", aruco::DICT_5X5_50},
      {"DICT_5X5_100", aruco::DICT_5X5_100},
      {"DICT_5X5_250", aruco::DICT_5X5_250},
      {"DICT_5X5_1000", aruco::DICT_5X5_1000},
      {"DICT_6X6_50", aruco::DICT_6X6_50},
      {"DICT_6X6_100", aruco::DICT_6X6_100},
      {"DICT_6X6_250", aruco::DICT_6X6_250},
      {"DICT_6X6_1000", aruco::DICT_6X6_1000},
      {"DICT_7X7_50", aruco::DICT_7X7_50},
      {"DICT_7X7_100", aruco::DICT_7X7_100},
      {"DICT_7X7_250", aruco::DICT_7X7_250},
      {"DICT_7X7_1000", aruco::DICT_7X7_1000},
      {"DICT_ARUCO_ORIGINAL", aruco::DICT_ARUCO_ORIGINAL},
      {"DICT_APRILTAG_16h5", aruco::DICT_APRILTAG_16h5},
      {"DICT_APRILTAG_25h9", aruco::DICT_APRILTAG_25h9},
      {"DICT_APRILTAG_36h10", aruco::DICT_APRILTAG_36h10},
      {"DICT_APRILTAG_36h11", aruco::DICT_APRILTAG_36h11},
  };
  for (const auto& [knownName, value] : known) {
    if (knownName == name) {
#if NAOCAL_ARUCO_CLASSES
      return aruco::getPredefinedDictionary(value);
#else
      return *aruco::getPredefinedDictionary(value);
#endif
    }
  }
  throw InputError(
      fmt::format("boards: \"dictionary\" should be one of OpenCV's, such as \"DICT_4X4_100\", found \"{}\"", name));
}

} // namespace

std::vector<Marker> detectMarkers(const GreyPicture& picture, const std::string& dictionary) {
  // OpenCV requires a mutable pointer but only reads.
  const cv::Mat image(picture.height, picture.width, CV_8U, const_cast<std::uint8_t*>(picture.pixels.data()));
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> ids;
#if NAOCAL_ARUCO_CLASSES
  cv::aruco::ArucoDetector(findDictionary(dictionary)).detectMarkers(image, corners, ids);
#else
  const cv::Ptr<cv::aruco::Dictionary> shared = cv::makePtr<cv::aruco::Dictionary>(findDictionary(dictionary));
  cv::aruco::detectMarkers(image, shared, corners, ids);
#endif
  std::vector<Marker> markers(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    markers[i].id = ids[i];
    for (std::size_t k = 0; k < 4; ++k) {
      markers[i].corners[k] = {corners[i][k].x, corners[i][k].y};
    }
  }
  return markers;
}

Eigen::MatrixXi markerCells(const std::string& dictionary, int id) {
  const cv::aruco::Dictionary all = findDictionary(dictionary);
  const cv::Mat bits = cv::aruco::Dictionary::getBitsFromByteList(all.bytesList.rowRange(id, id + 1), all.markerSize);
  Eigen::MatrixXi cells = Eigen::MatrixXi::Zero(all.markerSize + 2, all.markerSize + 2);
  for (int row = 0; row < all.markerSize; ++row) {
    for (int column = 0; column < all.markerSize; ++column) {
      cells(row + 1, column + 1) = bits.at<unsigned char>(row, column);
    }
  }
  return cells;
}

} // namespace naocal

#include "recordings/CameraModelFile.hpp"

#include "dialects/Kalibr.hpp"
#include "dialects/RosCameraInfo.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <opencv2/core.hpp>
#include <stdexcept>

namespace naocal {

namespace {

/// Coefficients in OpenCV's order: k1, k2, p1, p2, k3, k4, .. Returns the first that the pinhole model here lacks.
std::optional<std::size_t> setDistortion(const std::vector<double>& coefficients, CameraIntrinsics& lens) {
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    if (i < lens.distortion.size()) {
      lens.distortion[i] = coefficients[i];
    } else if (coefficients[i] != 0) {
      return i;
    }
  }
  return std::nullopt;
}

void requirePositive(const CameraIntrinsics& lens, const std::string& file) {
  if (!(lens.width > 0 && lens.height > 0 && lens.fx > 0 && lens.fy > 0)) {
    throw InputError{fmt::format("{}: expected a positive picture size and focal lengths, found {} x {} px, fx {}, "
                                 "fy {}",
                                 file, lens.width, lens.height, lens.fx, lens.fy)};
  }
}

[[noreturn]] void refuseCoefficient(std::size_t index, const std::string& file) {
  throw InputError{
      fmt::format("{}: expected distortion by k1, k2, p1, p2, k3 only, found coefficient {} that is not 0: "
                  "calibrate with 5 coefficients",
                  file, index + 1)};
}

// mrcal

CameraIntrinsics readMrcal(const std::string& text, const std::string& file) {
  const YamlCursor all{text, file}; // a literal of Python's that is a flow mapping of YAML, too
  const std::string model = all.at("lensmodel").text();
  const std::map<std::string, std::size_t> known{
      {"LENSMODEL_PINHOLE", 0}, {"LENSMODEL_OPENCV4", 4}, {"LENSMODEL_OPENCV5", 5}, {"LENSMODEL_OPENCV8", 8}};
  const auto found = known.find(model);
  if (found == known.end()) {
    all.at("lensmodel").refuse("LENSMODEL_PINHOLE, LENSMODEL_OPENCV4, LENSMODEL_OPENCV5 or LENSMODEL_OPENCV8", model);
  }
  const std::vector<double> numbers = all.at("intrinsics").numbers(4 + found->second); // fx, fy, cx, cy, distortion
  const std::vector<double> size = all.at("imagersize").numbers(2);
  CameraIntrinsics lens;
  lens.width = static_cast<int>(size[0]);
  lens.height = static_cast<int>(size[1]);
  lens.fx = numbers[0];
  lens.fy = numbers[1];
  lens.cx = numbers[2];
  lens.cy = numbers[3];
  if (const auto index = setDistortion({numbers.begin() + 4, numbers.end()}, lens)) {
    refuseCoefficient(*index, file);
  }
  return lens;
}

// OpenCV

/// The first of a file's nodes with one of these names.
cv::FileNode findNode(const cv::FileStorage& storage, const std::vector<std::string>& names, const std::string& file) {
  for (const std::string& name : names) {
    if (const cv::FileNode node = storage[name]; !node.empty()) {
      return node;
    }
  }
  throw InputError{fmt::format("{}: expected {} as OpenCV writes it, found none", file, fmt::join(names, " or "))};
}

std::vector<double> readMatrix(const cv::FileNode& node, const std::string& file) {
  cv::Mat matrix;
  node >> matrix;
  if (matrix.empty() || matrix.channels() != 1) {
    throw InputError{fmt::format("{}: expected a matrix of numbers in {}, found another value", file, node.name())};
  }
  matrix.convertTo(matrix, CV_64F);
  std::vector<double> numbers(matrix.begin<double>(), matrix.end<double>());
  if (!std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); })) {
    throw InputError{fmt::format("{}: expected finite numbers in {}, found others", file, node.name())};
  }
  return numbers;
}

int readSide(const cv::FileNode& node) {
  double side = 0;
  node >> side;
  return side > 0 && side < 100'000 ? static_cast<int>(side) : 0;
}

[[noreturn]] void refuseSyntax(const std::string& file) {
  throw InputError{fmt::format("{}: expected a file of OpenCV's FileStorage, found broken YAML or XML", file)};
}

CameraIntrinsics readOpenCv(const std::string& text, const std::string& file) {
  try {
    const cv::FileStorage storage{text, cv::FileStorage::READ | cv::FileStorage::MEMORY};
    const cv::FileNode matrixNode = findNode(storage, {"camera_matrix", "cameraMatrix", "Camera_Matrix", "K"}, file);
    const std::vector<double> matrix = readMatrix(matrixNode, file);
    if (matrix.size() != 9) {
      throw InputError{
          fmt::format("{}: expected 3 x 3 numbers in {}, found {}", file, matrixNode.name(), matrix.size())};
    }
    CameraIntrinsics lens;
    lens.width = readSide(findNode(storage, {"image_width", "imageWidth", "image_Width"}, file));
    lens.height = readSide(findNode(storage, {"image_height", "imageHeight", "image_Height"}, file));
    lens.fx = matrix[0];
    lens.cx = matrix[2];
    lens.fy = matrix[4];
    lens.cy = matrix[5];
    const std::vector<double> distortion = readMatrix(
        findNode(storage, {"distortion_coefficients", "dist_coeffs", "distCoeffs", "Distortion_Coefficients", "D"},
                 file),
        file);
    if (const auto index = setDistortion(distortion, lens)) {
      refuseCoefficient(*index, file);
    }
    return lens;
  } catch (const cv::Exception&) {
    refuseSyntax(file);
  } catch (const std::length_error&) { // OpenCV's reader of YAML takes a key without a name for a string of length -1
    refuseSyntax(file);
  }
}

// ROS, kalibr

CameraIntrinsics readYaml(const std::string& text, const std::string& file) {
  const YamlCursor all{text, file};
  if (all.has("camera_matrix")) {
    return readRosLens(all);
  }
  if (!all.has("cam0")) {
    all.refuse("camera_matrix (ROS), cam0 (kalibr) or lensmodel (mrcal)", "neither");
  }
  if (all.has("cam1")) {
    all.refuse("a camchain of one camera", "several; keep the one that took the pictures, as cam0");
  }
  return readKalibrLens(all.at("cam0"));
}

} // namespace

CameraIntrinsics readCameraModel(const std::filesystem::path& path) {
  const std::string file = path.string(), text = readFile(path);
  const bool isOpenCv = text.starts_with("%YAML:1") || text.find("<opencv_storage") != std::string::npos ||
                        text.find("!!opencv-matrix") != std::string::npos;
  const bool isMrcal = text.find("'lensmodel'") != std::string::npos || text.find("\"lensmodel\"") != std::string::npos;
  const CameraIntrinsics lens = isOpenCv  ? readOpenCv(text, file)
                                : isMrcal ? readMrcal(text, file)
                                          : readYaml(text, file);
  requirePositive(lens, file);
  return lens;
}

} // namespace naocal

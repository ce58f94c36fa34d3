#include "dialects/RosCameraInfo.hpp"

#include "dialects/text/Decimals.hpp"
#include "dialects/text/YamlText.hpp"
#include "io/InputError.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace naocal {
namespace {

constexpr double parallel = 1e-9; // entries of the matrix that must be 0 or 1

std::string px(double number) {
  return printDecimal(number, decimals::pixel);
}

std::string lensText(const std::string& name, const CameraIntrinsics& lens) {
  std::vector<std::string> distortion;
  for (const double coefficient : lens.distortion) {
    distortion.push_back(printDecimal(coefficient, decimals::share));
  }
  const std::string fx = px(lens.fx), fy = px(lens.fy), cx = px(lens.cx), cy = px(lens.cy);
  return fmt::format("image_width: {}\nimage_height: {}\ncamera_name: {}\n"
                     "camera_matrix:\n  rows: 3\n  cols: 3\n  data: [{fx}, 0, {cx}, 0, {fy}, {cy}, 0, 0, 1]\n"
                     "distortion_model: plumb_bob\n"
                     "distortion_coefficients:\n  rows: 1\n  cols: 5\n  data: [{distortion}]\n"
                     "rectification_matrix:\n  rows: 3\n  cols: 3\n  data: [1, 0, 0, 0, 1, 0, 0, 0, 1]\n"
                     "projection_matrix:\n  rows: 3\n  cols: 4\n"
                     "  data: [{fx}, 0, {cx}, 0, 0, {fy}, {cy}, 0, 0, 0, 1, 0]\n",
                     lens.width, lens.height, name, fmt::arg("fx", fx), fmt::arg("fy", fy), fmt::arg("cx", cx),
                     fmt::arg("cy", cy), fmt::arg("distortion", fmt::join(distortion, ", ")));
}

/// The camera that a file is of: by its `camera_name`, else by its own name.
std::string cameraOf(const YamlCursor& all, const std::string& file) {
  std::vector<std::string> words{std::filesystem::path{file}.stem().string()};
  if (all.has("camera_name")) {
    words.insert(words.begin(), all.at("camera_name").text());
  }
  for (const std::string& word : words) {
    const bool isTop = word.find("top") != std::string::npos, isBottom = word.find("bottom") != std::string::npos;
    if (isTop != isBottom) {
      return isTop ? "top" : "bottom";
    }
  }
  all.refuse("a camera_name or a file name with top or bottom in it", fmt::format("{}", fmt::join(words, ", ")));
}

void readMatrix(const YamlCursor& at, CameraIntrinsics& lens) {
  const std::vector<double> k = at.at("data").numbers(9);
  const bool isPinhole = std::abs(k[1]) < parallel && std::abs(k[3]) < parallel && std::abs(k[6]) < parallel &&
                         std::abs(k[7]) < parallel && std::abs(k[8] - 1) < parallel;
  if (!isPinhole || !(k[0] > 0 && k[4] > 0)) {
    at.at("data").refuse("fx, 0, cx, 0, fy, cy, 0, 0, 1 with positive fx and fy", "another matrix");
  }
  lens.fx = k[0];
  lens.cx = k[2];
  lens.fy = k[4];
  lens.cy = k[5];
}

void readDistortion(const YamlCursor& all, CameraIntrinsics& lens) {
  const std::string model = all.has("distortion_model") ? all.at("distortion_model").text() : "plumb_bob";
  if (model != "plumb_bob") {
    all.at("distortion_model").refuse("plumb_bob, the one model that is known here", model);
  }
  const auto coefficients = all.at("distortion_coefficients").at("data").elements();
  if (coefficients.size() < 4 || coefficients.size() > lens.distortion.size()) {
    all.at("distortion_coefficients").refuse("4 or 5 coefficients", std::to_string(coefficients.size()));
  }
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    lens.distortion[i] = coefficients[i].number();
  }
}

} // namespace

CameraIntrinsics readRosLens(const YamlCursor& all) {
  CameraIntrinsics lens;
  lens.width = all.at("image_width").integer(1, CameraIntrinsics::mostPixels);
  lens.height = all.at("image_height").integer(1, CameraIntrinsics::mostPixels);
  readMatrix(all.at("camera_matrix"), lens);
  readDistortion(all, lens);
  return lens;
}

std::vector<DialectFile> writeRosCameraInfo(const RobotCalibration& calibration, const Robot&) {
  std::vector<DialectFile> files;
  for (const auto& [name, camera] : calibration.cameras) {
    if (camera.lens) {
      files.push_back({name + ".yaml", lensText(name, *camera.lens)});
    }
  }
  return files;
}

ParsedCalibration parseRosCameraInfo(const std::string& text, const std::string& file, const Robot&) {
  const YamlCursor all{text, file};
  ParsedCalibration parsed;
  parsed.calibration.cameras[cameraOf(all, file)].lens = readRosLens(all);
  return parsed;
}

} // namespace naocal

#include "recordings/CameraModelFile.hpp"

#include "dialects/Kalibr.hpp"
#include "dialects/RosCameraInfo.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "recordings/OpenCvLens.hpp"

#include <fmt/format.h>
#include <map>

namespace naocal {

namespace {

void requirePositive(const CameraIntrinsics& lens, const std::string& file) {
  if (!(lens.width > 0 && lens.height > 0 && lens.fx > 0 && lens.fy > 0)) {
    throw InputError{fmt::format("{}: expected a positive picture size and focal lengths, found {} x {} px, fx {}, "
                                 "fy {}",
                                 file, lens.width, lens.height, lens.fx, lens.fy)};
  }
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
  CameraIntrinsics lens;
  readPictureSize(all.at("imagersize"), lens);
  lens.fx = numbers[0];
  lens.fy = numbers[1];
  lens.cx = numbers[2];
  lens.cy = numbers[3];
  setDistortion({numbers.begin() + 4, numbers.end()}, file, lens);
  return lens;
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
  const bool isMrcal = text.find("'lensmodel'") != std::string::npos || text.find("\"lensmodel\"") != std::string::npos;
  const CameraIntrinsics lens = isOpenCvStorage(text) ? readOpenCvLens(text, file)
                                : isMrcal             ? readMrcal(text, file)
                                                      : readYaml(text, file);
  requirePositive(lens, file);
  return lens;
}

} // namespace naocal

#include "dialects/Kalibr.hpp"

#include "dialects/MountAngles.hpp"
#include "dialects/text/Decimals.hpp"
#include "dialects/text/YamlText.hpp"
#include "io/InputError.hpp"
#include "math/RigidTransform.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace naocal {
namespace {

constexpr std::array chainNames{"top", "bottom"};

/// The drawing's mount: linkFromCamera.
RigidTransform nominalMount(const Robot& robot, const std::string& camera) {
  const auto index = robot.cameraIndex(camera);
  if (!index) {
    throw InputError{fmt::format("the {} has no camera {}", robot.model, camera)};
  }
  const CameraMount& mount = robot.cameras[*index];
  return {mount.rotation, mount.translation};
}

/// The camera's mount with its corrections: linkFromOptical.
RigidTransform correctedMount(const Robot& robot, const std::string& name, const CameraCalibration& camera) {
  RigidTransform mount = nominalMount(robot, name);
  mount.translation += camera.translation.value_or(Eigen::Vector3d::Zero());
  mount.rotation *= rotationXyz(camera.rotation.value_or(Eigen::Vector3d::Zero())) * opticalFromCamera().transpose();
  return mount;
}

/// Rows of the matrix. Its angles are rounded, and its entries have more digits than these: read again, they give the
/// same angles and the same text.
std::string matrixText(const RigidTransform& transform) {
  Eigen::Vector3d angles = anglesXyz(transform.rotation);
  for (double& angle : angles) {
    angle = roundDecimal(angle, decimals::radian);
  }
  const Eigen::Matrix3d rotation = rotationXyz(angles);
  std::string text;
  for (int row = 0; row < 3; ++row) {
    text += "  - [";
    for (int column = 0; column < 3; ++column) {
      text += printDecimal(rotation(row, column), decimals::matrix) + ", ";
    }
    text += printDecimal(transform.translation[row], decimals::metre) + "]\n";
  }
  return text + "  - [0, 0, 0, 1]\n";
}

std::string cameraText(std::size_t number, const std::string& name, const CameraIntrinsics& lens) {
  if (lens.distortion[4] != 0) {
    throw InputError{
        fmt::format("camera {}: kalibr's radtan model has no place for k3 = {}; export to ros, or calibrate "
                    "with a lens without k3",
                    name, printDecimal(lens.distortion[4], decimals::share))};
  }
  const auto px = [](double value) { return printDecimal(value, decimals::pixel); };
  const auto share = [&](std::size_t i) { return printDecimal(lens.distortion[i], decimals::share); };
  return fmt::format("cam{}:\n  camera_model: pinhole\n  intrinsics: [{}, {}, {}, {}]\n  distortion_model: radtan\n"
                     "  distortion_coeffs: [{}, {}, {}, {}]\n  resolution: [{}, {}]\n  rostopic: /{}/image_raw\n",
                     number, px(lens.fx), px(lens.fy), px(lens.cx), px(lens.cy), share(0), share(1), share(2), share(3),
                     lens.width, lens.height, name);
}

RigidTransform readTransform(const YamlCursor& at) {
  constexpr double tolerance = 1e-5; // of a rotation's columns, from rounded digits
  const auto rows = at.elements();
  if (rows.size() != 4) {
    at.refuse("4 rows", std::to_string(rows.size()));
  }
  RigidTransform transform;
  for (int row = 0; row < 3; ++row) {
    const auto numbers = rows[static_cast<std::size_t>(row)].numbers(4);
    transform.rotation.row(row) << numbers[0], numbers[1], numbers[2];
    transform.translation[row] = numbers[3];
  }
  const Eigen::Matrix3d product = transform.rotation * transform.rotation.transpose();
  if ((product - Eigen::Matrix3d::Identity()).norm() > tolerance || transform.rotation.determinant() < 0) {
    at.refuse("a rotation in the first three columns", "another matrix");
  }
  return transform;
}

std::string nameOf(const YamlCursor& camera, std::size_t number) {
  const std::string topic = camera.has("rostopic") ? camera.at("rostopic").text() : "";
  for (const char* const name : chainNames) {
    if (topic.find(name) != std::string::npos) {
      return name;
    }
  }
  return chainNames[number];
}

} // namespace

void readPictureSize(const YamlCursor& at, CameraIntrinsics& lens) {
  const std::vector<YamlCursor> sides = at.elements();
  if (sides.size() != 2) {
    at.refuse("[width, height]", fmt::format("{} numbers", sides.size()));
  }
  lens.width = sides[0].integer(1, CameraIntrinsics::mostPixels);
  lens.height = sides[1].integer(1, CameraIntrinsics::mostPixels);
}

CameraIntrinsics readKalibrLens(const YamlCursor& at) {
  if (at.at("camera_model").text() != "pinhole") {
    at.at("camera_model").refuse("pinhole, the one model that is known here", at.at("camera_model").text());
  }
  CameraIntrinsics lens;
  const auto intrinsics = at.at("intrinsics").numbers(4);
  readPictureSize(at.at("resolution"), lens);
  lens.fx = intrinsics[0];
  lens.fy = intrinsics[1];
  lens.cx = intrinsics[2];
  lens.cy = intrinsics[3];
  if (!(lens.fx > 0 && lens.fy > 0)) {
    at.at("intrinsics").refuse("positive focal lengths", "others");
  }
  const std::string model = at.at("distortion_model").text();
  if (model == "radtan") {
    const auto coefficients = at.at("distortion_coeffs").numbers(4);
    std::copy(coefficients.begin(), coefficients.end(), lens.distortion.begin());
  } else if (model != "none") {
    at.at("distortion_model").refuse("radtan or none", model);
  }
  return lens;
}

std::vector<DialectFile> writeKalibr(const RobotCalibration& calibration, const Robot& robot) {
  std::string text;
  std::vector<std::string> written;
  for (const char* const name : chainNames) {
    const auto camera = calibration.cameras.find(name);
    if (camera == calibration.cameras.end() || !camera->second.lens) {
      continue;
    }
    text += cameraText(written.size(), name, *camera->second.lens);
    if (!written.empty()) {
      text +=
          "  T_cn_cnm1:\n" + matrixText(correctedMount(robot, name, camera->second).inverse() *
                                        correctedMount(robot, written.back(), calibration.cameras.at(written.back())));
    }
    written.push_back(name);
  }
  return written.empty() ? std::vector<DialectFile>{} : std::vector<DialectFile>{{"camchain.yaml", text}};
}

ParsedCalibration parseKalibr(const std::string& text, const std::string& file, const Robot& robot) {
  const YamlCursor all{text, file};
  ParsedCalibration parsed;
  std::string previous;
  for (std::size_t number = 0; number < chainNames.size() && all.has(fmt::format("cam{}", number)); ++number) {
    const YamlCursor at = all.at(fmt::format("cam{}", number));
    const std::string name = nameOf(at, number);
    if (name == previous) {
      at.refuse("the other camera than cam0", name);
    }
    CameraCalibration& camera = parsed.calibration.cameras[name];
    camera.lens = readKalibrLens(at);
    if (!previous.empty() && at.has("T_cn_cnm1")) {
      const RigidTransform cameraFromPrevious = readTransform(at.at("T_cn_cnm1"));
      // linkFromOptical of this camera, the previous one as drawn
      const RigidTransform mount = correctedMount(robot, previous, {}) * cameraFromPrevious.inverse();
      const RigidTransform nominal = nominalMount(robot, name);
      camera.rotation = anglesXyz(nominal.rotation.transpose() * mount.rotation * opticalFromCamera());
      camera.translation = mount.translation - nominal.translation;
    }
    previous = name;
  }
  if (previous.empty()) {
    all.refuse("cam0 as kalibr writes it", "none");
  }
  for (const auto& [key, value] : all.members()) {
    if (key != "cam0" && key != "cam1") {
      parsed.unused.push_back(key);
    }
  }
  return parsed;
}

} // namespace naocal

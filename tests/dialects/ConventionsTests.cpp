#include "dialects/BHuman.hpp"
#include "dialects/Hulks.hpp"
#include "dialects/HulksTree.hpp"
#include "dialects/Kalibr.hpp"
#include "dialects/MountAngles.hpp"
#include "dialects/RosCameraInfo.hpp"
#include "dialects/text/Decimals.hpp"

#include "RobotV6.hpp"
#include "math/Angles.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <yaml-cpp/yaml.h>

namespace naocal {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

const Vector3d turned{0.11, -0.07, 0.19};

RobotCalibration topTurned() {
  RobotCalibration calibration;
  calibration.cameras["top"].rotation = turned;
  return calibration;
}

Matrix3d about(const Vector3d& axis, double angle) {
  return AngleAxisd{angle, axis}.toRotationMatrix();
}

/// headFromCamera of the top camera here: the drawn mount, then the correction.
Matrix3d ourMount() {
  const Matrix3d drawn = v6().cameras[*v6().cameraIndex("top")].rotation;
  return drawn * about(Vector3d::UnitX(), turned.x()) * about(Vector3d::UnitY(), turned.y()) *
         about(Vector3d::UnitZ(), turned.z());
}

/// The number behind "NAME = " or "NAME: " in a text.
double numberAfter(const std::string& text, const std::string& name, std::size_t from = 0) {
  return std::stod(text.substr(text.find(name, from) + name.size()));
}

} // namespace

TEST_CASE("B-Human turns its camera as written to where it stands here") {
  // Proves the order of rotations against B-Human's own product, Ry(tilt + y) Rx(x) Rz(z), written anew with Eigen's
  // rotations, at angles of several degrees, where the order matters.
  const std::string text = writeBHuman(topTurned(), v6()).at(0).text;
  const std::size_t upper = text.find("upper");
  const double x = radians(numberAfter(text, "x = ", upper)), y = radians(numberAfter(text, "y = ", upper)),
               z = radians(numberAfter(text, "z = ", upper));
  const double tilt = radians(1.2); // headTiltToUpperCameraTilt
  const Matrix3d theirs =
      about(Vector3d::UnitY(), tilt + y) * about(Vector3d::UnitX(), x) * about(Vector3d::UnitZ(), z);
  CHECK((theirs - ourMount()).norm() < 1e-7);
  const Matrix3d wrongOrder =
      about(Vector3d::UnitX(), x) * about(Vector3d::UnitY(), tilt + y) * about(Vector3d::UnitZ(), z);
  CHECK((wrongOrder - ourMount()).norm() > 1e-3); // the check can fail
}

TEST_CASE("HULKs' tree turns its camera as written to where it stands here") {
  // Proves axes, signs and order against HULKs' own product of 2024, cameraFromHead = R * Rx(-pitch) Ry(-90) Rx(90),
  // R by nalgebra's from_euler_angles (roll, then pitch, then yaw), camera_pitch = -1.2 degrees.
  const auto json = nlohmann::json::parse(writeHulksTree(topTurned(), v6()).at(0).text);
  const auto angles = json["camera_matrix_parameters"]["vision_top"]["extrinsic_rotations"];
  const Matrix3d correction = about(Vector3d::UnitZ(), radians(angles[2])) *
                              about(Vector3d::UnitY(), radians(angles[1])) *
                              about(Vector3d::UnitX(), radians(angles[0]));
  const Matrix3d opticalFromHead = correction * about(Vector3d::UnitX(), radians(1.2)) *
                                   about(Vector3d::UnitY(), -std::numbers::pi / 2) *
                                   about(Vector3d::UnitX(), std::numbers::pi / 2);
  const Vector3d ahead = opticalFromHead.transpose() * Vector3d::UnitZ(); // the optical axis in the head
  const Vector3d right = opticalFromHead.transpose() * Vector3d::UnitX(); // of the picture
  CHECK((ahead - ourMount().col(0)).norm() < 1e-7);
  CHECK((right + ourMount().col(1)).norm() < 1e-7);
}

TEST_CASE("HULKs' files of 2019 have our rotations unchanged, and degrees") {
  // Proves units and sign of both files.
  RobotCalibration calibration = topTurned();
  calibration.offsets["RKneePitch"] = radians(-2.5);
  const auto files = writeHulks(calibration, v6());
  CHECK(nlohmann::json::parse(files.at(0).text)["rKneePitch"] == -2.5);
  CHECK(nlohmann::json::parse(files.at(1).text)["top_ext"] == nlohmann::json{0.11, -0.07, 0.19});
}

TEST_CASE("kalibr's transform takes a point from the top camera's optical frame to the bottom one's") {
  // Proves direction, axes and unit of T_cn_cnm1 on the drawing's mounts, for a point 1 m ahead of the robot's head.
  RobotCalibration calibration;
  calibration.cameras["top"].lens = calibration.cameras["bottom"].lens =
      CameraIntrinsics{640, 480, 600, 600, 320, 240, {}};
  const YAML::Node file = YAML::Load(writeKalibr(calibration, v6()).at(0).text);
  Eigen::Matrix4d bottomFromTop;
  for (int i = 0; i < 16; ++i) {
    bottomFromTop(i / 4, i % 4) = file["cam1"]["T_cn_cnm1"][i / 4][i % 4].as<double>();
  }
  const auto inOptical = [](const char* name, const Vector3d& pointInHead) {
    const CameraMount& mount = v6().cameras[*v6().cameraIndex(name)];
    const Vector3d inCamera = mount.rotation.transpose() * (pointInHead - mount.translation);
    return Vector3d{-inCamera.y(), -inCamera.z(), inCamera.x()};
  };
  const Vector3d point{1, 0.2, -0.3};
  const Eigen::Vector4d moved = bottomFromTop * inOptical("top", point).homogeneous();
  CHECK((moved.head<3>() - inOptical("bottom", point)).norm() < 1e-7);
}

TEST_CASE("kalibr's relative placement is a start for the bottom camera") {
  // Proves that a bottom mount that is turned and shifted against a nominal top one is found again.
  RobotCalibration calibration;
  calibration.cameras["top"].lens = calibration.cameras["bottom"].lens =
      CameraIntrinsics{640, 480, 600, 600, 320, 240, {}};
  calibration.cameras["bottom"].rotation = turned;
  calibration.cameras["bottom"].translation = Vector3d{0.002, -0.003, 0.001};
  const auto files = writeKalibr(calibration, v6());
  const RobotCalibration back = parseKalibr(files.at(0).text, files.at(0).name, v6()).calibration;
  CHECK((*back.cameras.at("bottom").rotation - turned).norm() < 1e-8);
  CHECK((*back.cameras.at("bottom").translation - Vector3d{0.002, -0.003, 0.001}).norm() < 1e-8);
  CHECK_FALSE(back.cameras.at("top").rotation);
}

TEST_CASE("a lens of ROS is OpenCV's matrix and five coefficients") {
  // Proves the order of entries, and that the file's name tells the camera where its content does not.
  RobotCalibration calibration;
  calibration.cameras["bottom"].lens = CameraIntrinsics{640, 480, 610, 611, 321, 242, {0.1, -0.2, 0.001, 0.002, 0.05}};
  const auto files = writeRosCameraInfo(calibration, v6());
  REQUIRE(files.size() == 1);
  const YAML::Node file = YAML::Load(files[0].text);
  CHECK(file["camera_matrix"]["data"].as<std::vector<double>>() ==
        std::vector<double>{610, 0, 321, 0, 611, 242, 0, 0, 1});
  CHECK(file["projection_matrix"]["data"].as<std::vector<double>>().size() == 12);
  CHECK(file["distortion_coefficients"]["data"].as<std::vector<double>>() ==
        std::vector<double>{0.1, -0.2, 0.001, 0.002, 0.05});
  std::string nameless = files[0].text;
  nameless.replace(nameless.find("bottom"), 6, "narrow_stereo");
  CHECK(parseRosCameraInfo(nameless, "some/top_camera.yaml", v6()).calibration.cameras.contains("top"));
  CHECK_THROWS_WITH(parseRosCameraInfo(nameless, "camera.yaml", v6()), Catch::Contains("top or bottom"));
}

TEST_CASE("angles and rotations in the three orders are inverse to each other") {
  // Proves anglesX(rotationX(a)) = a on a grid, far beyond the angles that mounts are turned by.
  for (double x = -1.2; x < 1.3; x += 0.6) {
    for (double y = -1.2; y < 1.3; y += 0.6) {
      for (double z = -3; z < 3; z += 1.5) {
        const Vector3d angles{x, y, z};
        CHECK((anglesXyz(rotationXyz(angles)) - angles).norm() < 1e-9);
        CHECK((anglesYxz(rotationYxz(angles)) - angles).norm() < 1e-9);
        CHECK((anglesZyx(rotationZyx(angles)) - angles).norm() < 1e-9);
      }
    }
  }
}

TEST_CASE("decimals are printed without an end of zeros") {
  // Proves rounding, signs and whole numbers.
  CHECK(printDecimal(radians(-2.27) * 180 / std::numbers::pi, 6) == "-2.27");
  CHECK(printDecimal(-1e-12, 6) == "0");
  CHECK(printDecimal(100, 6) == "100");
  CHECK(roundDecimal(0.1 + 0.2, 9) == 0.3);
}

} // namespace naocal

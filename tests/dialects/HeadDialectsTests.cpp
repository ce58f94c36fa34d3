#include "dialects/HeadExamples.hpp"
#include "dialects/heads/HeadDialects.hpp"
#include "io/InputError.hpp"
#include "math/Angles.hpp"
#include "robot/Kinematics.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <random>
#include <regex>

namespace naocal {
namespace {

using Eigen::AngleAxisd, Eigen::Matrix3d, Eigen::Vector3d;

constexpr double printed = 2e-8; // [rad]: six decimals of a degree, nine of a radian

Matrix3d turnAbout(const Vector3d& axis, double angle) {
  return AngleAxisd{angle, axis}.toRotationMatrix();
}
const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();

/// Optical from camera axes, written down: x right = -left, y down = -up, z forward.
const Matrix3d axes = (Matrix3d{} << 0, -1, 0, 0, 0, -1, 1, 0, 0).finished();

RobotCalibration randomHead(unsigned seed, const char* yaw = "yaw", const char* pitch = "pitch") {
  std::mt19937 random{seed};
  std::uniform_real_distribution<double> angle{-0.15, 0.15};
  RobotCalibration calibration;
  calibration.offsets = {{yaw, angle(random)}, {pitch, angle(random)}};
  calibration.cameras["left"].rotation = Vector3d{angle(random), angle(random), angle(random)};
  return calibration;
}

/// rootFromCamera of the calibrated robot by the kinematics that fit it: true angle = reading - offset.
Matrix3d calibratedCamera(const Robot& robot, const RobotCalibration& calibration, double yaw, double pitch) {
  ModelState state = nominalState(robot, StateLayout{robot.joints.size(), robot.lengths.size(), 0});
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const auto offset = calibration.offsets.find(robot.joints[i].name);
    if (offset != calibration.offsets.end()) {
      const bool isYaw = robot.joints[i].axis.isApprox(z);
      state.values[static_cast<Eigen::Index>(i)] = (isYaw ? yaw : pitch) - offset->second;
    }
  }
  const CameraMount& mount = robot.cameras.front();
  if (const auto camera = calibration.cameras.find(mount.name); camera != calibration.cameras.end()) {
    state.mountRotation() = *camera->second.rotation;
  }
  return forwardKinematics(robot, state)[mount.link].rotation * linkFromCamera(mount, state).rotation;
}

/// The numbers of a text behind a key, up to the end of its line.
std::vector<double> numbersAt(const std::string& text, const std::string& key) {
  std::size_t at = text.find(key);
  REQUIRE(at != std::string::npos);
  at += key.size();
  const std::string line = text.substr(at, text.find('\n', at) - at);
  std::vector<double> numbers;
  const std::regex number{R"([-+]?\d*\.?\d+)"};
  for (std::sregex_iterator i{line.begin(), line.end(), number}, end; i != end; ++i) {
    numbers.push_back(std::stod(i->str()));
  }
  return numbers;
}

Matrix3d rollPitchYaw(const std::vector<double>& angles) {
  return turnAbout(z, angles.at(2)) * turnAbout(y, angles.at(1)) * turnAbout(x, angles.at(0));
}

double difference(const Matrix3d& one, const Matrix3d& other) {
  return AngleAxisd{one.transpose() * other}.angle();
}

std::string write(const HeadExample& example, const RobotCalibration& calibration) {
  return findHeadDialect(example.dialect)
      ->write(example.text, "robot.file", example.robot, describeHeadCamera(example.robot, "", calibration));
}

std::string refusal(const HeadExample& example) {
  try {
    (void)write(example, randomHead(1));
  } catch (const InputError& error) {
    return error.what();
  }
  return "not refused";
}

} // namespace

TEST_CASE("the K1 of HULKs looks by its written file where the calibrated robot looks") {
  // Proves signs and orders at 20 postures of 20 heads: HULKs' formula, written here anew, from the numbers of the
  // file.
  for (const std::string& text : {hulksFile, hulksFileAtTop}) {
    const HeadExample example{"hulks-k1", text, headOf("Head_2", "eye")};
    std::mt19937 random{7};
    std::uniform_real_distribution<double> angle{-0.9, 0.9};
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const RobotCalibration calibration = randomHead(seed);
      std::string written = write(example, calibration);
      if (text == hulksFileAtTop) {
        written = std::regex_replace(written, std::regex{",\""}, ",\n\"");
      }
      const std::string comment = "/* by eye */";
      if (const auto at = written.find(comment); at != std::string::npos) {
        written.replace(at, comment.size(), "");
      }
      const auto closing = text == hulksFile ? std::string{":"} : std::string{"\":"};
      const Matrix3d inCamera =
          rollPitchYaw(numbersAt(written, text == hulksFile ? "correction_in_camera':" : "correction_in_camera\":"));
      const Matrix3d inRobot = rollPitchYaw(numbersAt(written, "correction_in_robot" + closing));
      const double mountPitch = radians(numbersAt(written, "camera_to_head_pitch" + closing).front());
      const Matrix3d opticalFromHead =
          inCamera * turnAbout(x, -mountPitch) * turnAbout(y, -M_PI / 2) * turnAbout(x, M_PI / 2);
      const double yaw = angle(random), pitch = angle(random);
      const Matrix3d robotFromHead = turnAbout(z, yaw) * turnAbout(y, pitch);
      const Matrix3d opticalFromRobot = opticalFromHead * robotFromHead.transpose() * inRobot;
      CHECK(difference(opticalFromRobot.transpose() * axes, calibratedCamera(example.robot, calibration, yaw, pitch)) <
            printed);
    }
  }
}

TEST_CASE("the Pi+ of Bit-Bots looks by its written file where the calibrated robot looks") {
  // Proves that the published transform, uncalibratedFromOptical, leads to the calibrated camera at any posture; the
  // head's yaw has no place there and is left out of both.
  const HeadExample example{"bit-bots", bitBotsFile, headOf("head", "camera_optical_frame_left_uncalibrated")};
  for (unsigned seed = 1; seed <= 20; ++seed) {
    RobotCalibration calibration = randomHead(seed);
    calibration.offsets["yaw"] = 0;
    const std::string written = write(example, calibration);
    const Matrix3d uncalibratedFromOptical =
        rollPitchYaw({numbersAt(written, "offset_x:").front(), numbersAt(written, "offset_y:").front(),
                      numbersAt(written, "offset_z:").front()});
    ModelState state = nominalState(example.robot, StateLayout{2, 0, 0});
    state.values[0] = 0.3;
    state.values[1] = -0.2;
    const Matrix3d rootFromUncalibrated =
        forwardKinematics(example.robot, state)[*example.robot.linkIndex("camera_optical_frame_left_uncalibrated")]
            .rotation;
    CHECK(difference(rootFromUncalibrated * uncalibratedFromOptical * axes,
                     calibratedCamera(example.robot, calibration, 0.3, -0.2)) < printed);
  }
}

TEST_CASE("a NUgus and a K1 of NUbots look by their written files where the calibrated robot looks") {
  // Proves Rx(yaw) Rz(pitch) Ry(roll) in front of the URDF's camera, and of the file's own frame; and the frame alone.
  for (const std::string& text : {nugusFile, k1File, k1FileOfAngles}) {
    const bool isNugus = text == nugusFile;
    const HeadExample example{"nubots", text, headOf(isNugus ? "head" : "Head_2", isNugus ? "left_camera" : "eye")};
    for (unsigned seed = 1; seed <= 20; ++seed) {
      RobotCalibration calibration = randomHead(seed);
      calibration.offsets["yaw"] = 0;
      const std::string written = write(example, calibration);
      Matrix3d pitchFromCamera = isNugus ? rollPitchYaw({0.02, -0.03, 0.04}) * rollPitchYaw({-0.01, 0.05, 0.02})
                                         : rollPitchYaw(numbersAt(written, "rotation_rpy:"));
      if (text != k1FileOfAngles) {
        const auto offset = [&](const char* key) {
          const auto numbers = numbersAt(written, key);
          REQUIRE(numbers.at(1) == 180);
          return numbers.at(0) * M_PI / 180;
        };
        pitchFromCamera = turnAbout(x, offset("yaw_offset:")) * turnAbout(z, offset("pitch_offset:")) *
                          turnAbout(y, offset("roll_offset:")) * pitchFromCamera;
      }
      const double yaw = 0.4, pitch = -0.3;
      CHECK(difference(turnAbout(z, yaw) * turnAbout(y, pitch) * pitchFromCamera,
                       calibratedCamera(example.robot, calibration, yaw, pitch)) < printed);
    }
  }
}

TEST_CASE("what was written of a head is read and written again to the same digit") {
  for (const HeadExample& example : headExamples()) {
    for (unsigned seed = 1; seed <= 50; ++seed) {
      INFO(example.dialect << ", seed " << seed);
      const HeadDialect& dialect = *findHeadDialect(example.dialect);
      const std::string written = write(example, randomHead(seed));
      const HeadCamera drawn = describeHeadCamera(example.robot, "left", {});
      const HeadDirection direction = dialect.parse(written, "robot.file", example.robot, drawn);
      CHECK(direction.unused.empty());
      CHECK(direction.baseOffset.has_value() == dialect.hasBase);
      const RobotCalibration back = calibrationFromDirection(drawn, direction.neckFromCamera, direction.baseOffset);
      HeadExample again = example;
      again.text = written;
      CHECK(write(again, back) == written);
    }
  }
}

TEST_CASE("numbers of a head that a calibration does not know stay in the file") {
  // Proves it for the direction of the camera and the yaw's offset, each without the other, and for nothing known.
  RobotCalibration direction = randomHead(5), yaw;
  yaw.offsets["yaw"] = direction.offsets.extract("yaw").mapped();
  for (const HeadExample& example : headExamples()) {
    INFO(example.dialect);
    CHECK(write(example, {}) == example.text);
    CHECK(write(example, direction) != example.text);
    CHECK((write(example, yaw) == example.text) == (example.dialect != "hulks-k1"));
  }
  const HeadExample example{"hulks-k1", hulksFile, headOf("Head_2", "eye")};
  CHECK(write(example, direction).find("correction_in_robot: [0.0, 0.5 /* by eye */, 0.0,]") != std::string::npos);
  CHECK(write(example, yaw).find("'correction_in_camera': [.1, +0.0, -0.2]") != std::string::npos);
}

TEST_CASE("everything else in a file stays to the byte") {
  // Proves comments, tabs, quotes, order and other keys: what differs between the texts are numbers alone.
  RobotCalibration calibration;
  calibration.offsets = {{"yaw", 0.01}, {"pitch", 0}};
  calibration.cameras["left"].rotation = Vector3d::Zero();
  const std::regex number{R"([-+]?\d*\.?\d+( \* pi / 180)?)"};
  for (HeadExample example : headExamples()) {
    const std::string written = write(example, calibration);
    CHECK(written != example.text);
    example.text = std::regex_replace(example.text, std::regex{R"(-\(3 \+ 0\.8\))"}, "1");
    CHECK(std::regex_replace(written, number, "N") == std::regex_replace(example.text, number, "N"));
  }
  CHECK(write({"bit-bots", bitBotsFile, headOf("head", "camera_optical_frame_left_uncalibrated")}, calibration)
            .ends_with(bitBotsFile.substr(bitBotsFile.find("\n/bitbots_extrinsic_imu"))));
}

TEST_CASE("files and robots of another kind are refused with what to do") {
  const Robot k1 = headOf("Head_2", "eye");
  CHECK(refusal({"hulks-k1", "{a: ", k1}).find("expected valid YAML") != std::string::npos);
  CHECK(refusal({"hulks-k1", "{}", k1}).find("expected the key") != std::string::npos);
  CHECK(refusal({"hulks-k1", "{camera_matrix_parameters: {}, correction_in_camera: [0, 0, 0]}", k1}).find("once") !=
        std::string::npos);
  CHECK(refusal({"bit-bots", bitBotsFile, k1}).find("camera_optical_frame_left_uncalibrated") != std::string::npos);
  CHECK(refusal({"nubots", nugusFile, k1}).find("expected the camera of a NUgus") != std::string::npos);
  CHECK(refusal({"nubots", "lens: 1\n", k1}).find("Hpc") != std::string::npos);
  Robot mirrored = headOf("Head_2", "eye");
  mirrored.joints[1].axis = -y;
  CHECK(refusal({"hulks-k1", hulksFile, mirrored}).find("pitch about") != std::string::npos);
  Robot two = headOf("Head_2", "eye");
  two.cameras.push_back(two.cameras.front());
  two.cameras.back().name = "right";
  CHECK(refusal({"hulks-k1", hulksFile, two}).find("left, right") != std::string::npos);
  const HeadDialect& nubots = *findHeadDialect("nubots");
  CHECK_THROWS_WITH(nubots.parse("Hpc:\n  rotation_rpy: [0, 0, 0]\n  roll_offset: one\n", "K1Sensors.yaml", k1,
                                 describeHeadCamera(k1, "", {})),
                    Catch::Contains("line 3") && Catch::Contains("1.5 * pi / 180"));
}

TEST_CASE("the drawings of the K1 and of the Pi+ have what their teams' files need") {
  const Robot k1 = loadRobot(configurationDirectory(), "K1");
  const HeadExample example{"hulks-k1", hulksFile, k1};
  const RobotCalibration calibration = randomHead(3, "AAHead_yaw", "Head_pitch");
  const HeadDirection direction =
      findHeadDialect("hulks-k1")->parse(write(example, calibration), "k1.json5", k1, describeHeadCamera(k1, "", {}));
  CHECK(std::abs(*direction.baseOffset - calibration.offsets.at("AAHead_yaw")) < 1e-9);
  CHECK(difference(direction.neckFromCamera, describeHeadCamera(k1, "", calibration).calibrated->rotation) < printed);
}

} // namespace naocal

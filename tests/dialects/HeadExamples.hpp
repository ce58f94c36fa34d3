#pragma once

#include "robot/Robot.hpp"
#include "robot/Urdf.hpp"

#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace naocal {

/// A head with the names and axes that all three teams' robots share, its camera turned and its mount in two fixed
/// steps.
inline Robot headOf(const std::string& neckLink, const std::string& cameraLink) {
  Robot robot = parseUrdf(
      R"(<robot name="head"><link name="trunk"/><link name="yawed"/><link name=")" + neckLink + R"("/>
  <link name="eyes"/><link name=")" +
          cameraLink + R"("/>
  <joint name="yaw" type="revolute"><parent link="trunk"/><child link="yawed"/><origin xyz="0.0056 0 0.2149"/><axis xyz="0 0 1"/><limit lower="-1" upper="1" velocity="1" effort="1"/></joint>
  <joint name="pitch" type="revolute"><parent link="yawed"/><child link=")" +
          neckLink +
          R"("/><origin xyz="0 0 0.033"/><axis xyz="0 1 0"/><limit lower="-1" upper="1" velocity="1" effort="1"/></joint>
  <joint name="bridge" type="fixed"><parent link=")" +
          neckLink + R"("/><child link="eyes"/><origin xyz="0.05 0.005 0.06" rpy="0.02 -0.03 0.04"/></joint>
  <joint name="eye" type="fixed"><parent link="eyes"/><child link=")" +
          cameraLink + R"("/><origin xyz="0.03 0.02 0" rpy="-0.01 0.05 0.02"/></joint>
  </robot>)",
      "head.urdf");
  robot.cameras.push_back(
      {.name = "left",
       .link = *robot.linkIndex(cameraLink),
       .translation = {0.001, 0.002, 0.003},
       .rotation = (Eigen::AngleAxisd{0.1, Eigen::Vector3d::UnitZ()} * Eigen::AngleAxisd{0.2, Eigen::Vector3d::UnitY()})
                       .toRotationMatrix()});
  return robot;
}

inline const std::string hulksFile = R"({
  // K1, measured in the lab's "corner" — don't touch
  camera_matrix_parameters: {
    camera_to_head_pitch: -0.2125811028, /* degrees */
	correction_in_robot: [0.0, 0.5 /* by eye */, 0.0,],
    'correction_in_camera': [.1, +0.0, -0.2],
  },
  synchronization: { max: "http://0" },
}
)";
inline const std::string hulksFileAtTop =
    R"({"correction_in_camera":[0,0,0],"correction_in_robot":[0,0,0],"camera_to_head_pitch":3.5})";
inline const std::string bitBotsFile = R"(# Pi+ "pink"
/bitbots_extrinsic_camera_calibration:
  ros__parameters:
    offset_x: 0.4   # by eye
    offset_y: 0.0
    offset_z: 0.0

/bitbots_extrinsic_imu_calibration:
  ros__parameters:
    offset_x: 0.0
    offset_y: 0.085
)";
inline const std::string nugusFile = R"(serial_number: 0118847F
lens: {fov: auto, k: [0.38, 0.14]}
is_left_camera: true
roll_offset: 0.19879790552406168 * pi / 180
pitch_offset: "-(3 + 0.8) * pi / 180" # measured
yaw_offset: 0.05
)";
inline const std::string k1File = R"(log_level: INFO
Hpc:
  translation: [0.065, 0.035, 0.0915]
  rotation_rpy: [-0.0425, 0.0175, -0.09]
  roll_offset: 0.0
  pitch_offset: 0.0
  yaw_offset: 0.0
)";
inline const std::string k1FileOfAngles =
    "Hpc:\n  translation: [0, 0, 0]\n  rotation_rpy: [-0.0425, 0.0175, -0.09] # rad\n";

/// A file of a dialect, and a robot that it is for.
struct HeadExample {
  std::string dialect, text;
  Robot robot;
};

inline std::vector<HeadExample> headExamples() {
  return {{"hulks-k1", hulksFile, headOf("Head_2", "eye")},
          {"hulks-k1", hulksFileAtTop, headOf("Head_2", "eye")},
          {"bit-bots", bitBotsFile, headOf("head", "camera_optical_frame_left_uncalibrated")},
          {"nubots", nugusFile, headOf("head", "left_camera")},
          {"nubots", k1File, headOf("Head_2", "eye")},
          {"nubots", k1FileOfAngles, headOf("Head_2", "eye")}};
}

} // namespace naocal

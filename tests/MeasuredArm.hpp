#pragma once

#include "io/Files.hpp"
#include "robot/Kinematics.hpp"
#include "robot/Urdf.hpp"

#include <Eigen/Geometry>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

namespace naocal {

/// Two turning joints, a slide and a turning hand.
inline const std::string measuredArmUrdf = R"(<robot name="arm">
  <link name="base"/><link name="upper"><inertial><origin xyz="0 0.02 0.2"/><mass value="1.5"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <link name="fore"><inertial><origin xyz="0.1 0 0.1"/><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <link name="slider"/><link name="hand"/>
  <joint name="turn" type="revolute"><parent link="base"/><child link="upper"/><origin xyz="0 0 0.3"/><axis xyz="0 0 1"/><limit lower="-3" upper="3" velocity="1" effort="1"/></joint>
  <joint name="lift" type="revolute"><parent link="upper"/><child link="fore"/><origin xyz="0.05 0 0.4" rpy="0 0.3 0.2"/><axis xyz="0 1 0"/><limit lower="-3" upper="3" velocity="1" effort="1"/></joint>
  <joint name="slide" type="prismatic"><parent link="fore"/><child link="slider"/><origin xyz="0.2 0 0.1" rpy="0 0.2 0"/><axis xyz="1 0 0"/><limit lower="0" upper="0.3" velocity="1" effort="1"/></joint>
  <joint name="roll" type="revolute"><parent link="slider"/><child link="hand"/><origin xyz="0.2 0 0" rpy="0 0 -0.7"/><axis xyz="0.6 0 0.8"/><limit lower="-3" upper="3" velocity="1" effort="1"/></joint>
</robot>)";

/// What an arm's captures hold.
struct ArmReadings {
  bool points = true, frames = true, contacts = true, corners = false;
  double gain = 0;     // of the encoder of "lift": an effect that the base model lacks
  double jump = 0;     // of the zero of "turn" in the middle of the captures [rad]; no smooth effect
  bool column = false; // "turn" is a slide, along which the arm moves up and down
  std::array<double, 4> motion{1, 1, 1, 1}; // of each joint, relative to the usual
};

/// A capture set of an arm in a folder: readings of a tracker in another frame, touches of two places, and pictures of
/// a camera beside the arm, each with noise. The zeros of "lift" and "slide" are off.
inline void writeArmSet(const std::filesystem::path& folder, const ArmReadings& holds = {}) {
  using nlohmann::json;
  std::string urdf = measuredArmUrdf;
  if (holds.column) {
    urdf.replace(urdf.find("revolute"), std::string{"revolute"}.size(), "prismatic");
  }
  const Robot robot = parseUrdf(urdf, "arm.urdf");
  const RigidTransform worldFromTracker = transformFromPlacement((Twist{} << 1, -2, 0.5, 0.2, -0.3, 0.4).finished()),
                       handFromFrame = transformFromPlacement((Twist{} << 0.02, 0.03, 0.1, 0.4, 0.2, -1).finished());
  const Eigen::Vector3d ball{0.03, -0.02, 0.12}, tip{-0.05, 0.02, 0.1};
  const Eigen::Vector4d zeros{0, 0.03, 0.004, 0};
  constexpr double sigma = 0.0003, sigmaTurn = 0.0005, pixel = 0.2;
  std::mt19937_64 random{5};
  std::uniform_real_distribution<double> uniform{-1, 1};
  std::normal_distribution<double> normal;
  const auto noise = [&](double size) {
    return Eigen::Vector3d{size * normal(random), size * normal(random), size * normal(random)};
  };
  const auto list = [](const Eigen::Vector3d& point) { return json{point.x(), point.y(), point.z()}; };
  json set{{"format", "naocal-captures"},
           {"version", 2},
           {"robot", {{"urdf", "arm.urdf"}, {"id", "lab"}}},
           {"jointNames", {"turn", "lift", "slide", "roll"}},
           {"trackers", {{"laser", {{"sigma", sigma}, {"sigmaRotation", sigmaTurn}}}}},
           {"markers",
            {{{"id", "ball"}, {"link", "hand"}, {"pointGuess", {0, 0, 0.1}}},
             {{"id", "tip"}, {"link", "hand"}, {"pointGuess", {0, 0, 0.1}}}}},
           {"frames", {{{"id", "tool"}, {"link", "hand"}}}},
           {"places", json::array()},
           {"contactSigma", sigma},
           {"stances", {{{"id", 0}}}},
           {"captures", json::array()}};
  if (holds.corners) { // looks along +y of the world, from in front of the arm
    set["cameras"]["side"] = {{"link", "world"},
                              {"axes", "optical"},
                              {"width", 1280},
                              {"height", 960},
                              {"fx", 900},
                              {"fy", 900},
                              {"cx", 640},
                              {"cy", 480},
                              {"distortion", {0, 0, 0, 0, 0}},
                              {"placementGuess", {{"x", 0.1}, {"y", -3}, {"z", 0.8}, {"roll", -1.5708}}}};
    set["boards"] = {{{"id", "palm"},
                      {"link", "hand"},
                      {"points", {{0, 0, 0}, {0.06, 0, 0}, {0, 0.06, 0}, {0.06, 0.06, 0.03}}},
                      {"placement", {{"x", 0.02}, {"y", 0}, {"z", 0.05}, {"roll", 0}, {"pitch", 0}, {"yaw", 0}}}}};
  }
  for (int i = 0; i < 30; ++i) {
    Eigen::Vector4d read{1.5 * uniform(random), uniform(random), 0.1 * uniform(random), 2 * uniform(random)};
    read = read.cwiseProduct(Eigen::Vector4d{holds.motion.data()}) + Eigen::Vector4d{0, 0, 0.15, 0};
    Eigen::Vector4d there = read - zeros;
    there[1] -= holds.gain * read[1];
    there[0] -= i >= 15 ? holds.jump : 0;
    const RigidTransform hand = forwardKinematics(robot, Eigen::VectorXd{there})[*robot.linkIndex("hand")];
    json capture{{"id", i},     {"pose", "P" + std::to_string(i)},
                 {"repeat", 0}, {"time", 2.0 * i},
                 {"stance", 0}, {"joints", {{"measured", std::vector<double>(read.begin(), read.end())}}}};
    for (const auto& [marker, point] : {std::pair{"ball", ball}, std::pair{"tip", tip}}) {
      if (holds.points) {
        capture["points"].push_back({{"tracker", "laser"},
                                     {"marker", marker},
                                     {"xyz", list(worldFromTracker.inverse() * (hand * point) + noise(sigma))}});
      }
    }
    if (holds.frames) {
      const RigidTransform frame = worldFromTracker.inverse() * hand * handFromFrame;
      const Eigen::Vector3d turn = noise(sigmaTurn);
      const Eigen::Quaterniond q{Eigen::AngleAxisd{turn.norm(), turn.normalized()}.toRotationMatrix() * frame.rotation};
      capture["frames"].push_back({{"tracker", "laser"},
                                   {"frame", "tool"},
                                   {"xyz", list(frame.translation + noise(sigma))},
                                   {"quaternion", {q.w(), q.x(), q.y(), q.z()}}});
    }
    if (holds.contacts) {
      const std::string place = "hole " + std::to_string(i);
      set["places"].push_back({{"id", place}, {"point", list(hand * ball + noise(sigma))}});
      capture["contacts"].push_back({{"marker", "ball"}, {"place", place}});
    }
    if (holds.corners) {
      json uv = json::array();
      for (const json& corner : set["boards"][0]["points"]) {
        const Eigen::Vector3d onBoard{corner[0].get<double>() + 0.02, corner[1].get<double>(),
                                      corner[2].get<double>() + 0.05};
        const Eigen::Vector3d at = hand * onBoard - Eigen::Vector3d{0.1, -3, 0.8}; // camera x = world x, y = -z, z = y
        uv.push_back({640 + 900 * at.x() / at.y() + pixel * normal(random),
                      480 - 900 * at.z() / at.y() + pixel * normal(random)});
      }
      capture["camera"] = "side";
      capture["corners"].push_back({{"board", "palm"}, {"ids", {0, 1, 2, 3}}, {"uv", std::move(uv)}});
    }
    set["captures"].push_back(std::move(capture));
  }
  std::filesystem::create_directories(folder);
  writeAtomically(folder / "arm.urdf", urdf);
  writeAtomically(folder / "captures.json", set.dump());
}

} // namespace naocal

#pragma once

#include "TemporaryFolder.hpp"
#include "diagnosis/SimulatedSets.hpp"
#include "io/Files.hpp"
#include "math/Angles.hpp"
#include "poses/PoseFile.hpp"
#include "robot/RobotOfSet.hpp"
#include "scenes/SceneSimulation.hpp"
#include "setups/SetUp.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace naocal {

/// Arm of six joints in the proportions of an industrial one; the wrist's axes do not meet.
inline constexpr char sixJointUrdf[] = R"(<robot name="six"><link name="base"/><link name="l1"/><link name="l2"/>
  <link name="l3"/><link name="l4"/><link name="l5"/><link name="hand"/>
  <joint name="pan" type="revolute"><parent link="base"/><child link="l1"/><origin xyz="0 0 0.16"/>
    <axis xyz="0 0 1"/><limit lower="-2" upper="2" effort="1" velocity="1"/></joint>
  <joint name="lift" type="revolute"><parent link="l1"/><child link="l2"/><origin xyz="0 0.13 0"/>
    <axis xyz="0 1 0"/><limit lower="-1.2" upper="1.2" effort="1" velocity="1"/></joint>
  <joint name="elbow" type="revolute"><parent link="l2"/><child link="l3"/><origin xyz="0.42 -0.12 0"/>
    <axis xyz="0 1 0"/><limit lower="-1.5" upper="1.5" effort="1" velocity="1"/></joint>
  <joint name="wrist1" type="revolute"><parent link="l3"/><child link="l4"/><origin xyz="0.39 0 0"/>
    <axis xyz="0 1 0"/><limit lower="-1.5" upper="1.5" effort="1" velocity="1"/></joint>
  <joint name="wrist2" type="revolute"><parent link="l4"/><child link="l5"/><origin xyz="0 0.1 0"/>
    <axis xyz="0 0 1"/><limit lower="-1.5" upper="1.5" effort="1" velocity="1"/></joint>
  <joint name="wrist3" type="revolute"><parent link="l5"/><child link="hand"/><origin xyz="0.1 0 0"/>
    <axis xyz="1 0 0"/><limit lower="-1.5" upper="1.5" effort="1" velocity="1"/></joint></robot>)";

/// A robot in some scene, as captures that are right.
struct Twin {
  std::string name;
  Recording right;
};

/// How a twin is simulated.
struct TwinPlan {
  std::uint64_t seed = 1;
  std::vector<std::string> flaws = {};
  std::size_t poses = 20;
  std::vector<PlayablePose> given = {}; // instead of random ones
};

inline Twin makeArmTwin(const TemporaryFolder& folder, const std::string& name, const std::string& scene,
                        const TwinPlan& plan) {
  writeAtomically(folder.path() / "six.urdf", sixJointUrdf);
  const RobotScene drawn = parseRobotScene(R"({"format": "naocal-scene", "version": 1, )" + scene + "}", "scene.json",
                                           makeRobotOnly((folder.path() / "six.urdf").string(), SupportFoot::left));
  CaptureSet set = simulateScene(drawn, {.poses = plan.poses,
                                         .given = plan.given,
                                         .samples = 1,
                                         .offsetRange = radians(2),
                                         .flaws = plan.flaws,
                                         .seed = plan.seed})
                       .set;
  Robot robot = loadRobot(set);
  return {name, {{std::move(set)}, std::move(robot)}};
}

/// Poses of that arm, in all but the last `moving` of which the lift stands still.
inline std::vector<PlayablePose> withStillLift(std::size_t poses, std::size_t moving) {
  std::mt19937_64 random{9};
  std::uniform_real_distribution<double> angle{-1, 1};
  std::vector<PlayablePose> result;
  for (std::size_t i = 0; i < poses; ++i) {
    PlayablePose pose{
        .id = "P" + std::to_string(i), .angles = Eigen::VectorXd(6), .approach = Eigen::VectorXd::Zero(6)};
    for (double& one : pose.angles) {
      one = angle(random);
    }
    pose.angles[1] = i + moving < poses ? -0.7 : pose.angles[1];
    result.push_back(pose);
  }
  return result;
}

/// Three markers on the hand before a tracker whose noise and place nobody tells.
inline Twin armBeforeTracker(const TemporaryFolder& folder, std::uint64_t seed,
                             const std::vector<std::string>& flaws = {}, std::vector<PlayablePose> given = {}) {
  return makeArmTwin(folder, "points", R"(
    "trackers": {"vicon": {"about": {"x": 2, "y": 0.3, "z": 1, "yaw": 3}}},
    "markers": [{"id": "a", "link": "hand", "about": [0.1, 0.05, 0.02]},
                {"id": "b", "link": "hand", "about": [-0.03, 0.04, 0.1]}],
    "slipSteps": {"lift": 0.4, "elbow": 0.3})",
                     {seed, flaws, 24, std::move(given)});
}

/// A frame on the hand, measured in 6-D.
inline Twin armByFrames(const TemporaryFolder& folder, std::uint64_t seed, const std::vector<std::string>& flaws = {}) {
  return makeArmTwin(folder, "frames", R"(
    "trackers": {"laser": {"sigma": 0.0003, "about": {"x": 2, "y": 0.3, "z": 1, "yaw": 3}}},
    "frames": [{"id": "tool", "link": "hand", "about": {"x": 0.1, "yaw": 0.5, "roll": 0.4}}])",
                     {seed, flaws, 20});
}

/// A camera on the hand before a board.
inline Twin armWithCamera(const TemporaryFolder& folder, std::uint64_t seed,
                          const std::vector<std::string>& flaws = {}) {
  return makeArmTwin(folder, "wrist camera", R"(
    "cameras": {"eye": {"link": "hand", "axes": "forward", "width": 640, "height": 480, "fx": 600, "fy": 600, "cx": 320,
                        "cy": 240, "distortion": [0, 0, 0, 0, 0]}},
    "boards": [{"id": "plate", "link": "world", "dictionary": "DICT_4X4_100", "squaresX": 7, "squaresY": 5,
                "squareLength": 0.05, "markerLength": 0.035, "about": {"x": 1.4, "z": 0.2, "pitch": -1.57}}])",
                     {seed, flaws, 16});
}

/// A standing NAO before boards on the floor.
inline Twin naoBeforeBoards(std::uint64_t seed) {
  return {"NAO", {{simulatedSet(12, seed)}, loadRobot(configurationDirectory(), "V6")}};
}

/// A mistake and how it spoils captures that are right.
struct Spoiling {
  std::string label;
  std::function<void(Recording&)> apply;
};

namespace spoiling {

inline double& reading(const CaptureSet& set, Capture& capture, const std::string& joint) {
  const auto found = std::find(set.jointNames.begin(), set.jointNames.end(), joint);
  return capture.joints.measured[static_cast<std::size_t>(found - set.jointNames.begin())];
}

/// Changes every capture of the first set.
inline std::function<void(Recording&)> everyCapture(const std::function<void(const CaptureSet&, Capture&)>& change) {
  return [change](Recording& recording) {
    CaptureSet& set = recording.sets.front();
    for (Capture& capture : set.captures) {
      change(set, capture);
    }
  };
}

inline Spoiling reverse(const std::string& joint) {
  return {"reversedJoint@" + joint,
          everyCapture([=](const CaptureSet& set, Capture& capture) { reading(set, capture, joint) *= -1; })};
}

inline Spoiling swapJoints(const std::string& one, const std::string& other) {
  return {"swappedJoints@" + one + ',' + other, everyCapture([=](const CaptureSet& set, Capture& capture) {
            std::swap(reading(set, capture, one), reading(set, capture, other));
          })};
}

inline Spoiling giveInDegrees(const std::string& joint) {
  return {"columnUnit@" + joint, everyCapture([=](const CaptureSet& set, Capture& capture) {
            reading(set, capture, joint) = degrees(reading(set, capture, joint));
          })};
}

/// Every joint but one was written in radians and read as degrees.
inline Spoiling readAllAsDegrees(const std::string& right) {
  return {"columnUnit@" + right, everyCapture([=](const CaptureSet& set, Capture& capture) {
            for (const std::string& joint : set.jointNames) {
              reading(set, capture, joint) *= joint == right ? 1 : radians(1);
            }
          })};
}

inline Spoiling countFrom(const std::string& joint, const std::string& other, double sign, double from) {
  return {"countedFrom@" + joint + ',' + other, everyCapture([=](const CaptureSet& set, Capture& capture) {
            reading(set, capture, joint) += sign * (reading(set, capture, other) - from);
          })};
}

inline Spoiling slipCount(const std::string& joint, double turns) {
  return {"countSlip@" + joint, everyCapture([=](const CaptureSet& set, Capture& capture) {
            reading(set, capture, joint) += turns * set.slipSteps.at(joint);
          })};
}

/// Changes positions and rotations that a tracker reads.
inline std::function<void(Recording&)>
everyReading(const std::function<void(Eigen::Vector3d& xyz, Eigen::Quaterniond* rotation)>& change) {
  return everyCapture([=](const CaptureSet&, Capture& capture) {
    for (PointReading& point : capture.points) {
      change(point.xyz, nullptr);
    }
    for (FrameReading& frame : capture.frames) {
      change(frame.xyz, &frame.rotation);
    }
  });
}

inline Spoiling giveInMillimetres(const std::string& tracker, const std::string& axes) {
  return {"columnUnit@" + tracker, everyReading([=](Eigen::Vector3d& xyz, Eigen::Quaterniond*) {
            for (const char axis : axes) {
              xyz[axis - 'x'] *= 1000;
            }
          })};
}

inline Spoiling mirror(const std::string& tracker, const Eigen::Matrix3d& matrix) {
  return {"mirroredTracker@" + tracker, everyReading([=](Eigen::Vector3d& xyz, Eigen::Quaterniond* rotation) {
            xyz = matrix * xyz;
            if (rotation) {
              *rotation = Eigen::Quaterniond{Eigen::Matrix3d{matrix * rotation->toRotationMatrix() * matrix}};
            }
          })};
}

inline Spoiling reorderQuaternions(const std::string& tracker) {
  return {"quaternionOrder@" + tracker, everyReading([](Eigen::Vector3d&, Eigen::Quaterniond* q) {
            *q = Eigen::Quaterniond{q->x(), q->y(), q->z(), q->w()};
          })};
}

inline Spoiling invertFrames(const std::string& tracker) {
  return {"inverseFrames@" + tracker, everyReading([](Eigen::Vector3d& xyz, Eigen::Quaterniond* q) {
            *q = q->conjugate();
            xyz = -(*q * xyz);
          })};
}

/// `id`: "all" for every board.
inline Spoiling scaleSquares(const std::string& id, double factor) {
  return {"squareSize@" + id, [=](Recording& recording) {
            for (Board& board : recording.sets.front().boards) {
              for (Eigen::Vector3d& point : board.points) {
                point *= board.id == id || id == "all" ? factor : 1;
              }
            }
          }};
}

inline Spoiling turnCamera(const std::string& camera, const Eigen::Matrix3d& turn) {
  return {"cameraAxes@" + camera, [=](Recording& recording) {
            Eigen::Matrix3d& mount = recording.robot.cameras[*recording.robot.cameraIndex(camera)].rotation;
            mount = mount * turn;
          }};
}

/// Row i has the angles of row i + `shift`; rows share what they read.
inline Spoiling shiftTime(std::ptrdiff_t shift) {
  return {"timeShift", [=](Recording& recording) {
            std::vector<Capture>& captures = recording.sets.front().captures;
            std::vector<JointReadings> rows;
            std::vector<std::size_t> rowOf;
            for (const Capture& capture : captures) {
              if (rows.empty() || rows.back().measured != capture.joints.measured) {
                rows.push_back(capture.joints);
              }
              rowOf.push_back(rows.size() - 1);
            }
            std::vector<Capture> shifted;
            for (std::size_t i = 0; i < captures.size(); ++i) {
              const auto from = static_cast<std::ptrdiff_t>(rowOf[i]) + shift;
              if (from >= 0 && from < std::ssize(rows)) {
                shifted.push_back(captures[i]);
                shifted.back().joints = rows[static_cast<std::size_t>(from)];
              }
            }
            captures = std::move(shifted);
          }};
}

/// The file names a link further out than that on which a marker or a frame sits, or nearer.
inline Spoiling nameOtherLink(const std::string& id, const std::string& link) {
  return {"otherLink@" + id, [=](Recording& recording) {
            Instruments& instruments = recording.sets.front().instruments;
            for (TrackedMarker& marker : instruments.markers) {
              marker.link = marker.id == id ? link : marker.link;
            }
            for (TrackedFrame& frame : instruments.frames) {
              frame.link = frame.id == id ? link : frame.link;
            }
          }};
}

inline Spoiling swapCameras() {
  return {"swappedCameras@bottom,top", everyCapture([](const CaptureSet&, Capture& capture) {
            capture.camera = capture.camera == "top" ? "bottom" : "top";
          })};
}

} // namespace spoiling

/// Mistakes of every kind that a twin can have; which joints, boards and signs, the seed draws.
inline std::vector<Spoiling> drawSpoilings(const Twin& twin, std::uint64_t seed) {
  using namespace spoiling;
  std::mt19937_64 random{seed};
  const bool isNao = twin.name == "NAO";
  const std::vector<std::string> joints =
      isNao ? std::vector<std::string>{"HeadYaw",    "HeadPitch",   "LHipRoll",  "LHipPitch",
                                       "LKneePitch", "LAnklePitch", "LAnkleRoll"}
            : std::vector<std::string>{"pan", "lift", "elbow", "wrist1", "wrist2", "wrist3"};
  const auto draw = [&](std::size_t count) { return static_cast<std::size_t>(random() % count); };
  const std::size_t first = draw(joints.size() - 1), second = first + 1 + draw(joints.size() - 1 - first);
  const std::size_t outer = (isNao ? 2 : 1) + draw(joints.size() - (isNao ? 3 : 2));
  const auto turn = [](double angle, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd{angle, axis}.toRotationMatrix();
  };
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), z = Eigen::Vector3d::UnitZ();
  std::vector<Spoiling> all{reverse(joints[draw(joints.size())]), swapJoints(joints[first], joints[second]),
                            giveInDegrees(joints[draw(joints.size())]),
                            countFrom(joints[outer + 1], joints[outer], draw(2) == 0 ? 1 : -1, draw(2) == 0 ? 0 : 0.6),
                            shiftTime(draw(2) == 0 ? 1 : -1)};
  if (!isNao) {
    all.push_back(readAllAsDegrees(joints[draw(joints.size())]));
  }
  if (twin.name == "points") {
    Eigen::Matrix3d exchanged = Eigen::Matrix3d::Identity();
    exchanged.col(1).swap(exchanged.col(2));
    all.push_back(mirror("vicon", draw(2) == 0 ? exchanged : Eigen::Matrix3d{Eigen::Vector3d{1, -1, 1}.asDiagonal()}));
    all.push_back(giveInMillimetres("vicon", "xyz"));
    all.push_back(giveInMillimetres("vicon", "z"));
    all.push_back(nameOtherLink("a", "l5"));
    all.push_back(slipCount(draw(2) == 0 ? "lift" : "elbow", draw(2) == 0 ? 1 : -1));
  }
  if (twin.name == "frames") {
    all.push_back(reorderQuaternions("laser"));
    all.push_back(invertFrames("laser"));
    all.push_back(mirror("laser", Eigen::Vector3d{1, 1, -1}.asDiagonal()));
    all.push_back(giveInMillimetres("laser", "xyz"));
    all.push_back(nameOtherLink("tool", "l5"));
  }
  if (twin.name == "wrist camera") {
    all.push_back(
        turnCamera("eye", draw(2) == 0 ? opticalFromCamera() : Eigen::Matrix3d{opticalFromCamera().transpose()}));
    all.push_back(turnCamera("eye", turn(draw(2) == 0 ? radians(90) : radians(180), x)));
    for (const double factor : {10.0, 1000.0, 1 / 25.4, 1.3}) {
      all.push_back(scaleSquares("plate", factor));
    }
  }
  if (isNao) {
    all.push_back(turnCamera("top", turn(radians(180), x)));
    all.push_back(turnCamera("bottom", turn(radians(90), z)));
    all.push_back(scaleSquares("all", draw(2) == 0 ? 10 : 0.1));
    all.push_back(scaleSquares("A", 1.3));
    all.push_back(swapCameras());
  }
  return all;
}

} // namespace naocal

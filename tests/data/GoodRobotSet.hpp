#pragma once

#include <nlohmann/json.hpp>

namespace naocal {

/// A set of version 2 that uses every feature of robots with a URDF and of further measurements, without unknown keys.
inline nlohmann::json goodRobotSet() {
  return nlohmann::json::parse(R"({
    "format": "naocal-captures", "version": 2,
    "robot": {"urdf": "robot.urdf", "base": "base_link", "id": "lab"},
    "jointNames": ["pan", "lift"],
    "cameras": {
      "wrist": {"link": "hand", "axes": "forward", "placement": {"x": 0.01, "pitch": 0.2},
                "placementSigma": {"x": 0.01, "roll": 0.02}, "width": 640, "height": 480, "fx": 600, "fy": 601,
                "cx": 320, "cy": 240, "distortion": [0, 0, 0, 0, 0]},
      "side": {"link": "world", "axes": "optical", "placementGuess": {"x": 1, "yaw": 0.5}, "width": 1280,
               "height": 720, "fx": 900, "fy": 901, "cx": 640, "cy": 360, "distortion": [0.1, 0, 0, 0, 0]}},
    "boards": [{"id": "plate", "link": "world", "points": [[0, 0, 0], [0.027, 0, 0], [0, 0.027, 0]]},
               {"id": "palm", "link": "hand", "points": [[0, 0, 0]],
                "placement": {"x": 0.1, "y": 0, "z": 0.02}}],
    "trackers": {"vicon": {"sigma": 0.0005, "placement": {"z": 1}}, "laser": {"sigmaRotation": 0.001}},
    "markers": [{"id": "ball", "link": "hand", "pointGuess": [0, 0, 0.1], "pointSigma": 0.05},
                {"id": "tip", "link": "hand", "point": [0.1, 0.2, 0.3]}],
    "frames": [{"id": "tool", "link": "hand", "placement": {"x": 0.1, "yaw": 1}}, {"id": "free", "link": "hand"}],
    "places": [{"id": "A"}, {"id": "B", "point": [0.5, 0, 0.1]}],
    "distances": [{"between": ["A", "B"], "metres": 0.05, "sigma": 2e-05}],
    "contactSigma": 0.0001,
    "soles": {"l_foot": {"z": -0.027}}, "gravity": [0, 1, -9.7],
    "encoderSteps": {"pan": 0.0004}, "slipSteps": {"lift": 0.4},
    "stances": [{"id": 0}, {"id": 1, "placement": {"x": 0.1, "roll": 0.2}},
                {"id": 2, "supportLinks": ["l_foot", "r_foot"], "placement": {"x": 0, "y": 0.1, "yaw": 0.2}}],
    "captures": [
      {"id": 0, "pose": "P00", "repeat": 0, "repeatKind": "reapproach", "time": 0, "stance": 0,
       "joints": {"measured": [0.1, 0.2]}, "camera": "wrist", "image": "images/0.png",
       "corners": [{"board": "plate", "ids": [0, 2], "uv": [[310.2, 200.1], [330, 199.7]]}]},
      {"id": 1, "pose": "P01", "repeat": 0, "time": 9.5, "stance": 1, "joints": {"measured": [0.3, null]},
       "points": [{"tracker": "vicon", "marker": "ball", "xyz": [0.512, -0.231, 1.104]}],
       "frames": [{"tracker": "laser", "frame": "tool", "xyz": [0.5, 0.1, 1], "quaternion": [0.6, 0, 0.8, 0]}],
       "contacts": [{"marker": "tip", "place": "A"}]}]
  })");
}

} // namespace naocal

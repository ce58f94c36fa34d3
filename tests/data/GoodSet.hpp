#pragma once

#include <nlohmann/json.hpp>

namespace naocal {

/// A set that uses every feature of the format once and has no unknown keys.
inline nlohmann::json goodSet() {
  return nlohmann::json::parse(R"({
    "format": "naocal-captures", "version": 1,
    "robot": {"model": "V6", "bodyId": "body", "headId": "head"},
    "jointNames": ["HeadYaw", "HeadPitch", "LHipYawPitch", "RHipYawPitch"],
    "cameras": {
      "top": {"width": 640, "height": 480, "fx": 598.5, "fy": 597.25, "cx": 320.1, "cy": 240.3,
              "distortion": [0.1, -0.2, 0.001, -0.002, 0.3]},
      "bottom": {"width": 1280, "height": 960, "fx": 1200, "fy": 1201, "cx": 640, "cy": 480,
                 "distortion": [0, 0, 0, 0, 0]}},
    "boards": [
      {"id": "A", "placement": {"x": 0.45, "y": -0.15, "yaw": 0.25}},
      {"id": "B", "dictionary": "DICT_5X5_250", "squaresX": 6, "squaresY": 4, "squareLength": 0.1,
       "markerLength": 0.07, "firstMarkerId": 30, "legacyPattern": true,
       "placementGuess": {"x": 1, "y": 0.5}, "placementSigma": {"x": 0.1, "y": 0.2, "yaw": 0.3}},
      {"id": "mark", "link": "LWrist", "points": [[0, 0, 0]], "placementGuess": {"x": 0.02, "z": -0.03},
       "placementSigma": 0.05},
      {"id": "sandal", "link": "RSole", "points": [[0, 0, 0], [0.01, 0.02, 0.03]],
       "placement": {"x": 0.1, "y": 0.01, "z": 0.02, "roll": 0.1, "pitch": -0.2, "yaw": 0.3}}],
    "stances": [{"id": 0, "supportFoot": "left", "placement": {"x": 0.01, "y": 0.02, "yaw": -0.03}},
                {"id": 7, "supportFoot": "both"}, {"id": 8, "supportFoot": "none"}, {"id": 9, "supportFoot": "right"}],
    "captures": [
      {"id": 0, "pose": "P00", "repeat": 0, "time": 12.345, "camera": "top", "supportFoot": "left", "stance": 0,
       "joints": {"measured": [0.1, -0.2, 0.3, 0.3], "commanded": [0.11, -0.21, 0.31, 0.31],
                  "velocity": [0, 0.001, 0, 0], "approach": [-1, 0, 1, 1],
                  "temperature": [30, 31.5, 38, 38], "current": [0.1, 0, 0.25, 0.25]},
       "imu": {"angleX": 0.01, "angleY": -0.02}, "fsr": [0.5, 0.6, 0.4, 0.5, 0, 0, 0, 0],
       "image": "images/0000.png",
       "corners": [{"board": "A", "ids": [0, 1, 23], "uv": [[312.4, 200.1], [330.9, 199.8], [-0.4, 479.9]]},
                   {"board": "mark", "ids": [0], "uv": [[100, 50]]}]},
      {"id": 1, "pose": "P00", "repeat": 1, "repeatKind": "reapproach", "time": 13, "camera": "bottom",
       "supportFoot": "both", "stance": 7, "joints": {"measured": [0.1, null, 0.3, null]}, "image": "images/0001.png"},
      {"id": 5, "pose": "P01", "repeat": 0, "repeatKind": "restand", "time": 14, "camera": "bottom",
       "supportFoot": "right", "stance": 9,
       "joints": {"measured": [null, -0.2, 0.3, 0.3015], "temperature": [null, 30, 30, 30]}, "corners": []},
      {"id": 6, "pose": "P02", "repeat": 0, "time": 15, "camera": "top", "supportFoot": "none", "stance": 8,
       "joints": {"measured": [0, 0, 0, 0]}, "corners": [{"board": "sandal", "ids": [], "uv": []}]}]
  })");
}

} // namespace naocal

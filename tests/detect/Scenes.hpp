#pragma once

#include "detect/BoardDetector.hpp"
#include "math/Angles.hpp"
#include "simulation/Renderer.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

namespace naocal {

/// A camera without distortion; focal length = 7/8 of the width, 560 px at 640 x 480.
inline CameraIntrinsics plainCamera(int width = 640) {
  const int height = width * 3 / 4;
  return {width, height, width * 0.875, width * 0.875, (width - 1) / 2., (height - 1) / 2., {}};
}

/// A board centred at (sideways, distance) on the floor [m], rotated by `yaw` and tilted by `tilt` [deg], before a
/// camera 0.5 m above the floor that points at (0, distance).
inline RenderedBoard boardOnFloor(const CharucoPattern& pattern, double distance, double yaw, double tilt = 0,
                                  double sideways = 0) {
  const Eigen::Matrix3d rotation = rotationX(radians(tilt)) * rotationZ(radians(yaw));
  const Eigen::Vector3d centre =
      pattern.squareLength / 2 * Eigen::Vector3d{double(pattern.squaresX), -double(pattern.squaresY), 0};
  const RigidTransform worldFromBoard{rotation, Eigen::Vector3d{sideways, distance, 0} - rotation * centre};
  const Eigen::Vector3d eye{0, 0, 0.5};
  const Eigen::Vector3d forward = (Eigen::Vector3d{0, distance, 0} - eye).normalized();
  const Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitZ()).normalized();
  RigidTransform opticalFromWorld;
  opticalFromWorld.rotation << right.transpose(), forward.cross(right).transpose(), forward.transpose();
  opticalFromWorld.translation = -(opticalFromWorld.rotation * eye);
  return {"A", pattern, opticalFromWorld * worldFromBoard};
}

inline Board described(const std::string& id, const CharucoPattern& pattern) {
  Board board;
  board.id = id;
  board.pattern = pattern;
  return board;
}

/// A flat patch centred at (x, y) in the board's frame, just above the sheet.
inline Patch patchOn(const RenderedBoard& board, double x, double y, const Eigen::Vector2d& size, double brightness) {
  return {board.cameraOpticalFromBoard * RigidTransform{Eigen::Matrix3d::Identity(), {x, y, 0}}, size, brightness};
}

/// Detected minus true position [px], for the corners in the truth.
inline std::vector<Eigen::Vector2d> errors(const BoardCorners& detected, const BoardCorners& truth) {
  std::vector<Eigen::Vector2d> result;
  for (std::size_t i = 0; i < detected.ids.size(); ++i) {
    const auto at = std::find(truth.ids.begin(), truth.ids.end(), detected.ids[i]);
    if (at != truth.ids.end()) {
      result.push_back(detected.uv[i] - truth.uv[std::size_t(at - truth.ids.begin())]);
    }
  }
  return result;
}

inline double largest(const std::vector<Eigen::Vector2d>& errors) {
  double result = 0;
  for (const Eigen::Vector2d& error : errors) {
    result = std::max(result, error.norm());
  }
  return result;
}

inline bool contains(const Detection& detection, IssueKind kind) {
  return std::any_of(detection.findings.begin(), detection.findings.end(),
                     [&](const DetectionIssue& finding) { return finding.kind == kind; });
}

inline const DetectionIssue* findingAbout(const Detection& detection, int corner) {
  const auto found = std::find_if(detection.findings.begin(), detection.findings.end(),
                                  [&](const DetectionIssue& finding) { return finding.corner == corner; });
  return found == detection.findings.end() ? nullptr : &*found;
}

} // namespace naocal

#pragma once

#include "data/Capture.hpp"
#include "robot/Kinematics.hpp"

#include <map>
#include <string>
#include <vector>

namespace naocal {

/// What is observed of a robot in a pose when its joints turn a little: any n numbers per radian, by m joints.
class Sensor {
public:
  virtual ~Sensor() = default;

  /// Angles per joint of the drawing [rad].
  virtual Eigen::MatrixXd observation(const Eigen::VectorXd& angles) const = 0;
};

/// Cameras over a floor of points every 0.25 m, 4 m around the robot (thesis, algorithm 1): a small turn of a joint
/// moves the picture of the floor almost rigidly, by (t_x, t_y, r_z) about the picture's middle. Three rows per camera,
/// all in pixels: the turn is that of a point half a picture's width off the middle. Lenses without distortion. A
/// camera that has no floor in sight observes nothing: zeros.
class FloorSensor : public Sensor {
public:
  /// `joints`: motors; `weights`: how much a camera's rows count, 1 where it has none.
  FloorSensor(const Robot& robot, const Sole& support, const std::map<std::string, CameraIntrinsics>& cameras,
              std::vector<std::size_t> joints, const std::map<std::string, double>& weights = {});

  Eigen::MatrixXd observation(const Eigen::VectorXd& angles) const override;

private:
  struct Eye {
    std::size_t camera;
    CameraIntrinsics lens;
    double weight;
  };
  RigidTransform opticalFromSole(const Eye& eye, const Posture& torsoFromLink) const;

  const Robot& robot_;
  std::size_t sole_; // link
  std::vector<std::size_t> joints_;
  std::vector<Eye> eyes_;
  std::vector<Eigen::Vector3d> floor_; // in the sole's frame [m]
};

} // namespace naocal

#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

namespace naocal {

/// The solver's problem formulated directly: forward kinematics of a chain of joints, once per pose, and a pinhole
/// camera. Independent of the modules; the reference solvers use it, and it generates the measurements of all solvers.
struct PlainProblem {
  struct Step {
    Eigen::Vector3d origin; // in the parent [m]
    Eigen::Vector3d axis;
    int joint; // index of the angle about the axis; -1: fixed
  };
  struct Pose {
    Eigen::VectorXd measured;       // angles [rad]; truth = measured - offset
    Eigen::Matrix3Xd pointsInWorld; // world = sole's frame [m]
    Eigen::Matrix2Xd seen;          // [px]
  };
  std::vector<Step> torsoToHead, torsoToSole;
  Eigen::Matrix3d headFromOpticalRotation;
  Eigen::Vector3d opticalInHead; // [m]
  double focalLength = 0;        // [px]
  Eigen::Vector2d centre;        // [px]
  double pixelNoise = 0.3;       // [px]
  double offsetSigma = 0.1;      // prior of each offset [rad]
  std::vector<Pose> poses;
  Eigen::VectorXd trueOffsets; // [rad]

  Eigen::Index offsetCount() const { return trueOffsets.size(); }
};

template <typename T> struct PlainTransform {
  Eigen::Matrix<T, 3, 3> rotation;
  Eigen::Matrix<T, 3, 1> translation;
};

template <typename T>
PlainTransform<T> walked(const std::vector<PlainProblem::Step>& steps, const Eigen::VectorXd& measured,
                         const T* offsets) {
  PlainTransform<T> result{Eigen::Matrix<T, 3, 3>::Identity(), Eigen::Matrix<T, 3, 1>::Zero()};
  for (const PlainProblem::Step& step : steps) {
    result.translation += result.rotation * step.origin.cast<T>();
    if (step.joint >= 0) {
      const T angle = measured[step.joint] - offsets[step.joint];
      result.rotation = (result.rotation * Eigen::AngleAxis<T>(angle, step.axis.cast<T>()).toRotationMatrix()).eval();
    }
  }
  return result;
}

/// opticalFromWorld of a pose.
template <typename T>
PlainTransform<T> plainOpticalFromWorld(const PlainProblem& problem, const PlainProblem::Pose& pose, const T* offsets) {
  const PlainTransform<T> head = walked(problem.torsoToHead, pose.measured, offsets);
  const PlainTransform<T> sole = walked(problem.torsoToSole, pose.measured, offsets);
  const Eigen::Matrix<T, 3, 3> rotation = (head.rotation * problem.headFromOpticalRotation.cast<T>()).transpose();
  const Eigen::Matrix<T, 3, 1> origin = head.rotation * problem.opticalInHead.cast<T>() + head.translation;
  return {rotation * sole.rotation, rotation * (sole.translation - origin)};
}

/// (u, v) of a point in the optical frame [px].
template <typename T> Eigen::Matrix<T, 2, 1> plainPixel(const PlainProblem& problem, const Eigen::Matrix<T, 3, 1>& p) {
  const T scale = problem.focalLength / p.z();
  return {scale * p.x() + problem.centre.x(), scale * p.y() + problem.centre.y()};
}

/// Whitened residuals u0, v0, u1, ... of a pose.
template <typename T>
void plainResiduals(const PlainProblem& problem, const PlainProblem::Pose& pose, const T* offsets, T* residuals) {
  const PlainTransform<T> opticalFromWorld = plainOpticalFromWorld(problem, pose, offsets);
  const double weight = 1 / problem.pixelNoise;
  for (Eigen::Index i = 0; i < pose.seen.cols(); ++i) {
    const Eigen::Matrix<T, 3, 1> point =
        opticalFromWorld.rotation * pose.pointsInWorld.col(i).cast<T>() + opticalFromWorld.translation;
    const Eigen::Matrix<T, 2, 1> pixel = plainPixel(problem, point);
    residuals[2 * i] = (pixel.x() - pose.seen(0, i)) * weight;
    residuals[2 * i + 1] = (pixel.y() - pose.seen(1, i)) * weight;
  }
}

/// Eigen's unsupported LevenbergMarquardt, central differences.
Eigen::VectorXd solvedByDifferences(const PlainProblem& problem);

/// Ceres, automatic differentiation, one block per pose, one thread.
enum class CeresSolver { normalCholesky, qr };
Eigen::VectorXd solvedByCeres(const PlainProblem& problem, CeresSolver solver);

} // namespace naocal

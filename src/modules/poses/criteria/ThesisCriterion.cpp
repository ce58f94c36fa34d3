#include "poses/criteria/ThesisCriterion.hpp"

#include "math/LinearAlgebra.hpp"
#include "math/Parallel.hpp"

#include <algorithm>
#include <cmath>

namespace naocal {

namespace {

/// Pixel coordinates relative to the image centre [px]; behind the camera: far outside.
Eigen::Vector2d fromMiddle(const CameraIntrinsics& lens, const Eigen::Vector3d& inOptical) {
  if (inOptical.z() <= 0) {
    return Eigen::Vector2d::Constant(1e9);
  }
  return {lens.fx * inOptical.x() / inOptical.z(), lens.fy * inOptical.y() / inOptical.z()};
}

/// The planar rigid motion (t_x, t_y, r_z) that best maps `from` to `to` (Procrustes).
Eigen::Vector3d rigidMotion(const Eigen::Matrix2Xd& from, const Eigen::Matrix2Xd& to) {
  const Eigen::Vector2d a = from.rowwise().mean(), b = to.rowwise().mean();
  const Eigen::Matrix2d spread = (from.colwise() - a) * (to.colwise() - b).transpose();
  const double turn = std::atan2(spread(0, 1) - spread(1, 0), spread(0, 0) + spread(1, 1));
  const Eigen::Vector2d turned{std::cos(turn) * a.x() - std::sin(turn) * a.y(),
                               std::sin(turn) * a.x() + std::cos(turn) * a.y()};
  return {b.x() - turned.x(), b.y() - turned.y(), turn};
}

template <typename PairValue> Eigen::ArrayXd perPair(Eigen::Index joints, const PairValue& value) {
  Eigen::ArrayXd result(joints * (joints - 1) / 2);
  for (Eigen::Index b = 0, pair = 0; b < joints; ++b) {
    for (Eigen::Index a = 0; a < b; ++a, ++pair) {
      result[pair] = value(a, b);
    }
  }
  return result;
}

Eigen::VectorXd jointWeights(const Robot& robot, const std::vector<std::size_t>& joints,
                             const std::map<std::string, double>& weights) {
  Eigen::VectorXd result = Eigen::VectorXd::Ones(eigenIndex(joints.size()));
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (const auto weight = weights.find(robot.joints[joints[i]].name); weight != weights.end()) {
      result[eigenIndex(i)] = weight->second;
    }
  }
  return result;
}

} // namespace

FloorSensor::FloorSensor(const Robot& robot, const Sole& support,
                         const std::map<std::string, CameraIntrinsics>& cameras, std::vector<std::size_t> joints,
                         const std::map<std::string, double>& weights)
    : robot_{robot}, sole_{support.link}, joints_{std::move(joints)} {
  for (const auto& [name, lens] : cameras) {
    const auto weight = weights.find(name);
    eyes_.push_back({robot.cameraIndex(name).value(), lens, weight == weights.end() ? 1 : weight->second});
  }
  constexpr int perMetre = 4, farthest = 4;
  for (int x = -farthest * perMetre; x <= farthest * perMetre; ++x) {
    for (int y = -farthest * perMetre; y <= farthest * perMetre; ++y) {
      const Eigen::Vector3d point{static_cast<double>(x) / perMetre, static_cast<double>(y) / perMetre, 0};
      if (point.norm() <= farthest) {
        floor_.push_back(point);
      }
    }
  }
}

RigidTransform FloorSensor::opticalFromSole(const Eye& eye, const LinkPoses& torsoFromLink) const {
  const CameraMount& mount = robot_.cameras[eye.camera];
  const ModelState drawn = nominalState(robot_, StateLayout{robot_.joints.size(), robot_.lengths.size(), 0});
  return (torsoFromLink[mount.link] * linkFromOptical(mount, drawn)).inverse() * torsoFromLink[sole_];
}

Eigen::MatrixXd FloorSensor::observe(const Eigen::VectorXd& angles) const {
  constexpr double little = 1e-3; // [rad]
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(eigenIndex(3 * eyes_.size()), eigenIndex(joints_.size()));
  const LinkPoses here = forwardKinematics(robot_, angles);
  for (std::size_t i = 0; i < eyes_.size(); ++i) {
    const auto& [camera, lens, weight] = eyes_[i];
    const RigidTransform view = opticalFromSole(eyes_[i], here);
    std::vector<Eigen::Vector3d> seen;
    for (const Eigen::Vector3d& point : floor_) {
      const Eigen::Vector2d pixel = fromMiddle(lens, view * point);
      if (std::abs(pixel.x()) < lens.width / 2.0 && std::abs(pixel.y()) < lens.height / 2.0) {
        seen.push_back(point);
      }
    }
    if (seen.size() < 2) {
      continue;
    }
    const auto picture = [&, &ownLens = lens](const RigidTransform& opticalFromSole) {
      Eigen::Matrix2Xd pixels(2, eigenIndex(seen.size()));
      for (std::size_t k = 0; k < seen.size(); ++k) {
        pixels.col(eigenIndex(k)) = fromMiddle(ownLens, opticalFromSole * seen[k]);
      }
      return pixels;
    };
    const Eigen::Matrix2Xd before = picture(view);
    for (std::size_t joint = 0; joint < joints_.size(); ++joint) {
      Eigen::VectorXd turned = angles;
      for (std::size_t each = 0; each < robot_.joints.size(); ++each) {
        turned[eigenIndex(each)] += robot_.joints[each].motor == joints_[joint] ? little : 0;
      }
      const Eigen::Vector3d motion =
          rigidMotion(before, picture(opticalFromSole(eyes_[i], forwardKinematics(robot_, turned))));
      result.block<3, 1>(eigenIndex(3 * i), eigenIndex(joint)) =
          weight / little * motion.cwiseProduct(Eigen::Vector3d{1, 1, lens.width / 2.0});
    }
  }
  return result;
}

Eigen::ArrayXd computeJointInteraction(const Eigen::MatrixXd& observation) {
  return perPair(observation.cols(), [&](Eigen::Index a, Eigen::Index b) {
    const double norms = observation.col(a).norm() * observation.col(b).norm();
    return norms > 0 ? std::min(1.0, std::abs(observation.col(a).dot(observation.col(b))) / norms) : 1.0;
  });
}

InteractionCriterion::InteractionCriterion(const Eigen::VectorXd& jointWeights)
    : weights_{perPair(jointWeights.size(),
                       [&](Eigen::Index a, Eigen::Index b) { return jointWeights[a] * jointWeights[b]; })} {
  weights_ /= weights_.sum();
}

Interaction InteractionCriterion::operator()(const Eigen::ArrayXd& product) const {
  constexpr double toldApart = 0.01;
  return {(weights_ * product).sum(), static_cast<std::size_t>((product > toldApart).count())};
}

std::vector<std::size_t> InteractionCriterion::selectChain(const std::vector<Eigen::ArrayXd>& poses,
                                                           std::size_t count) const {
  std::vector<std::size_t> chosen;
  Eigen::ArrayXd product = Eigen::ArrayXd::Ones(weights_.size());
  double cost = 1;
  while (chosen.size() < count) {
    std::size_t best = poses.size();
    double least = cost;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const double with = (*this)(product * poses[i]).cost;
      if (with < least && std::find(chosen.begin(), chosen.end(), i) == chosen.end()) {
        best = i;
        least = with;
      }
    }
    if (best == poses.size()) {
      break;
    }
    chosen.push_back(best);
    product *= poses[best];
    cost = least;
  }
  return chosen;
}

ThesisCriterion::ThesisCriterion(const Robot& robot, const Sole& support,
                                 const std::map<std::string, CameraIntrinsics>& cameras,
                                 const std::vector<std::size_t>& joints, const std::map<std::string, double>& weights)
    : sensor_{robot, support, cameras, joints, weights}, judge_{jointWeights(robot, joints, weights)},
      angles_{eigenIndex(robot.joints.size())} {}

std::vector<Eigen::ArrayXd> ThesisCriterion::interactions(const std::vector<ValidPose>& poses) const {
  std::vector<Eigen::ArrayXd> result(poses.size());
  parallelFor(poses.size(), [&](std::size_t i) {
    result[i] = computeJointInteraction(sensor_.observe(poses[i].modelState.values.head(angles_)));
  });
  return result;
}

Interaction ThesisCriterion::interaction(const std::vector<ValidPose>& poses) const {
  const std::vector<Eigen::ArrayXd> all = interactions(poses);
  Eigen::ArrayXd product = all.front();
  for (std::size_t i = 1; i < all.size(); ++i) {
    product *= all[i];
  }
  return judge_(product);
}

std::vector<std::size_t> ThesisCriterion::selectChain(const std::vector<ValidPose>& poses, std::size_t count) const {
  return judge_.selectChain(interactions(poses), count);
}

} // namespace naocal

#include "evaluation/thesis/HeldOutPoses.hpp"

#include "evaluation/thesis/ThesisProgram.hpp"

#include <cmath>

namespace naocal {

bool HeldOutError::isAcceptable() const {
  return std::isfinite(norm) && mean <= programTestTolerance && norm <= normAtZero;
}

PointsInImage pointsInImage(const SoleCamera<double>& camera, const SoleCamera<double>::Transform& cameraFromSole,
                            const Eigen::Matrix2Xd& points) {
  PointsInImage seen{Eigen::Matrix2Xd(2, points.cols()), {}};
  camera.project(cameraFromSole, points, seen.pixels);
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector2d pixel = seen.pixels.col(i);
    if (isInImage(camera.lens(), pixel)) {
      seen.points.col(count) = points.col(i);
      seen.pixels.col(count++) = pixel;
    }
  }
  seen.points.conservativeResize(2, count);
  seen.pixels.conservativeResize(2, count);
  return seen;
}

void HeldOutPoses::draw(const Eigen::VectorXd& offsets, const Scatter& scatter, RandomStream& chance) {
  pictures_.clear();
  for (std::size_t pose = 0; pose < poses_.size(); ++pose) {
    Eigen::VectorXd angles = poses_[pose] - offsets;
    for (double& angle : angles) {
      angle += chance.normal(scatter.angle);
    }
    const auto cameraFromSole = camera_.cameraFromSole(angles);
    if (!passesHorizonTest(camera_, cameraFromSole)) {
      continue;
    }
    PointsInImage seen = pointsInImage(camera_, cameraFromSole, points_);
    for (double& coordinate : seen.pixels.reshaped()) {
      coordinate += chance.normal(scatter.pixel);
    }
    pictures_.push_back({pose, std::move(seen.points), std::move(seen.pixels)});
  }
}

double HeldOutPoses::sumOfDistances(const Eigen::VectorXd& offsets, double& squares) const {
  double sum = 0;
  squares = 0;
  Eigen::Matrix2Xd predicted;
  for (const Picture& picture : pictures_) {
    camera_.project(camera_.cameraFromSole(poses_[picture.pose] - offsets), picture.points, predicted);
    sum += (picture.pixels - predicted).colwise().norm().sum();
    squares += (picture.pixels - predicted).squaredNorm();
  }
  return sum;
}

HeldOutError HeldOutPoses::error(const Eigen::VectorXd& estimate) const {
  HeldOutError result;
  for (const Picture& picture : pictures_) {
    result.points += static_cast<std::size_t>(picture.points.cols());
  }
  double squares = 0;
  sumOfDistances(Eigen::VectorXd::Zero(estimate.size()), squares);
  result.normAtZero = std::sqrt(squares);
  const double sum = sumOfDistances(estimate, squares);
  result.norm = std::sqrt(squares);
  result.mean = result.points > 0 ? sum / static_cast<double>(result.points) : 0;
  return result;
}

} // namespace naocal

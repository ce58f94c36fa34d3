#pragma once

#include "residuals/Measurements.hpp"
#include "residuals/Slopes.hpp"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace naocal {

/// A gentler problem than that of the corners, for the way from far away: every board's pose in the camera, as its
/// corners alone show it, against where the chain puts it. It knows no horizon and no "behind the camera".
///
///   residual = (log(R_chain R_seen^T), c_chain - c_seen), c the middle of the corners,
///
/// weighted by how well the corners tell it, but never better than 0.1 rad and a tenth of the depth, with a Huber loss.
/// A problem for `levenbergMarquardt`; of each pose the first reading in every stance takes part.
class BoardAlignment {
public:
  BoardAlignment(const Measurements& measurements, const Model& model);

  struct Linear {
    double cost = 0;
    Eigen::VectorXd gradient;
    Eigen::MatrixXd hessian;
  };
  bool linearise(const Eigen::VectorXd& unknowns, Linear& sums) const;
  Eigen::VectorXd moved(const Eigen::VectorXd& unknowns, const Linear&, const Eigen::VectorXd& step) const {
    return unknowns + step;
  }
  const Eigen::VectorXd& scales() const { return sigmas_; }
  /// Boards whose pose in the camera could be told.
  std::size_t size() const { return seen_.size(); }
  /// Whether one of them is this target.
  bool knows(std::size_t target) const;

private:
  struct Seen {
    const Picture* picture;
    const Sighting* sighting;
    std::vector<Slope> slopes;
    RigidTransform opticalFromBoard;
    Eigen::Vector3d middle;             // of the corners, in the board's frame [m]
    Eigen::Matrix<double, 6, 6> weight; // of the residual: an inverse covariance
  };
  void addReading(const Reading& reading);
  void addSeen(const Picture& picture, const Sighting& sighting, const std::vector<Slope>& slopes);
  void add(const Seen& seen, const Eigen::VectorXd& unknowns, Linear& sums) const;

  const Measurements& measurements_;
  const Model& model_;
  Eigen::VectorXd sigmas_;
  std::vector<Seen> seen_;
};

} // namespace naocal

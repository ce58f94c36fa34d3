#pragma once

#include "writer/Pictures.hpp"

namespace blind {

/// How all corners move with what a calibration does not know, by central differences on a robot without flaws.
class Jacobian {
public:
  static constexpr Eigen::Index chainLength = 8;

  Jacobian(const Robot& robot, const Session& session);

  /// [px/rad, px/m]: the motors in use, three turns of each camera, x, y, yaw of every board but the first and of every
  /// stance.
  const Eigen::MatrixXd& unknowns() const { return unknowns_; }
  /// How many of them, the last ones, are places.
  Eigen::Index placeCount() const { return placeCount_; }
  /// 1 / sigma^2 of what is plausible: offsets 0.1 rad, camera turns 0.05 rad, places anything.
  const Eigen::VectorXd& priorWeights() const { return priorWeights_; }
  /// [px/rad]: the true angles of the joints between that reading's sole and the cameras.
  const Eigen::MatrixXd& byChain() const { return byChain_; }

private:
  Eigen::MatrixXd unknowns_, byChain_;
  Eigen::VectorXd priorWeights_;
  Eigen::Index placeCount_ = 0;
};

} // namespace blind

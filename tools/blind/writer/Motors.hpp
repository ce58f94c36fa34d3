#pragma once

#include "writer/Chance.hpp"
#include "writer/Staging.hpp"

namespace blind {

/// How warm the motors are: each follows what it carries with a first-order lag,
/// dT/dt = (room + heat * torque^2 - T) / slowness.
class Motors {
public:
  Motors(std::size_t count, const SessionPlan& plan, Chance& chance);

  void pass(double duration, const Eigen::VectorXd& torques, Chance& chance); // [s], [Nm]
  const Eigen::VectorXd& degrees() const { return degrees_; }                 // Celsius

private:
  bool constant_, idle_;
  Eigen::VectorXd degrees_;
};

} // namespace blind

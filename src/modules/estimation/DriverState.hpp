#pragma once

#include "estimation/Model.hpp"

#include <Eigen/Core>
#include <array>

namespace naocal {

/// Drivers of the effects at an instant and their derivatives with respect to the joint offsets: one column per offset
/// of the model.
struct DriverState {
  RobotSample instant;
  Eigen::MatrixXd angleByOffset;                  // one row per joint: -1 or 0
  Eigen::MatrixXd torqueByOffset;                 // one row per joint [Nm/rad]
  Eigen::MatrixXd growthByOffset;                 // derivative of torqueGrowth, if the model uses it [Nm/rad^2]
  Eigen::MatrixXd comByOffset;                    // centre of mass x, y [m/rad]
  std::array<Eigen::MatrixXd, 2> lateralByOffset; // of lateralTorque, if the model uses it, one row per joint [Nm/rad]
};

/// Drivers at the given unknowns: q = measured - o; torque and centre of mass of the nominal robot at those angles,
/// with the support sole fixed and level (both feet: per leg joint, the mean of both values weighted by the feet's
/// loads, all else with the left sole fixed; none: torso fixed and upright), or the base as it stands. Leaves torque
/// and centre of mass unchanged if no effect of the model uses them, since they dominate the cost.
DriverState computeDrivers(const Measurements& measurements, const Model& model, const ImageObservation& picture,
                           const Eigen::VectorXd& unknowns);

/// Drivers at a picture's instant as in `computeDrivers`; torque, centre of mass and, of a robot with a URDF, lateral
/// torques always included.
RobotSample sampleAt(const Measurements& measurements, const Model& model, const ImageObservation& picture,
                     const Eigen::VectorXd& unknowns);

/// Predicted model state at a picture's instant. All corrections are evaluated at the recorded instant, independently
/// of each other.
ModelState predictState(const Measurements& measurements, const Model& model, const ImageObservation& picture,
                        const Eigen::VectorXd& unknowns);

} // namespace naocal

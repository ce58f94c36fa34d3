#pragma once

#include "estimation/Model.hpp"

#include <Eigen/Core>

namespace naocal {

/// What drives effects at an instant, and how that follows the joint offsets: one column per offset of the model.
struct DriverState {
  RobotSample instant;
  Eigen::MatrixXd angleByOffset;  // row per joint: -1 or 0
  Eigen::MatrixXd torqueByOffset; // row per joint [Nm/rad]
  Eigen::MatrixXd growthByOffset; // the same of torqueGrowth, where the model looks at it [Nm/rad^2]
  Eigen::MatrixXd comByOffset;    // x, y [m/rad]
};

/// At given unknowns: q = measured - o; torque and centre of mass of the drawn robot at those angles, the support
/// foot's sole held still and level (both: each leg joint's two values weighted by the feet's loads, everything else
/// with the left sole held; none: the torso held, upright). Where no effect of the model looks at the load, torque and
/// centre of mass are left as they are: it is most of the work.
DriverState computeDrivers(const Measurements& measurements, const Model& model, const ImageObservation& picture,
                           const Eigen::VectorXd& unknowns);

/// What drives effects at a picture's instant, given the unknowns: q = measured - o; torque and centre of mass of the
/// drawn robot at those angles, the support foot's sole held still and level (both: each leg joint's two values
/// weighted by the feet's loads, all else with the left sole held; none: the torso held, upright).
RobotSample sampleAt(const Measurements& measurements, const Model& model, const ImageObservation& picture,
                     const Eigen::VectorXd& unknowns);

/// What is believed at a picture's instant given the unknowns. Every correction is evaluated at the instant; none sees
/// another's.
ModelState predictState(const Measurements& measurements, const Model& model, const ImageObservation& picture,
                        const Eigen::VectorXd& unknowns);

} // namespace naocal

#include "estimation/DriverState.hpp"
#include "math/LinearAlgebra.hpp"
#include "robot/Gravity.hpp"

#include <algorithm>
#include <initializer_list>

namespace naocal {

namespace {

/// Whether an effect of the model uses one of these drivers.
bool dependsOn(const Model& model, std::initializer_list<Driver> drivers) {
  const auto isOne = [&](Driver driver) { return std::find(drivers.begin(), drivers.end(), driver) != drivers.end(); };
  return std::any_of(model.terms().begin(), model.terms().end(),
                     [&](const Term& term) { return anyDriver(term.effect, isOne); });
}

bool carries(const Robot& robot, std::size_t joint, std::size_t link) {
  for (std::optional<std::size_t> up = link; up; up = robot.links[*up].parent) {
    if (*up == robot.joints[joint].link) {
      return true;
    }
  }
  return false;
}

/// Per leg joint, the mean over both feet, weighted by their loads; writes it to `left`.
void shareLegLoad(const Robot& robot, const GravityLoad& right, double leftLoad, GravityLoad& left) {
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    if (isOnLeg(robot, joint)) {
      left.torque[eigenIndex(joint)] =
          leftLoad * left.torque[eigenIndex(joint)] + (1 - leftLoad) * right.torque[eigenIndex(joint)];
      left.torqueByAngle.row(eigenIndex(joint)) = leftLoad * left.torqueByAngle.row(eigenIndex(joint)) +
                                                  (1 - leftLoad) * right.torqueByAngle.row(eigenIndex(joint));
      left.torqueGrowth[eigenIndex(joint)] =
          leftLoad * left.torqueGrowth[eigenIndex(joint)] + (1 - leftLoad) * right.torqueGrowth[eigenIndex(joint)];
      if (left.growthByAngle.size() > 0) {
        left.growthByAngle.row(eigenIndex(joint)) = leftLoad * left.growthByAngle.row(eigenIndex(joint)) +
                                                    (1 - leftLoad) * right.growthByAngle.row(eigenIndex(joint));
      }
    }
  }
}

/// Against gravity, in the root's frame, of a robot with a support link.
Eigen::Vector3d upInTorso(const LinkPoses& torsoFromLink, const RobotSample& instant) {
  return torsoFromLink[*instant.supportLink].rotation * instant.upInSupport;
}

Eigen::Matrix2Xd computeLateralTorque(const Robot& robot, const ModelState& modelState, const RobotSample& instant) {
  const LinkPoses torsoFromLink = forwardKinematics(robot, modelState);
  const std::size_t held = instant.supportLink.value_or(0);
  const Eigen::Vector3d up =
      instant.supportLink ? upInTorso(torsoFromLink, instant) : Eigen::Vector3d{torsoFromLink[held].rotation.col(2)};
  return lateralTorques(robot, modelState, torsoFromLink, held, up);
}

GravityLoad computeLoad(const Robot& robot, const ModelState& modelState, const RobotSample& instant,
                        bool withGrowthByAngle) {
  const LinkPoses torsoFromLink = forwardKinematics(robot, modelState);
  const auto loadOn = [&](std::size_t heldLink) {
    return gravityLoad(robot, modelState, torsoFromLink, heldLink, torsoFromLink[heldLink].rotation.col(2),
                       withGrowthByAngle);
  };
  switch (instant.supportFoot) {
  case SupportFoot::left:
    return loadOn(robot.findSole("left")->link);
  case SupportFoot::right:
    return loadOn(robot.findSole("right")->link);
  case SupportFoot::both: {
    GravityLoad load = loadOn(robot.findSole("left")->link);
    shareLegLoad(robot, loadOn(robot.findSole("right")->link), instant.leftLoad, load);
    return load;
  }
  case SupportFoot::none:
    break;
  }
  if (instant.supportLink) {
    return gravityLoad(robot, modelState, torsoFromLink, *instant.supportLink, upInTorso(torsoFromLink, instant),
                       withGrowthByAngle);
  }
  GravityLoad hanging = loadOn(0);
  hanging.com.setConstant(RobotSample::nothing);
  return hanging;
}

/// Sets the lateral torques at the instant's angles and, by central differences, their derivatives with respect to the
/// offsets.
void driveLaterally(const Robot& robot, ModelState modelState, DriverState& result) {
  constexpr double step = 1e-4; // [rad]
  const Eigen::Index joints = eigenIndex(robot.joints.size()), offsets = result.angleByOffset.cols();
  result.instant.lateralTorque = computeLateralTorque(robot, modelState, result.instant);
  result.lateralByOffset.fill(Eigen::MatrixXd::Zero(joints, offsets));
  const Eigen::VectorXd here = modelState.values.head(joints);
  for (Eigen::Index i = 0; i < offsets; ++i) {
    modelState.values.head(joints) = here + step * result.angleByOffset.col(i);
    const Eigen::Matrix2Xd after = computeLateralTorque(robot, modelState, result.instant);
    modelState.values.head(joints) = here - step * result.angleByOffset.col(i);
    const Eigen::Matrix2Xd slope = (after - computeLateralTorque(robot, modelState, result.instant)) / (2 * step);
    for (std::size_t normal = 0; normal < 2; ++normal) {
      result.lateralByOffset[normal].col(i) = slope.row(eigenIndex(normal)).transpose();
    }
  }
}

/// What to compute besides the angles: torques and centre of mass, the derivatives of torqueGrowth with respect to the
/// offsets, lateral torques.
struct Loads {
  bool loaded = false, growth = false, lateral = false;
};

DriverState driveState(const Measurements& measurements, const Model& model, const ImageObservation& picture,
                       const Eigen::VectorXd& unknowns, const Loads& loads) {
  const bool growth = loads.growth;
  const Robot& robot = measurements.robot;
  const Eigen::Index joints = eigenIndex(robot.joints.size()), offsets = eigenIndex(model.offsets().size());
  DriverState result{picture.instant,
                     Eigen::MatrixXd::Zero(joints, offsets),
                     Eigen::MatrixXd::Zero(joints, offsets),
                     Eigen::MatrixXd::Zero(growth ? joints : 0, offsets),
                     Eigen::MatrixXd::Zero(2, offsets),
                     {}};
  for (Eigen::Index i = 0; i < offsets; ++i) {
    const Term& offset = model.terms()[model.offsets()[static_cast<std::size_t>(i)]];
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
      if (robot.joints[joint].motor == offset.placeIndex) {
        result.instant.q[eigenIndex(joint)] -= robot.joints[joint].ratio * unknowns[eigenIndex(offset.first)];
        result.angleByOffset(eigenIndex(joint), i) = -robot.joints[joint].ratio;
      }
    }
  }
  ModelState modelState = picture.nominal;
  modelState.values.head(joints) = result.instant.q;
  if (loads.lateral) {
    driveLaterally(robot, modelState, result);
  }
  if (!loads.loaded) {
    return result;
  }
  if (std::none_of(robot.links.begin(), robot.links.end(), [](const Link& link) { return link.mass > 0; })) {
    result.instant.torque.setZero(joints); // the drawing has no masses
    result.instant.torqueGrowth.setZero(joints);
    return result;
  }
  const GravityLoad load = computeLoad(robot, modelState, result.instant, growth);
  result.instant.torque = load.torque;
  result.instant.torqueGrowth = load.torqueGrowth;
  result.instant.com = load.com.head<2>();
  for (Eigen::Index i = 0; i < offsets; ++i) {
    for (Eigen::Index joint = 0; joint < joints; ++joint) {
      if (const double slope = result.angleByOffset(joint, i); slope != 0) {
        result.torqueByOffset.col(i) += slope * load.torqueByAngle.col(joint);
        if (growth) {
          result.growthByOffset.col(i) += slope * load.growthByAngle.col(joint);
        }
        result.comByOffset.col(i) += slope * load.comByAngle.col(joint).head<2>();
      }
    }
  }
  return result;
}

} // namespace

bool isOnLeg(const Robot& robot, std::size_t joint) {
  for (const Sole& sole : robot.soles) {
    if (carries(robot, joint, sole.link)) {
      return true;
    }
  }
  return false;
}

DriverState computeDrivers(const Measurements& measurements, const Model& model, const ImageObservation& picture,
                           const Eigen::VectorXd& unknowns) {
  const bool growth = dependsOn(model, {Driver::torqueGrowth});
  const bool loaded = growth || dependsOn(model, {Driver::torque, Driver::com});
  const bool lateral = dependsOn(model, {Driver::lateral1, Driver::lateral2});
  return driveState(measurements, model, picture, unknowns, {loaded, growth, lateral});
}

RobotSample sampleAt(const Measurements& measurements, const Model& model, const ImageObservation& picture,
                     const Eigen::VectorXd& unknowns) {
  RobotSample sample = driveState(measurements, model, picture, unknowns, {true, false, false}).instant;
  if (measurements.quantities.scene().hasLinkSteps) {
    ModelState modelState = picture.nominal;
    modelState.values.head(sample.q.size()) = sample.q;
    sample.lateralTorque = computeLateralTorque(measurements.robot, modelState, sample);
  }
  return sample;
}

} // namespace naocal

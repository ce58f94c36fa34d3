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
  return std::any_of(model.terms().begin(), model.terms().end(), [&](const Term& term) {
    return std::any_of(term.effect.drivers.begin(), term.effect.drivers.end(), isOne) ||
           std::any_of(term.effect.remoteDrivers.begin(), term.effect.remoteDrivers.end(),
                       [&](const RemoteDriver& other) { return isOne(other.driver); });
  });
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
  GravityLoad hanging = loadOn(0);
  hanging.com.setConstant(RobotSample::nothing);
  return hanging;
}

/// `loaded`: computes torques and centre of mass; `growth`: also the derivatives of torqueGrowth with respect to the
/// offsets.
DriverState driveState(const Measurements& measurements, const Model& model, const ImageObservation& picture,
                       const Eigen::VectorXd& unknowns, bool loaded, bool growth) {
  const Robot& robot = measurements.robot;
  const Eigen::Index joints = eigenIndex(robot.joints.size()), offsets = eigenIndex(model.offsets().size());
  DriverState result{picture.instant, Eigen::MatrixXd::Zero(joints, offsets), Eigen::MatrixXd::Zero(joints, offsets),
                     Eigen::MatrixXd::Zero(growth ? joints : 0, offsets), Eigen::MatrixXd::Zero(2, offsets)};
  for (Eigen::Index i = 0; i < offsets; ++i) {
    const Term& offset = model.terms()[model.offsets()[static_cast<std::size_t>(i)]];
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
      if (robot.joints[joint].motor == offset.placeIndex) {
        result.instant.q[eigenIndex(joint)] -= unknowns[eigenIndex(offset.first)];
        result.angleByOffset(eigenIndex(joint), i) = -1;
      }
    }
  }
  if (!loaded) {
    return result;
  }
  ModelState modelState = picture.nominal;
  modelState.values.head(joints) = result.instant.q;
  const GravityLoad load = computeLoad(robot, modelState, result.instant, growth);
  result.instant.torque = load.torque;
  result.instant.torqueGrowth = load.torqueGrowth;
  result.instant.com = load.com.head<2>();
  for (Eigen::Index i = 0; i < offsets; ++i) {
    for (Eigen::Index joint = 0; joint < joints; ++joint) {
      if (result.angleByOffset(joint, i) != 0) {
        result.torqueByOffset.col(i) -= load.torqueByAngle.col(joint);
        if (growth) {
          result.growthByOffset.col(i) -= load.growthByAngle.col(joint);
        }
        result.comByOffset.col(i) -= load.comByAngle.col(joint).head<2>();
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
  return driveState(measurements, model, picture, unknowns, loaded, growth);
}

RobotSample sampleAt(const Measurements& measurements, const Model& model, const ImageObservation& picture,
                     const Eigen::VectorXd& unknowns) {
  return driveState(measurements, model, picture, unknowns, true, false).instant;
}

} // namespace naocal

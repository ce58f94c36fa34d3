#include "estimation/DriverState.hpp"
#include "math/LinearAlgebra.hpp"
#include "robot/Gravity.hpp"

#include <algorithm>
#include <initializer_list>

namespace naocal {

namespace {

/// Whether an effect of the model looks at one of these.
bool looksAt(const Model& model, std::initializer_list<Driver> drivers) {
  const auto isOne = [&](Driver driver) { return std::find(drivers.begin(), drivers.end(), driver) != drivers.end(); };
  return std::any_of(model.terms().begin(), model.terms().end(), [&](const Term& term) {
    return std::any_of(term.effect.needs.begin(), term.effect.needs.end(), isOne) ||
           std::any_of(term.effect.elsewhere.begin(), term.effect.elsewhere.end(),
                       [&](const Elsewhere& other) { return isOne(other.driver); });
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

/// Of every leg joint the mean of both feet's, weighted by what each of them carries.
void share(const Robot& robot, const Load& right, double leftLoad, Load& left) {
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    if (carriesSole(robot, joint)) {
      left.torque[at(joint)] = leftLoad * left.torque[at(joint)] + (1 - leftLoad) * right.torque[at(joint)];
      left.torqueByAngle.row(at(joint)) =
          leftLoad * left.torqueByAngle.row(at(joint)) + (1 - leftLoad) * right.torqueByAngle.row(at(joint));
      left.torqueGrowth[at(joint)] =
          leftLoad * left.torqueGrowth[at(joint)] + (1 - leftLoad) * right.torqueGrowth[at(joint)];
      if (left.growthByAngle.size() > 0) {
        left.growthByAngle.row(at(joint)) =
            leftLoad * left.growthByAngle.row(at(joint)) + (1 - leftLoad) * right.growthByAngle.row(at(joint));
      }
    }
  }
}

Load loadOf(const Robot& robot, const Belief& belief, const Instant& instant, bool withGrowthByAngle) {
  const Posture torsoFromLink = posture(robot, belief);
  const auto loadOn = [&](std::size_t heldLink) {
    return gravityLoad(robot, belief, torsoFromLink, heldLink, torsoFromLink[heldLink].rotation.col(2),
                       withGrowthByAngle);
  };
  switch (instant.supportFoot) {
  case SupportFoot::left:
    return loadOn(robot.sole("left")->link);
  case SupportFoot::right:
    return loadOn(robot.sole("right")->link);
  case SupportFoot::both: {
    Load load = loadOn(robot.sole("left")->link);
    share(robot, loadOn(robot.sole("right")->link), instant.leftLoad, load);
    return load;
  }
  case SupportFoot::none:
    break;
  }
  Load hanging = loadOn(0);
  hanging.com.setConstant(Instant::nothing);
  return hanging;
}

/// `loaded`, `growth`: whether torques and the centre of mass, and how torques' growth follows the offsets, are wanted.
Driven driven(const Measurements& measurements, const Model& model, const Picture& picture,
              const Eigen::VectorXd& unknowns, bool loaded, bool growth) {
  const Robot& robot = measurements.robot;
  const Eigen::Index joints = at(robot.joints.size()), offsets = at(model.offsets().size());
  Driven result{picture.instant, Eigen::MatrixXd::Zero(joints, offsets), Eigen::MatrixXd::Zero(joints, offsets),
                Eigen::MatrixXd::Zero(growth ? joints : 0, offsets), Eigen::MatrixXd::Zero(2, offsets)};
  for (Eigen::Index i = 0; i < offsets; ++i) {
    const Term& offset = model.terms()[model.offsets()[static_cast<std::size_t>(i)]];
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
      if (robot.joints[joint].motor == offset.at) {
        result.instant.q[at(joint)] -= unknowns[at(offset.first)];
        result.angleByOffset(at(joint), i) = -1;
      }
    }
  }
  if (!loaded) {
    return result;
  }
  Belief belief = picture.drawn;
  belief.values.head(joints) = result.instant.q;
  const Load load = loadOf(robot, belief, result.instant, growth);
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

bool carriesSole(const Robot& robot, std::size_t joint) {
  for (const Sole& sole : robot.soles) {
    if (carries(robot, joint, sole.link)) {
      return true;
    }
  }
  return false;
}

Driven drivenAt(const Measurements& measurements, const Model& model, const Picture& picture,
                const Eigen::VectorXd& unknowns) {
  const bool growth = looksAt(model, {Driver::torqueGrowth});
  const bool loaded = growth || looksAt(model, {Driver::torque, Driver::com});
  return driven(measurements, model, picture, unknowns, loaded, growth);
}

Instant instantOf(const Measurements& measurements, const Model& model, const Picture& picture,
                  const Eigen::VectorXd& unknowns) {
  return driven(measurements, model, picture, unknowns, true, false).instant;
}

} // namespace naocal

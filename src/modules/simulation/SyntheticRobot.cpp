#include "simulation/SyntheticRobot.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>

namespace naocal {

namespace {

bool carries(SupportFoot supportFoot, std::size_t side) {
  return supportFoot == SupportFoot::both || (supportFoot == SupportFoot::left) == (side == 0);
}

constexpr std::array<const char*, 2> sides{"left", "right"};

} // namespace

/// Loads on the sensors of the supporting soles: the distribution of least squares with the robot's weight as sum and
/// its centre below the centre of mass; negative loads are set to 0.
std::array<double, 8> SyntheticRobot::forces(const Eigen::VectorXd& joints, SupportFoot supportFoot) const {
  const std::vector<Eigen::Isometry3d> torsoFromLink = body_.forwardKinematics(joints);
  const Eigen::Isometry3d soleFromTorso = torsoFromLink[soleLink(supportFoot)].inverse();
  Eigen::Matrix<double, 3, 8> balance = Eigen::Matrix<double, 3, 8>::Zero(); // sum, moments in x and y
  for (std::size_t side = 0; side < sides.size(); ++side) {
    const Sole* sole = drawing_.findSole(sides[side]);
    for (std::size_t sensor = 0; carries(supportFoot, side) && sensor < sole->forceSensors.size(); ++sensor) {
      const Eigen::Vector2d& place = sole->forceSensors[sensor];
      const Eigen::Vector3d inSupport =
          soleFromTorso * torsoFromLink[sole->link] * Eigen::Vector3d{place.x(), place.y(), 0};
      balance.col(static_cast<Eigen::Index>(4 * side + sensor)) << 1, inSupport.x(), inSupport.y();
    }
  }
  const Eigen::Vector3d centre = soleFromTorso * body_.centreOfMass(torsoFromLink);
  const Eigen::Vector3d load = body_.mass() * Eigen::Vector3d{1, centre.x(), centre.y()};
  const Eigen::Matrix<double, 8, 1> weights = balance.transpose() * (balance * balance.transpose()).inverse() * load;
  std::array<double, 8> result{};
  std::transform(weights.begin(), weights.end(), result.begin(), [](double weight) { return std::max(weight, 0.0); });
  return result;
}

Eigen::VectorXd SyntheticRobot::gravityTorques(const Eigen::VectorXd& joints, SupportFoot supportFoot) const {
  if (supportFoot != SupportFoot::both) {
    return body_.gravityTorques(joints, soleLink(supportFoot));
  }
  const std::array<double, 8> weights = forces(joints, supportFoot);
  const double left = std::accumulate(weights.begin(), weights.begin() + 4, 0.0);
  const double right = std::accumulate(weights.begin() + 4, weights.end(), 0.0);
  return (left * body_.gravityTorques(joints, soleLink(SupportFoot::left)) +
          right * body_.gravityTorques(joints, soleLink(SupportFoot::right))) /
         (left + right);
}

std::array<double, 8> SyntheticRobot::readForces(const SettledPose& taken, RandomStream& chance) const {
  std::array<double, 8> readings = forces(trueJointAngles(taken, Seconds{0}), taken.supportFoot);
  for (double& reading : readings) {
    reading = std::max(reading + chance.normal(mechanics_.forceNoise), 0.0);
  }
  return readings;
}

Eigen::Vector2d SyntheticRobot::readImu(const Eigen::Matrix3d& worldFromTorso, RandomStream& chance) const {
  const double roll = std::atan2(worldFromTorso(2, 1), worldFromTorso(2, 2));
  const double pitch = std::asin(-worldFromTorso(2, 0));
  return {roll + chance.normal(mechanics_.imuNoise), pitch + chance.normal(mechanics_.imuNoise)};
}

Eigen::VectorXd SyntheticRobot::readCurrents(const SettledPose& taken, RandomStream& chance) const {
  Eigen::VectorXd currents = mechanics_.currentPerTorque * taken.torques;
  for (double& current : currents) {
    current = std::abs(current + chance.normal(mechanics_.currentNoise));
  }
  return currents;
}

void SyntheticRobot::heatMotors(Eigen::VectorXd& temperatures, const Eigen::VectorXd& torques, Seconds duration) const {
  const Eigen::ArrayXd target =
      mechanics_.ambientTemperature + mechanics_.heatPerTorqueSquared * torques.array().square();
  const double towards = 1 - std::exp(-duration.count() / mechanics_.thermalTimeConstant);
  temperatures.array() += towards * (target - temperatures.array());
}

SyntheticRobot::SyntheticRobot(const Robot& drawing, const RobotErrors& errors, const RobotMechanics& mechanics)
    : drawing_{drawing}, errors_{errors}, mechanics_{mechanics}, body_{errors.flaw ? errors.flaw->applyTo(drawing)
                                                                                   : drawing} {
  assert(static_cast<std::size_t>(errors.jointOffsets.size()) == drawing.joints.size());
  assert(errors.mounts.size() == drawing.cameras.size());
}

Eigen::VectorXd SyntheticRobot::drawScatter(double sigma, RandomStream& chance) const {
  Eigen::VectorXd result{errors_.jointOffsets.size()};
  for (double& deflection : result) {
    deflection = chance.normal(sigma);
  }
  followMotors(result);
  return result;
}

void SyntheticRobot::followMotors(Eigen::VectorXd& angles) const {
  for (std::size_t joint = 0; joint < drawing_.joints.size(); ++joint) {
    angles[static_cast<Eigen::Index>(joint)] = angles[static_cast<Eigen::Index>(drawing_.joints[joint].motor)];
  }
}

/// Deflects the gears in equilibrium with gravity: the soft joint's deflection is its compliance times the torque in
/// the resulting pose (fixed-point iteration).
void SyntheticRobot::yield(SettledPose& taken, const Eigen::VectorXd& lastMotion) const {
  const InjectedEffect& flaw = *errors_.flaw;
  taken.deflection += flaw.lag(lastMotion, gravityTorques(taken.motors + taken.deflection, taken.supportFoot));
  followMotors(taken.deflection);
  if (flaw.softJoint) {
    const auto joint = static_cast<Eigen::Index>(*flaw.softJoint);
    const double rigid = taken.deflection[joint];
    for (int iteration = 0; iteration < 8; ++iteration) { // reduces the error to about 3 % each time
      const Eigen::VectorXd torques = gravityTorques(taken.motors + taken.deflection, taken.supportFoot);
      taken.deflection[joint] = rigid + flaw.compliance * torques[joint];
      followMotors(taken.deflection);
    }
  }
}

SettledPose SyntheticRobot::moveTo(const Eigen::VectorXd& commanded, const Eigen::VectorXd& lastMotion,
                                   SupportFoot supportFoot, const Eigen::VectorXd& poseDeflection,
                                   RandomStream& chance) const {
  assert(supportFoot != SupportFoot::none);
  SettledPose taken;
  taken.supportFoot = supportFoot;
  const Eigen::VectorXd target = commanded - errors_.jointOffsets;
  taken.torques = gravityTorques(target, supportFoot);
  taken.motors = target + mechanics_.servoDroop * taken.torques + drawScatter(mechanics_.servoDeadZone, chance);
  taken.deflection = poseDeflection + drawScatter(mechanics_.approachScatter, chance);
  if (errors_.flaw) {
    yield(taken, lastMotion);
  }
  taken.velocity = drawScatter(mechanics_.residualSpeed, chance);
  if (supportFoot == SupportFoot::both) {
    settleOnBothSoles(taken);
  }
  return taken;
}

Eigen::VectorXd SyntheticRobot::trueJointAngles(const SettledPose& taken, Seconds since) const {
  return taken.motors + taken.deflection + since.count() * taken.velocity;
}

Eigen::VectorXd SyntheticRobot::readEncoders(const SettledPose& taken, Seconds since, RandomStream& chance) const {
  const double step = 2 * std::numbers::pi / mechanics_.encoderSteps; // [rad]
  const Eigen::VectorXd shown = taken.motors + since.count() * taken.velocity + errors_.jointOffsets +
                                drawScatter(mechanics_.encoderDither, chance);
  return step * (shown / step).array().round();
}

std::size_t SyntheticRobot::soleLink(SupportFoot supportFoot) const {
  const Sole* sole = drawing_.findSole(supportFoot == SupportFoot::right ? "right" : "left");
  assert(sole != nullptr);
  return sole->link;
}

Eigen::Isometry3d SyntheticRobot::soleFromTorso(const Eigen::VectorXd& joints, SupportFoot supportFoot) const {
  return body_.forwardKinematics(joints)[soleLink(supportFoot)].inverse();
}

Eigen::Isometry3d SyntheticRobot::torsoFromCamera(std::size_t camera, const Eigen::VectorXd& joints) const {
  const CameraMount& nominal = drawing_.cameras[camera];
  const RobotErrors::Mount& error = errors_.mounts[camera];
  return body_.forwardKinematics(joints)[nominal.link] * Eigen::Translation3d{nominal.translation + error.translation} *
         Eigen::Isometry3d{nominal.rotation} *
         Eigen::AngleAxisd{error.rotation.x(), Eigen::Vector3d::UnitX()} *
         Eigen::AngleAxisd{error.rotation.y(), Eigen::Vector3d::UnitY()} *
         Eigen::AngleAxisd{error.rotation.z(), Eigen::Vector3d::UnitZ()};
}

/// Height [m] and tilt (x and y of its normal) of the right sole relative to the left one.
Eigen::Vector3d SyntheticRobot::rightSoleOffFloor(const Eigen::VectorXd& joints) const {
  const std::vector<Eigen::Isometry3d> torsoFromLink = body_.forwardKinematics(joints);
  const Eigen::Isometry3d leftFromRight =
      torsoFromLink[soleLink(SupportFoot::left)].inverse() * torsoFromLink[soleLink(SupportFoot::right)];
  return {leftFromRight.translation().z(), leftFromRight(0, 2), leftFromRight(1, 2)};
}

/// Turns the legs' motors as little as possible until both soles lie flat on the floor: Gauss-Newton on c(q) = 0 with
/// the minimum-norm step -J^T (J J^T)^-1 c.
void SyntheticRobot::settleOnBothSoles(SettledPose& taken) const {
  constexpr double step = 1e-6, flat = 1e-13; // [rad], [m or 1]
  for (int iteration = 0; iteration < 20; ++iteration) {
    const Eigen::VectorXd joints = trueJointAngles(taken, Seconds{0});
    const Eigen::Vector3d gap = rightSoleOffFloor(joints);
    if (gap.norm() < flat) {
      break;
    }
    Eigen::Matrix3Xd slope = Eigen::Matrix3Xd::Zero(3, joints.size());
    for (std::size_t joint = 0; joint < drawing_.joints.size(); ++joint) {
      Eigen::VectorXd turned = joints;
      turned[static_cast<Eigen::Index>(joint)] += step;
      slope.col(static_cast<Eigen::Index>(drawing_.joints[joint].motor)) += (rightSoleOffFloor(turned) - gap) / step;
    }
    Eigen::VectorXd turn = -slope.transpose() * (slope * slope.transpose()).inverse() * gap;
    for (std::size_t joint = 0; joint < drawing_.joints.size(); ++joint) {
      taken.motors[static_cast<Eigen::Index>(joint)] += turn[static_cast<Eigen::Index>(drawing_.joints[joint].motor)];
    }
  }
}

} // namespace naocal

#include "hardware/simulated/SimulatedBody.hpp"

#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cmath>

namespace naocal {
namespace {

constexpr double mostTilt = radians(25); // relative to the floor; beyond it the robot falls

} // namespace

SimulatedBody::SimulatedBody(const Robot& drawing, const SimulatedPlan& plan, const SimulatedErrors& errors)
    : drawing_{drawing}, plan_{plan}, robot_{drawing, errors.robot, plan.mechanics}, body_{drawing},
      offsets_{errors.robot.jointOffsets}, motion_{plan.seed, "motion"}, sensors_{plan.seed, "sensors"} {
  for (std::size_t joint = 0; joint < drawing.joints.size(); ++joint) {
    jointOfHardware_.push_back(jointIndex(drawing.joints[joint].name).value());
    const double angle = plan.start[*jointIndex(drawing.joints[drawing.joints[joint].motor].name)];
    servos_.emplace_back(drawing.joints[joint], errors.play[joint], plan.servos, angle - offsets_[eigenIndex(joint)]);
  }
  temperatures_ = Eigen::VectorXd::Constant(eigenIndex(servos_.size()), plan.mechanics.ambientTemperature);
  torquesAt_ = Eigen::VectorXd::Constant(eigenIndex(servos_.size()), 1e3); // forces computation in the first step
  putDown();
  stand_ = {0, anchored_ == SupportFoot::right ? -halfFootDistance : halfFootDistance, 0};
  settle(Seconds{0});
}

/// Places the robot on the sole that needs the smaller tilt to lie flat; on the left one if equal.
void SimulatedBody::putDown() {
  const std::vector<Eigen::Isometry3d> torsoFromLink = body_.forwardKinematics(trueAngles());
  const Contact contact = contactOf(torsoFromLink);
  double least = mostTilt;
  SupportFoot flatter = anchored_;
  for (const SupportFoot foot : {SupportFoot::left, SupportFoot::right}) {
    const Eigen::Isometry3d soleFromTorso = torsoFromLink[soleLink(foot)].inverse();
    const Eigen::Vector3d up = soleFromTorso.linear().transpose().col(2);
    const auto resting = findRestingPlane(contact.points, contact.centreOfMass, up, mostTilt);
    const double tilt = resting ? std::acos(std::min(1.0, resting->up.dot(up))) : mostTilt;
    if (tilt < least) {
      least = tilt;
      flatter = foot;
    }
  }
  anchor(flatter, torsoFromLink[soleLink(flatter)]);
  worldFromTorso_.linear() = torsoFromLink[soleLink(anchored_)].linear().transpose();
}

/// Contact points of the soles in the torso's frame, left sole first, and the centre of mass.
SimulatedBody::Contact SimulatedBody::contactOf(const std::vector<Eigen::Isometry3d>& torsoFromLink) const {
  Contact contact{{}, body_.centreOfMass(torsoFromLink)};
  for (const char* side : {"left", "right"}) {
    for (const Eigen::Vector2d& corner : drawing_.findSole(side)->outline) {
      contact.points.push_back(torsoFromLink[drawing_.findSole(side)->link] *
                               Eigen::Vector3d{corner.x(), corner.y(), 0});
    }
  }
  return contact;
}

std::size_t SimulatedBody::soleLink(SupportFoot foot) const {
  return drawing_.findSole(foot == SupportFoot::right ? "right" : "left")->link;
}

void SimulatedBody::command(const RobotCommand& command) {
  for (std::size_t joint = 0; joint < servos_.size(); ++joint) {
    const std::size_t hardware = jointOfHardware_[drawing_.joints[joint].motor];
    servos_[joint].command(command.angles[hardware] - offsets_[eigenIndex(joint)], command.stiffness[hardware]);
  }
  stiffness_ = command.stiffness;
  hands_ = command.angles.values;
  const bool hold = command.leds.leftEye.front() == holdMeColour;
  if (held_ && !hold) {
    putDown();
  }
  held_ = hold;
}

Eigen::VectorXd SimulatedBody::trueAngles() const {
  Eigen::VectorXd angles{eigenIndex(servos_.size())};
  for (std::size_t joint = 0; joint < servos_.size(); ++joint) {
    const Servo& servo = servos_[drawing_.joints[joint].motor];
    angles[eigenIndex(joint)] = servo.motor() + servo.gap();
  }
  return angles;
}

Eigen::Isometry3d SimulatedBody::worldFromCamera(std::size_t camera, const Eigen::VectorXd& joints,
                                                 const Eigen::Isometry3d& worldFromTorso) const {
  return worldFromTorso * robot_.torsoFromCamera(camera, joints);
}

void SimulatedBody::advance(Seconds step) {
  turnMotors(step);
  robot_.heatMotors(temperatures_, torques_, step);
  const Eigen::Matrix3d before = worldFromTorso_.linear();
  if (fall_) {
    fall(step);
  } else {
    settle(step);
  }
  const Eigen::AngleAxisd turned{before.transpose() * worldFromTorso_.linear()};
  turnRate_ = turned.angle() / step.count() * turned.axis();
}

void SimulatedBody::turnMotors(Seconds step) {
  constexpr double still = radians(0.02); // changes torques by less than 0.1 %
  const Eigen::VectorXd now = trueAngles();
  if ((now - torquesAt_).cwiseAbs().maxCoeff() > still) {
    torques_ = robot_.gravityTorques(now, support_);
    torquesAt_ = now;
  }
  constexpr int parts = 2; // substeps, shorter than the motors' lag
  for (int part = 0; part < parts; ++part) {
    for (std::size_t joint = 0; joint < servos_.size(); ++joint) {
      if (drawing_.joints[joint].motor == joint) {
        servos_[joint].advance(step / parts, fall_ ? 0 : torques_[eigenIndex(joint)], motion_);
      }
    }
  }
}

/// Fixes the pose of the support sole on the floor.
void SimulatedBody::anchor(SupportFoot foot, const Eigen::Isometry3d& torsoFromSole) {
  anchored_ = foot;
  const Eigen::Isometry3d worldFromSole = worldFromTorso_ * torsoFromSole;
  stand_ = {worldFromSole.translation().x(), worldFromSole.translation().y(),
            std::atan2(worldFromSole(1, 0), worldFromSole(0, 0))};
}

/// The floor while a person holds the robot with its lower sole flat on it.
RestingPlane SimulatedBody::held(const std::vector<Eigen::Vector3d>& points,
                                 const Eigen::Isometry3d* torsoFromSole) const {
  constexpr double clearly = 0.01; // [m]; hysteresis of the choice of sole
  const auto heightOf = [&](bool right) { return (worldFromTorso_ * torsoFromSole[right].translation()).z(); };
  const bool wasRight = anchored_ == SupportFoot::right;
  const bool right = heightOf(!wasRight) < heightOf(wasRight) - clearly ? !wasRight : wasRight;
  RestingPlane plane{torsoFromSole[right].linear().col(2), 0, {}};
  const auto along = [&](const Eigen::Vector3d& one, const Eigen::Vector3d& other) {
    return plane.up.dot(one) < plane.up.dot(other);
  };
  plane.height = plane.up.dot(*std::min_element(points.begin(), points.end(), along));
  const std::size_t first = right ? drawing_.findSole("left")->outline.size() : 0;
  plane.touching = {first, first + 1, first + 2};
  return plane;
}

void SimulatedBody::settle(Seconds step) {
  const std::vector<Eigen::Isometry3d> torsoFromLink = body_.forwardKinematics(trueAngles());
  const Eigen::Isometry3d torsoFromSole[2]{torsoFromLink[soleLink(SupportFoot::left)],
                                           torsoFromLink[soleLink(SupportFoot::right)]};
  const auto [points, centre] = contactOf(torsoFromLink);
  const std::size_t leftCount = drawing_.findSole("left")->outline.size();
  const Eigen::Vector3d up = worldFromTorso_.linear().transpose() * Eigen::Vector3d::UnitZ();
  const auto resting =
      held_ ? std::optional{held(points, torsoFromSole)} : findRestingPlane(points, centre, up, mostTilt);
  if (!resting) {
    const Eigen::Vector3d ahead =
        worldFromTorso_.linear() * (centre - torsoFromSole[anchored_ == SupportFoot::right].translation());
    fall_ = Fall{Eigen::Vector3d{-ahead.y(), ahead.x(), 0}.normalized(), radians(1)};
    return fall(step);
  }
  const auto touches = [&](bool right) {
    return std::any_of(resting->touching.begin(), resting->touching.end(),
                       [&](std::size_t point) { return (point >= leftCount) == right; });
  };
  support_ = touches(false) && touches(true) ? SupportFoot::both
             : touches(true)                 ? SupportFoot::right
                                             : SupportFoot::left;
  if (support_ != SupportFoot::both && support_ != anchored_) {
    anchor(support_, torsoFromSole[support_ == SupportFoot::right]);
  }
  const Eigen::Isometry3d& sole = torsoFromSole[anchored_ == SupportFoot::right];
  worldFromTorso_.linear() =
      Eigen::Quaterniond::FromTwoVectors(resting->up, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Eigen::Vector3d ahead = worldFromTorso_.linear() * sole.linear().col(0);
  worldFromTorso_.linear() =
      Eigen::AngleAxisd{stand_.yaw - std::atan2(ahead.y(), ahead.x()), Eigen::Vector3d::UnitZ()} *
      worldFromTorso_.linear();
  worldFromTorso_.translation().setZero();
  const Eigen::Vector3d there = worldFromTorso_ * sole.translation();
  worldFromTorso_.translation() = Eigen::Vector3d{stand_.x - there.x(), stand_.y - there.y(), -resting->height};
}

/// Inverted pendulum about the foot, starting at 1 degree: d2 angle = 3 g / 2 l sin(angle), l = 0.5 m.
void SimulatedBody::fall(Seconds step) {
  constexpr double poleRate = 5.4, lying = radians(88); // [1/s]
  const double next = std::min(lying, fall_->angle * std::exp(poleRate * step.count()));
  worldFromTorso_.pretranslate(-Eigen::Vector3d{stand_.x, stand_.y, 0});
  worldFromTorso_.prerotate(Eigen::AngleAxisd{next - fall_->angle, fall_->axis});
  worldFromTorso_.pretranslate(Eigen::Vector3d{stand_.x, stand_.y, 0});
  fall_->angle = next;
}

SettledPose SimulatedBody::taken() const {
  SettledPose pose;
  pose.motors = pose.deflection = Eigen::VectorXd::Zero(eigenIndex(servos_.size()));
  pose.velocity = Eigen::VectorXd::Zero(eigenIndex(servos_.size()));
  for (std::size_t joint = 0; joint < servos_.size(); ++joint) {
    const Servo& servo = servos_[drawing_.joints[joint].motor];
    pose.motors[eigenIndex(joint)] = servo.motor();
    pose.deflection[eigenIndex(joint)] = servo.gap();
  }
  pose.torques = torques_;
  pose.supportFoot = support_;
  return pose;
}

void SimulatedBody::measure(RobotState& state) {
  const SettledPose pose = taken();
  const Eigen::VectorXd shown = robot_.readEncoders(pose, Seconds{0}, sensors_);
  const Eigen::VectorXd currents = robot_.readCurrents(pose, sensors_);
  for (std::size_t hand : {*jointIndex("LHand"), *jointIndex("RHand")}) {
    state.angles[hand] = hands_[hand];
    state.temperature[hand] = plan_.mechanics.ambientTemperature;
  }
  for (std::size_t joint = 0; joint < servos_.size(); ++joint) {
    state.angles[jointOfHardware_[joint]] = shown[eigenIndex(joint)];
    state.current[jointOfHardware_[joint]] = currents[eigenIndex(joint)];
    state.temperature[jointOfHardware_[joint]] =
        std::round(temperatures_[eigenIndex(joint)]); // integer degrees, as on the NAO
  }
  state.stiffness = stiffness_;
  if (!fall_) {
    state.forces = robot_.readForces(pose, sensors_);
  }
  const Eigen::Matrix3d& torso = worldFromTorso_.linear();
  state.torsoAngles = robot_.readImu(torso, sensors_);
  state.accelerometer = torso.transpose() * Eigen::Vector3d{0, 0, 9.81}; // specific force
  state.gyroscope = turnRate_;
  for (int axis = 0; axis < 3; ++axis) {
    state.accelerometer[axis] += sensors_.normal(0.05);
    state.gyroscope[axis] += sensors_.normal(0.003);
  }
}

} // namespace naocal

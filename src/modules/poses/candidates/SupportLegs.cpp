#include "poses/candidates/SupportLegs.hpp"

#include "io/InputError.hpp"
#include "math/Angles.hpp"
#include "math/LinearAlgebra.hpp"
#include "math/Polygon.hpp"
#include "poses/candidates/BoardPlacement.hpp"
#include "robot/Balance.hpp"
#include "robot/Gravity.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace naocal {

SingleSupport::SingleSupport(const Robot& robot, SupportFoot supportFoot)
    : robot_{robot}, supportLeg_{robot, supportSole(robot, supportFoot).name},
      otherLeg_{robot, otherSole(robot, supportFoot).name}, middle_{naocal::vertexMean(
                                                                supportSole(robot, supportFoot).outline)} {}

bool SingleSupport::reachStance(ModelState& modelState, RigidTransform soleFromTorso,
                                const RigidTransform& soleFromOther, const Eigen::Vector2d& centre) const {
  soleFromTorso.translation.head<2>() = centre;
  constexpr int rounds = 3; // converges quickly
  for (int round = 0; round < rounds; ++round) {
    if (!bendLegs(modelState, soleFromTorso, soleFromOther)) {
      return false;
    }
    const Eigen::Vector3d reached = soleFromTorso * centreOfMass(robot_, forwardKinematics(robot_, modelState)).inTorso;
    soleFromTorso.translation.head<2>() += centre - reached.head<2>();
  }
  return bendLegs(modelState, soleFromTorso, soleFromOther);
}

bool SingleSupport::bendLegs(ModelState& modelState, const RigidTransform& soleFromTorso,
                             const RigidTransform& soleFromOther) const {
  const RigidTransform torsoFromSole = soleFromTorso.inverse();
  const auto support = supportLeg_.solveAngles(torsoFromSole);
  const auto other = support ? otherLeg_.solveAngles(torsoFromSole * soleFromOther, support->front()) : std::nullopt;
  if (!other) {
    return false;
  }
  for (std::size_t i = 0; i < support->size(); ++i) {
    modelState.angle(supportLeg_.joints()[i]) = (*support)[i];
    modelState.angle(otherLeg_.joints()[i]) = (*other)[i];
  }
  return true;
}

Eigen::VectorXd bentKneesStance(const Robot& robot) {
  Eigen::VectorXd angles = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(robot.joints.size()));
  for (const auto& [joint, degrees] : {std::pair{"ShoulderPitch", 90}, std::pair{"HipPitch", -25},
                                       std::pair{"KneePitch", 50}, std::pair{"AnklePitch", -25}}) {
    for (const char* side : {"L", "R"}) {
      const std::string name = side + std::string{joint};
      const auto index = robot.jointIndex(name);
      if (!index) {
        throw InputError{fmt::format(
            "the drawing of {}: expected the joint {} of a NAO, found none; this is for NAOs only", robot.model, name)};
      }
      angles[static_cast<Eigen::Index>(*index)] = radians(degrees);
    }
  }
  return angles;
}

std::vector<Eigen::VectorXd> planOntoOneFoot(const Robot& robot, SupportFoot supportFoot,
                                             const Eigen::VectorXd& stand) {
  struct Point {
    double shift;       // fraction of the shift onto the foot
    double height;      // of the torso above the sole [m]
    double lift;        // of the other sole above the floor [m]
    double roll, pitch; // of the torso, outwards and forwards [rad]
  };
  // of 58 simulated robots with joint errors of 5 degrees, unheld, 1 (left foot) and 7 (right foot) fall on this way
  constexpr std::array points{Point{0.5, 0.30, 0, 0.15, 0.15}, Point{1, 0.30, 0, 0.25, 0.2},
                              Point{1.1, 0.31, 0.02, 0.3, 0.2}, Point{1, 0.31, 0.04, 0.3, 0.3}};
  constexpr double forwards = 0.025; // centre of mass from the sole's origin [m]
  const SingleSupport feet{robot, supportFoot};
  const double inwards = supportFoot == SupportFoot::left ? -1 : 1;
  const Eigen::Vector2d over{forwards, feet.outlineCentre().y()}, between{forwards, inwards * footDistance / 2};
  ModelState modelState = nominalState(robot, StateLayout{robot.joints.size(), robot.lengths.size(), 0});
  modelState.values.head(stand.size()) = stand;
  std::vector<Eigen::VectorXd> way;
  for (const Point& point : points) {
    RigidTransform soleFromTorso, soleFromOther;
    soleFromTorso.rotation = rotationY(point.pitch) * rotationX(inwards * point.roll);
    soleFromTorso.translation.z() = point.height;
    soleFromOther.translation << 0, inwards * footDistance, point.lift;
    if (!feet.reachStance(modelState, soleFromTorso, soleFromOther, between + point.shift * (over - between))) {
      throw InputError{fmt::format("the legs of the {} do not reach from its stand onto its {} foot", robot.model,
                                   supportFoot == SupportFoot::left ? "left" : "right")};
    }
    way.push_back(modelState.values.head(stand.size()));
  }
  return way;
}

std::optional<std::vector<Eigen::VectorXd>> interpolateOnOneFoot(const Robot& robot, SupportFoot supportFoot,
                                                                 const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                                                                 int parts) {
  const SingleSupport feet{robot, supportFoot};
  const std::size_t support = supportSole(robot, supportFoot).link, other = otherSole(robot, supportFoot).link;
  struct End {
    RigidTransform soleFromTorso, soleFromOther;
    Eigen::Vector3d centre;
  };
  const auto end = [&](const Eigen::VectorXd& angles) {
    const LinkPoses torsoFromLink = forwardKinematics(robot, angles);
    const RigidTransform soleFromTorso = torsoFromLink[support].inverse();
    return End{soleFromTorso, soleFromTorso * torsoFromLink[other],
               soleFromTorso * centreOfMass(robot, torsoFromLink).inTorso};
  };
  const End one = end(from), two = end(to);
  const auto blend = [](const RigidTransform& a, const RigidTransform& b, double share) {
    return RigidTransform{
        Eigen::Quaterniond{a.rotation}.slerp(share, Eigen::Quaterniond{b.rotation}).toRotationMatrix(),
        (1 - share) * a.translation + share * b.translation};
  };
  std::vector<Eigen::VectorXd> via;
  ModelState modelState = nominalState(robot, StateLayout{robot.joints.size(), robot.lengths.size(), 0});
  for (int i = 1; i < parts; ++i) {
    const double share = static_cast<double>(i) / parts;
    modelState.values.head(from.size()) = (1 - share) * from + share * to;
    if (!feet.reachStance(modelState, blend(one.soleFromTorso, two.soleFromTorso, share),
                          blend(one.soleFromOther, two.soleFromOther, share),
                          ((1 - share) * one.centre + share * two.centre).head<2>())) {
      return std::nullopt;
    }
    via.push_back(modelState.values.head(from.size()));
  }
  return via;
}

StanceSampler::StanceSampler(const Robot& robot, const PoseOptions& options)
    : robot_{robot}, options_{options}, other_{otherSole(robot, options.supportFoot)},
      feet_{robot, options.supportFoot}, joints_{feet_.supportLeg().joints().begin(),
                                                 feet_.supportLeg().joints().end()} {
  joints_.insert(joints_.end(), feet_.otherLeg().joints().begin(), feet_.otherLeg().joints().end());
}

std::size_t StanceSampler::dimension() const {
  return options_.supportFoot == SupportFoot::both ? 8 : 11;
}

bool StanceSampler::reachStance(ModelState& modelState, const NumberSource& draw) const {
  return options_.supportFoot == SupportFoot::both ? bendOnBoth(modelState, draw) : bendOnOne(modelState, draw);
}

bool StanceSampler::bendOnOne(ModelState& modelState, const NumberSource& draw) const {
  const double outwards = options_.supportFoot == SupportFoot::left ? 1 : -1; // sign of the support foot's outer side
  RigidTransform soleFromTorso;
  soleFromTorso.rotation = rotationZ(draw(options_.yaw)) * rotationY(draw(options_.pitch));
  soleFromTorso.rotation *= rotationX(draw(options_.roll));
  RigidTransform soleFromOther;
  soleFromOther.rotation = rotationY(draw(options_.otherTilt));
  soleFromOther.rotation *= rotationX(draw(options_.otherTilt));
  soleFromOther.translation.x() = draw(options_.otherForwards);
  soleFromOther.translation.y() = -outwards * draw(options_.otherSideways);
  soleFromOther.translation.z() = draw(options_.otherUp);
  Eigen::Vector2d wanted = feet_.outlineCentre();
  wanted.x() += draw(options_.centreForwards);
  wanted.y() += outwards * draw(options_.centreOutwards);
  soleFromTorso.translation.z() = draw(options_.height);
  return feet_.reachStance(modelState, soleFromTorso, soleFromOther, wanted);
}

/// One motor turns both hips, in opposite directions: solves for the torso yaw at which both legs need the same hip
/// angle, by the secant method.
bool StanceSampler::bendOnBoth(ModelState& modelState, const NumberSource& draw) const {
  const DoubleSupportRanges& beside = options_.beside;
  RigidTransform soleFromOther;
  soleFromOther.translation.x() = draw(beside.forwards);
  soleFromOther.translation.y() = -draw(beside.sideways);
  const double otherYaw = draw(beside.yaw);
  soleFromOther.rotation = rotationZ(otherYaw);
  Eigen::Matrix3d tilted = rotationY(draw(options_.pitch));
  tilted *= rotationX(draw(options_.roll));
  const Eigen::Vector2d otherMiddle = vertexMean(other_.outline);
  Eigen::Vector2d wanted =
      (feet_.outlineCentre() + (soleFromOther * Eigen::Vector3d{otherMiddle.x(), otherMiddle.y(), 0}).head<2>()) / 2;
  wanted.x() += draw(beside.centreForwards);
  wanted.y() += draw(beside.centreSideways);
  RigidTransform soleFromTorso;
  soleFromTorso.translation << wanted, draw(options_.height);

  constexpr int leaning = 4, rounds = 12;
  constexpr double alike = 1e-10;     // [rad]
  double slope = -2 * std::sqrt(2.0); // d gap / d yaw for an upright torso
  double yaw = otherYaw / 2, lastYaw = 0, lastGap = 0;
  for (int round = 0; round < rounds; ++round) {
    soleFromTorso.rotation = rotationZ(yaw) * tilted;
    const RigidTransform torsoFromSole = soleFromTorso.inverse();
    const auto support = feet_.supportLeg().solveAngles(torsoFromSole),
               other = feet_.otherLeg().solveAngles(torsoFromSole * soleFromOther);
    if (!support || !other) {
      return false;
    }
    set(modelState, *support, *other);
    const double gap = wrapAngle(other->front() - support->front());
    if (round < leaning) {
      lean(modelState, wanted, soleFromTorso);
    } else if (std::abs(gap) < alike) {
      modelState.angle(feet_.otherLeg().joints().front()) = support->front();
      return true;
    } else if (round > leaning) {
      slope = (gap - lastGap) / (yaw - lastYaw);
    }
    lastYaw = yaw;
    lastGap = gap;
    yaw -= gap / slope;
  }
  return false;
}

void StanceSampler::set(ModelState& modelState, const LegAngles& support, const LegAngles& other) const {
  for (std::size_t i = 0; i < support.size(); ++i) {
    modelState.angle(feet_.supportLeg().joints()[i]) = support[i];
    modelState.angle(feet_.otherLeg().joints()[i]) = other[i];
  }
}

void StanceSampler::lean(const ModelState& modelState, const Eigen::Vector2d& wanted,
                         RigidTransform& soleFromTorso) const {
  const Eigen::Vector3d centre = soleFromTorso * centreOfMass(robot_, forwardKinematics(robot_, modelState)).inTorso;
  soleFromTorso.translation.head<2>() += wanted - centre.head<2>();
}

} // namespace naocal

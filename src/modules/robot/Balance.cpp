#include "robot/Balance.hpp"

#include "io/InputError.hpp"
#include "math/Polygon.hpp"
#include "robot/Gravity.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <fmt/format.h>

namespace naocal {

namespace {

const Sole& findSole(const Robot& robot, std::string_view side) {
  const Sole* sole = robot.findSole(side);
  if (sole == nullptr) {
    throw InputError{fmt::format("the drawing of {}: expected a {} sole, found none", robot.model, side)};
  }
  return *sole;
}

bool isBalancedOnOne(const Robot& robot, const LinkPoses& torsoFromLink, const Sole& support, const Sole& other,
                     const SupportMargin& least) {
  const RigidTransform soleFromTorso = torsoFromLink[support.link].inverse();
  const Eigen::Vector3d centre = soleFromTorso * centreOfMass(robot, torsoFromLink).inTorso;
  if (insideDepth(support.outline, centre.head<2>()) < least.depth) {
    return false;
  }
  const RigidTransform soleFromOther = soleFromTorso * torsoFromLink[other.link];
  return std::all_of(other.outline.begin(), other.outline.end(), [&](const Eigen::Vector2d& corner) {
    return (soleFromOther * Eigen::Vector3d{corner.x(), corner.y(), 0}).z() >= least.clearance;
  });
}

bool isBalancedOnBoth(const Robot& robot, const LinkPoses& torsoFromLink, const Sole& left, const Sole& right,
                      double least) {
  std::vector<Eigen::Vector3d> corners; // in the torso frame, like all points below
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Sole* sole : {&left, &right}) {
    for (const Eigen::Vector2d& corner : sole->outline) {
      corners.push_back(torsoFromLink[sole->link] * Eigen::Vector3d{corner.x(), corner.y(), 0});
      middle += corners.back();
    }
  }
  middle /= static_cast<double>(corners.size());
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& corner : corners) {
    scatter += (corner - middle) * (corner - middle).transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
  axes.computeDirect(scatter); // ascending eigenvalues: the plane's normal comes first
  const auto onPlane = [&](const Eigen::Vector3d& point) -> Eigen::Vector2d {
    return axes.eigenvectors().rightCols<2>().transpose() * (point - middle);
  };
  ConvexPolygon points;
  std::transform(corners.begin(), corners.end(), std::back_inserter(points), onPlane);
  const Eigen::Vector2d centre = onPlane(centreOfMass(robot, torsoFromLink).inTorso);
  return least > 0 ? insideDepth(convexHull(points), centre) >= least : hullContains(points, centre);
}

} // namespace

const Sole& supportSole(const Robot& robot, SupportFoot foot) {
  assert(foot != SupportFoot::none);
  return findSole(robot, foot == SupportFoot::right ? "right" : "left");
}

const Sole& otherSole(const Robot& robot, SupportFoot foot) {
  return supportSole(robot, foot == SupportFoot::right ? SupportFoot::left : SupportFoot::right);
}

bool isBalanced(const Robot& robot, const LinkPoses& torsoFromLink, SupportFoot foot, const SupportMargin& least) {
  const Sole &support = supportSole(robot, foot), &other = otherSole(robot, foot);
  return foot == SupportFoot::both ? isBalancedOnBoth(robot, torsoFromLink, support, other, least.depth)
                                   : isBalancedOnOne(robot, torsoFromLink, support, other, least);
}

std::optional<double> balancedFraction(const Robot& robot, const ModelState& modelState, SupportFoot foot,
                                       const BalanceRequirement& wanted, std::mt19937_64& random) {
  std::uniform_real_distribution<double> error{-wanted.jointError, wanted.jointError};
  const int mayFall = static_cast<int>(std::floor((1 - wanted.share) * wanted.draws + 1e-9));
  if (wanted.draws == 0) {
    return 1;
  }
  ModelState erroneous = modelState;
  std::vector<double> errors(robot.joints.size());
  int fallen = 0;
  for (int draw = 0; draw < wanted.draws; ++draw) {
    std::generate(errors.begin(), errors.end(), [&] { return error(random); });
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
      erroneous.angle(joint) = modelState.angle(joint) + robot.joints[joint].ratio * errors[robot.joints[joint].motor];
    }
    fallen += isBalanced(robot, forwardKinematics(robot, erroneous), foot, {}) ? 0 : 1;
    if (fallen > mayFall) {
      return std::nullopt;
    }
  }
  return 1 - static_cast<double>(fallen) / wanted.draws;
}

} // namespace naocal

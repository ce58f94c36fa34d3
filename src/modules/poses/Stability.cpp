#include "poses/Stability.hpp"

#include "captures/InputError.hpp"
#include "model/Masses.hpp"
#include "poses/Outline.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <fmt/format.h>

namespace naocal {

namespace {

const Sole& soleNamed(const Robot& robot, std::string_view side) {
  const Sole* sole = robot.sole(side);
  if (sole == nullptr) {
    throw InputError{fmt::format("the drawing of {}: expected a {} sole, found none", robot.model, side)};
  }
  return *sole;
}

} // namespace

const Sole& supportSole(const Robot& robot, SupportFoot foot) {
  assert(foot == SupportFoot::left || foot == SupportFoot::right);
  return soleNamed(robot, foot == SupportFoot::left ? "left" : "right");
}

const Sole& otherSole(const Robot& robot, SupportFoot foot) {
  return supportSole(robot, foot == SupportFoot::left ? SupportFoot::right : SupportFoot::left);
}

bool stands(const Robot& robot, const Posture& torsoFromLink, const Sole& support, const Sole& other,
            const Footing& least) {
  const RigidTransform soleFromTorso = torsoFromLink[support.link].inverse();
  const Eigen::Vector3d centre = soleFromTorso * centreOfMass(robot, torsoFromLink).inTorso;
  if (depthInside(support.outline, centre.head<2>()) < least.depth) {
    return false;
  }
  const RigidTransform soleFromOther = soleFromTorso * torsoFromLink[other.link];
  return std::all_of(other.outline.begin(), other.outline.end(), [&](const Eigen::Vector2d& corner) {
    return (soleFromOther * Eigen::Vector3d{corner.x(), corner.y(), 0}).z() >= least.clearance;
  });
}

std::optional<double> shareStanding(const Robot& robot, const Belief& belief, const Sole& support, const Sole& other,
                                    const Stability& wanted, std::mt19937_64& random) {
  std::uniform_real_distribution<double> error{-wanted.jointError, wanted.jointError};
  const int mayFall = static_cast<int>(std::floor((1 - wanted.share) * wanted.draws + 1e-9));
  if (wanted.draws == 0) {
    return 1;
  }
  Belief erroneous = belief;
  std::vector<double> errors(robot.joints.size());
  int fallen = 0;
  for (int draw = 0; draw < wanted.draws; ++draw) {
    std::generate(errors.begin(), errors.end(), [&] { return error(random); });
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
      erroneous.angle(joint) = belief.angle(joint) + errors[robot.joints[joint].motor];
    }
    fallen += stands(robot, posture(robot, erroneous), support, other, {}) ? 0 : 1;
    if (fallen > mayFall) {
      return std::nullopt;
    }
  }
  return 1 - static_cast<double>(fallen) / wanted.draws;
}

} // namespace naocal

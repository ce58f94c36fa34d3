#include "poses/MirroredPlan.hpp"

#include "io/InputError.hpp"
#include "math/LinearAlgebra.hpp"
#include "poses/BoardPlaces.hpp"
#include "poses/Mirror.hpp"
#include "poses/PoseChecks.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace naocal {

namespace {

/// What was told by one foot's poses, and what the other's add.
void take(std::map<std::string, double>& sigmas, const std::map<std::string, double>& more) {
  for (const auto& [joint, sigma] : more) {
    const auto known = sigmas.try_emplace(joint, sigma).first;
    known->second = std::min(known->second, sigma);
  }
}

} // namespace

void addMirrored(PosePlan& plan, const Robot& robot, const std::map<std::string, CameraIntrinsics>& cameras) {
  PlanOptions options = plan.options;
  const bool left = options.poses.supportFoot == SupportFoot::left;
  options.poses.supportFoot = left ? SupportFoot::right : SupportFoot::left;
  std::vector<Board> boards = plan.boards; // seen from the other sole
  for (Board& board : boards) {
    board.placement->y += left ? betweenFeet : -betweenFeet;
  }
  const PlanScore score{robot, boards, cameras, options};
  const PoseChecks checks{robot, options.poses};
  std::vector<SievedPose> images;
  const std::size_t count = plan.poses.size();
  for (std::size_t i = 0; i < count; ++i) {
    SievedPose image{score.scene().drawn(), {}, plan.standing[i]};
    image.belief.values.head(at(robot.joints.size())) = mirrored(robot, plan.poses[i].pose.angles);
    const Posture torsoFromLink = posture(robot, image.belief);
    if (checks.touchesItself(torsoFromLink) || !stands(robot, torsoFromLink, options.poses.supportFoot, {0.01, 0.01})) {
      throw InputError{fmt::format("pose {}: its mirror image is not valid; plan the other foot by itself", i)};
    }
    plan.poses.push_back({{options.poses.supportFoot, image.belief.values.head(at(robot.joints.size())),
                           score.scene().sights(image.belief, torsoFromLink)},
                          Eigen::VectorXd::Zero(at(robot.joints.size()))});
    plan.standing.push_back(plan.standing[i]);
    plan.ways.push_back(plan.ways[i]);
    if (plan.ways.back()) {
      for (Eigen::VectorXd& angles : plan.ways.back()->via) {
        angles = mirrored(robot, angles);
      }
    }
    images.push_back(std::move(image));
  }
  take(plan.sigma, score.sigmas(images, false));
  take(plan.sigmaKnown, score.sigmas(images, true));
  take(plan.sigmaOfRobots, score.sigmasOfRobots(images));
}

} // namespace naocal

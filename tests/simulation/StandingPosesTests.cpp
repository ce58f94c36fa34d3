#include "RobotV6.hpp"
#include "io/InputError.hpp"
#include "simulation/Simulation.hpp"
#include "simulation/StandingPoses.hpp"

#include <catch2/catch.hpp>

using namespace naocal;

namespace {

/// Centre of mass in the frame of the support foot's sole (on both feet, the left one) [m].
Eigen::Vector3d centreOverSole(const CommandedPose& pose) {
  const SyntheticBody body{v6()};
  const auto torsoFromLink = body.forwardKinematics(pose.angles);
  const std::size_t sole = v6().findSole(pose.supportFoot == SupportFoot::right ? "right" : "left")->link;
  return torsoFromLink[sole].inverse() * body.centreOfMass(torsoFromLink);
}

} // namespace

TEST_CASE("in poses for a simulation the robot without errors stands and sees boards") {
  // Proves by the simulator's own mechanics that the centre of mass is above the sole (or between both), within fixed
  // bounds, and that a robot without errors sees a board in every pose. Collisions are not checked.
  SimulationPlan plan;
  plan.samples = 1;
  plan.offsetRange = plan.mountRange = 0;
  for (const SupportFoot foot : {SupportFoot::left, SupportFoot::right, SupportFoot::both}) {
    plan.poses = planStandingPoses(v6(), plan, foot, 8, 1);
    REQUIRE(plan.poses.size() == 8);
    for (const CommandedPose& pose : plan.poses) {
      const Eigen::Vector3d centre = centreOverSole(pose);
      CHECK((centre.x() > -0.045 && centre.x() < 0.09));
      CHECK(std::abs(centre.y() + (foot == SupportFoot::both ? halfFootDistance : 0)) < 0.04);
    }
    std::map<std::string, std::size_t> seen;
    for (const Capture& capture : simulate(v6(), plan, 1).set.captures) {
      seen[capture.pose] += capture.corners->size();
    }
    for (const auto& [pose, boards] : seen) {
      CHECK(boards > 0);
    }
  }
}

TEST_CASE("on both feet a pose has both soles on one floor") {
  // Proves that the commanded angles satisfy the floor constraint for the drawn robot.
  const SyntheticBody body{v6()};
  for (const CommandedPose& pose : planStandingPoses(v6(), SimulationPlan{}, SupportFoot::both, 8, 1)) {
    const auto torsoFromLink = body.forwardKinematics(pose.angles);
    const Eigen::Isometry3d leftFromRight =
        torsoFromLink[v6().findSole("left")->link].inverse() * torsoFromLink[v6().findSole("right")->link];
    CHECK(std::abs(leftFromRight.translation().z()) < 1e-12);
    CHECK(leftFromRight.linear().col(2).head<2>().norm() < 1e-12);
  }
}

TEST_CASE("boards out of sight are refused with a sentence") {
  // Proves that the search for poses ends, on both feet; on one foot it is tested with the pose generator.
  SimulationPlan plan;
  for (Board& board : plan.boards) {
    board.placement->x += 20;
  }
  CHECK_THROWS_AS(planStandingPoses(v6(), plan, SupportFoot::both, 2, 1), InputError);
}

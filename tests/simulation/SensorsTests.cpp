#include "RobotV6.hpp"
#include "simulation/HandMadePoses.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace naocal;

TEST_CASE("on both feet both soles lie flat on the floor, whatever the offsets") {
  // Proves that the floor constraint holds for the true angles to 0.1 mm and 0.1 mrad (motors still move slightly
  // between two cameras). The right foot's position on the floor is not tested.
  const SimulationPlan plan = handMadePlan(v6(), 8, SupportFoot::both);
  const SyntheticBody body{v6()};
  for (const Exposure& exposure : simulate(v6(), plan, 1).exposures) {
    const auto torsoFromLink = body.forwardKinematics(exposure.joints);
    const Eigen::Isometry3d leftFromRight =
        torsoFromLink[v6().findSole("left")->link].inverse() * torsoFromLink[v6().findSole("right")->link];
    CHECK(std::abs(leftFromRight.translation().z()) < 1e-4);
    CHECK(leftFromRight.linear().col(2).head<2>().norm() < 1e-4);
  }
}

TEST_CASE("the feet's sensors carry the robot's weight below its centre of mass") {
  // Proves that forces add up to the mass, that their centre is below the centre of mass, in balanced poses, and that a
  // lifted foot has no load. Without noise.
  SimulationPlan plan = handMadePlan(v6(), 1);
  plan.offsetRange = plan.mechanics.forceNoise = 0;
  const SyntheticBody body{v6()};
  for (const auto& [foot, lean] :
       {std::pair{SupportFoot::left, 0.22}, {SupportFoot::right, -0.22}, {SupportFoot::both, 0.0}}) {
    plan.poses[0].supportFoot = foot;
    plan.poses[0].angles.setZero();
    for (const char* side : {"L", "R"}) {
      plan.poses[0].angles[static_cast<Eigen::Index>(*v6().jointIndex(std::string{side} + "AnkleRoll"))] = lean;
      plan.poses[0].angles[static_cast<Eigen::Index>(*v6().jointIndex(std::string{side} + "HipRoll"))] = -lean;
    }
    const Simulation simulation = simulate(v6(), plan, 1);
    const auto torsoFromLink = body.forwardKinematics(simulation.exposures[0].joints);
    const std::array<double, 8> weights = *simulation.set.captures[0].fsr;
    double sum = 0;
    Eigen::Vector3d moment = Eigen::Vector3d::Zero(); // in the torso's frame [kg m]
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const Sole& sole = *v6().findSole(i < 4 ? "left" : "right");
      const Eigen::Vector2d& place = sole.forceSensors[i % 4];
      CHECK((weights[i] > 0) == (foot == SupportFoot::both || (foot == SupportFoot::left) == (i < 4)));
      moment += weights[i] * (torsoFromLink[sole.link] * Eigen::Vector3d{place.x(), place.y(), 0});
      sum += weights[i];
    }
    CHECK(sum == Approx(body.mass()));
    const Eigen::Isometry3d soleFromTorso =
        torsoFromLink[v6().findSole(foot == SupportFoot::right ? "right" : "left")->link].inverse();
    const Eigen::Vector3d offCentre =
        soleFromTorso * Eigen::Vector3d{moment / sum} - soleFromTorso * body.centreOfMass(torsoFromLink);
    CHECK(offCentre.head<2>().norm() < 1e-5);
  }
}

TEST_CASE("the inertial unit reports the torso's roll and pitch") {
  // Proves signs and order: leaning forward is a positive pitch, leaning to the right a positive roll. Without noise.
  SimulationPlan plan = handMadePlan(v6(), 1);
  plan.offsetRange = plan.mechanics.imuNoise = plan.mechanics.servoDroop = plan.mechanics.servoDeadZone = 0;
  plan.mechanics.residualSpeed = 0;
  plan.poses[0].angles.setZero();
  plan.poses[0].angles[static_cast<Eigen::Index>(*v6().jointIndex("LAnklePitch"))] = -0.2; // the body leans forward
  CHECK((*simulate(v6(), plan, 1).set.captures[0].imu - Eigen::Vector2d{0, 0.2}).norm() < 1e-9);
  plan.poses[0].angles.setZero();
  plan.poses[0].angles[static_cast<Eigen::Index>(*v6().jointIndex("LAnkleRoll"))] = -0.1; // the body leans to the right
  CHECK((*simulate(v6(), plan, 1).set.captures[0].imu - Eigen::Vector2d{0.1, 0}).norm() < 1e-9);
}

TEST_CASE("a joint's approach is the direction of its last motion") {
  // Proves the signs for a motion up, a motion down and a pause. The effect of the direction is not tested.
  SimulationPlan plan = handMadePlan(v6(), 4);
  const std::size_t knee = *v6().jointIndex("LKneePitch");
  const std::vector<double> angles{0.5, 0.9, 0.3, 0.3}, expected{1, 1, -1, -1};
  for (std::size_t pose = 0; pose < 4; ++pose) {
    plan.poses[pose].angles[static_cast<Eigen::Index>(knee)] = angles[pose];
  }
  for (const Capture& capture : simulate(v6(), plan, 1).set.captures) {
    CHECK(capture.joints.approach[knee] == expected[static_cast<std::size_t>(capture.pose.back() - '0')]);
  }
}

TEST_CASE("a pose is approached as it asks") {
  // Proves that every joint's last motion has the requested direction, against its path from the previous pose; joints
  // without a request keep theirs.
  SimulationPlan plan = handMadePlan(v6(), 2), asked = plan;
  for (CommandedPose& pose : asked.poses) {
    pose.approach = Eigen::VectorXd::Constant(pose.angles.size(), -1);
    pose.approach[0] = 0;
  }
  const Simulation free = simulate(v6(), plan, 1), bound = simulate(v6(), asked, 1);
  for (std::size_t i = 0; i < bound.set.captures.size(); ++i) {
    const std::vector<double>& approach = bound.set.captures[i].joints.approach;
    CHECK(approach[0] == free.set.captures[i].joints.approach[0]);
    CHECK(std::all_of(approach.begin() + 1, approach.end(), [](double each) { return each == -1; }));
  }
}

TEST_CASE("motors under load warm up, the others keep their temperature") {
  // Proves the direction of heating: after 24 poses a bent support knee is at least 0.3 K warmer than an elbow.
  const Simulation simulation = simulate(v6(), handMadePlan(v6(), 24), 1);
  const std::vector<double>& temperatures = simulation.set.captures.back().joints.temperature;
  CHECK(temperatures[*v6().jointIndex("LKneePitch")] > temperatures[*v6().jointIndex("LElbowYaw")] + 0.3);
  CHECK(temperatures[*v6().jointIndex("LElbowYaw")] == Approx(30).margin(0.1));
}

TEST_CASE("time runs on from capture to capture, 30 ms from one camera to the other") {
  // Proves that no two captures share a time, and that a change of pose takes over a second. Joint speeds are not
  // tested.
  const Simulation simulation = simulate(v6(), handMadePlan(v6(), 5), 1);
  const std::vector<Capture>& captures = simulation.set.captures;
  for (std::size_t i = 1; i < captures.size(); ++i) {
    const double passed = (captures[i].time - captures[i - 1].time).count();
    if (captures[i].camera != captures[i - 1].camera && i % 2 == 1) {
      CHECK(passed == Approx(0.03));
    } else {
      CHECK(passed > (captures[i].pose == captures[i - 1].pose ? 0.1 : 1.0));
    }
  }
}

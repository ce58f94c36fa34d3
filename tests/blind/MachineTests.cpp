#include "world/machines/MachineBuilds.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace blind {
namespace {

/// Potential energy of all links [J].
double energy(const Machine& machine, const MachineBody& body, const Eigen::VectorXd& angles) {
  const MachineBody::Posture posture = body.settled(angles);
  double sum = 9.81 * machine.baseKilograms * (posture.base * machine.baseCentre).z();
  for (std::size_t i = 0; i < machine.joints.size(); ++i) {
    sum += 9.81 * machine.joints[i].kilograms * (posture.links[i] * machine.joints[i].centre).z();
  }
  return sum;
}

Eigen::VectorXd someAngles(const Machine& machine, RandomStream& chance) {
  Eigen::VectorXd angles{static_cast<Eigen::Index>(machine.joints.size())};
  for (double& angle : angles) {
    angle = chance.uniformWithin(0.4);
  }
  return angles;
}

} // namespace

TEST_CASE("a machine's origin turns by yaw, then pitch, then roll, as URDF defines it") {
  // Proves the order by a case worked out by hand: yaw 90 degrees takes x to y; pitch 90 degrees takes x to -z.
  const double quarter = M_PI / 2;
  const Eigen::Matrix3d turn = originTransform({1, 2, 3}, {0, quarter, quarter}).turn;
  CHECK((turn * Eigen::Vector3d::UnitX() - -Eigen::Vector3d::UnitZ()).norm() < 1e-12);
  CHECK((turn * Eigen::Vector3d::UnitY() - -Eigen::Vector3d::UnitX()).norm() < 1e-12);
  const Eigen::Vector3d angles{0.3, -0.4, 2.5};
  CHECK((rollPitchYaw(originTransform({0, 0, 0}, angles).turn) - angles).norm() < 1e-12);
}

TEST_CASE("gravity's torque on a machine's joint is minus the slope of its energy") {
  // Proves torques of turning and sliding joints in five builds by differences of the energy, which needs no torque. A
  // machine on one foot holds it still: the rest turns.
  for (const MachineBuild build :
       {MachineBuild::elbow, MachineBuild::offset, MachineBuild::slender, MachineBuild::railed, MachineBuild::legged}) {
    RandomStream chance{static_cast<std::uint64_t>(build), "machine"};
    const Machine machine = drawMachine(build, chance);
    const MachineFlaws none{machine.joints.size()};
    const MachineBody body{machine, none};
    const Eigen::VectorXd angles = someAngles(machine, chance);
    const Eigen::VectorXd torques = body.torques(body.settled(angles));
    for (Eigen::Index i = 0; i < angles.size(); ++i) {
      constexpr double nudge = 1e-5;
      Eigen::VectorXd before = angles, after = angles;
      before[i] -= nudge;
      after[i] += nudge;
      const double slope = (energy(machine, body, after) - energy(machine, body, before)) / (2 * nudge);
      CHECK(torques[i] == Approx(-slope).margin(1e-5));
    }
  }
}

TEST_CASE("a yielding bearing of a machine gives way about the axes across its own, in the sense of gravity") {
  // Proves size and sign on one horizontal link, 2 kg at 0.5 m along x with an axis along z: 9.81 Nm about y, which
  // lowers the tip.
  Machine machine;
  Machine::Joint joint;
  joint.name = "only";
  joint.link = "arm";
  joint.xyz = joint.rpy = Eigen::Vector3d::Zero();
  joint.axis = Eigen::Vector3d::UnitZ();
  joint.kilograms = 2;
  joint.centre = {0.5, 0, 0};
  machine.joints.push_back(joint);
  machine.attached.push_back({"hand", 0, {1, 0, 0}, {0, 0, 0}});
  MachineFlaws flaws{1};
  flaws.links[0].bearing = {0, 1e-4}; // the normals of z are x and y
  const MachineBody body{machine, flaws};
  const Eigen::Vector3d tip = body.worldFromAttached(body.settled(Eigen::VectorXd::Zero(1)), 0).shift;
  CHECK(tip.z() == Approx(-9.81e-4).epsilon(1e-3));
  CHECK(tip.y() == Approx(0).margin(1e-9));
}

TEST_CASE("the normals of an axis are those of the contract") {
  // Proves the rule for +y, for -z and for an oblique axis by cases worked out by hand.
  const auto [ofY, alsoOfY] = normalsOf({0, 1, 0});
  CHECK(ofY == Eigen::Vector3d::UnitZ());
  CHECK(alsoOfY == Eigen::Vector3d::UnitX());
  const auto [ofDown, alsoOfDown] = normalsOf({0, 0, -1});
  CHECK(ofDown == Eigen::Vector3d::UnitX());
  CHECK((alsoOfDown - -Eigen::Vector3d::UnitY()).norm() < 1e-12);
  const auto [oblique, other] = normalsOf({0.6, 0.8, 0});
  CHECK((oblique - Eigen::Vector3d::UnitZ()).norm() < 1e-12);
  CHECK((other - Eigen::Vector3d{0.8, -0.6, 0}).norm() < 1e-12);
}

} // namespace blind

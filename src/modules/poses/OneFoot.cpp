#include "poses/OneFoot.hpp"

#include "io/InputError.hpp"
#include "math/LinearAlgebra.hpp"
#include "math/Polygon.hpp"
#include "poses/BoardPlaces.hpp"
#include "robot/Balance.hpp"
#include "robot/Gravity.hpp"

#include <Eigen/Geometry>
#include <array>
#include <fmt/format.h>

namespace naocal {

OneFoot::OneFoot(const Robot& robot, SupportFoot supportFoot)
    : robot_{robot}, supportLeg_{robot, supportSole(robot, supportFoot).name},
      otherLeg_{robot, otherSole(robot, supportFoot).name}, middle_{naocal::middle(
                                                                supportSole(robot, supportFoot).outline)} {}

bool OneFoot::stand(Belief& belief, RigidTransform soleFromTorso, const RigidTransform& soleFromOther,
                    const Eigen::Vector2d& centre) const {
  soleFromTorso.translation.head<2>() = centre;
  constexpr int rounds = 3; // each leaves a small share of the distance
  for (int round = 0; round < rounds; ++round) {
    if (!bend(belief, soleFromTorso, soleFromOther)) {
      return false;
    }
    const Eigen::Vector3d reached = soleFromTorso * centreOfMass(robot_, posture(robot_, belief)).inTorso;
    soleFromTorso.translation.head<2>() += centre - reached.head<2>();
  }
  return bend(belief, soleFromTorso, soleFromOther);
}

bool OneFoot::bend(Belief& belief, const RigidTransform& soleFromTorso, const RigidTransform& soleFromOther) const {
  const RigidTransform torsoFromSole = soleFromTorso.inverse();
  const auto support = supportLeg_.angles(torsoFromSole);
  const auto other = support ? otherLeg_.angles(torsoFromSole * soleFromOther, support->front()) : std::nullopt;
  if (!other) {
    return false;
  }
  for (std::size_t i = 0; i < support->size(); ++i) {
    belief.angle(supportLeg_.joints()[i]) = (*support)[i];
    belief.angle(otherLeg_.joints()[i]) = (*other)[i];
  }
  return true;
}

Eigen::VectorXd bentKnees(const Robot& robot) {
  Eigen::VectorXd angles = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(robot.joints.size()));
  for (const auto& [joint, degrees] : {std::pair{"ShoulderPitch", 90}, std::pair{"HipPitch", -25},
                                       std::pair{"KneePitch", 50}, std::pair{"AnklePitch", -25}}) {
    for (const char* side : {"L", "R"}) {
      angles[static_cast<Eigen::Index>(robot.jointIndex(side + std::string{joint}).value())] = radians(degrees);
    }
  }
  return angles;
}

std::vector<Eigen::VectorXd> ontoOneFoot(const Robot& robot, SupportFoot supportFoot, const Eigen::VectorXd& stand) {
  struct Point {
    double shift;       // share of the way over the foot
    double height;      // of the torso over the sole [m]
    double lift;        // of the other sole from the floor [m]
    double roll, pitch; // of the torso, outwards and forwards [rad]
  };
  // of 58 simulated robots with joints off by 5 degrees that nobody holds, one or seven (left, right foot) fall on it
  constexpr std::array points{Point{0.5, 0.30, 0, 0.15, 0.15}, Point{1, 0.30, 0, 0.25, 0.2},
                              Point{1.1, 0.31, 0.02, 0.3, 0.2}, Point{1, 0.31, 0.04, 0.3, 0.3}};
  constexpr double forwards = 0.025; // the centre of mass, from the sole's origin [m]
  const OneFoot feet{robot, supportFoot};
  const double inwards = supportFoot == SupportFoot::left ? -1 : 1;
  const Eigen::Vector2d over{forwards, feet.middle().y()}, between{forwards, inwards * betweenFeet / 2};
  Belief belief = drawnBelief(robot, Quantities{robot.joints.size(), robot.lengths.size(), 0});
  belief.values.head(stand.size()) = stand;
  std::vector<Eigen::VectorXd> way;
  for (const Point& point : points) {
    RigidTransform soleFromTorso, soleFromOther;
    soleFromTorso.rotation = rotationY(point.pitch) * rotationX(inwards * point.roll);
    soleFromTorso.translation.z() = point.height;
    soleFromOther.translation << 0, inwards * betweenFeet, point.lift;
    if (!feet.stand(belief, soleFromTorso, soleFromOther, between + point.shift * (over - between))) {
      throw InputError{fmt::format("the legs of the {} do not reach from its stand onto its {} foot", robot.model,
                                   supportFoot == SupportFoot::left ? "left" : "right")};
    }
    way.push_back(belief.values.head(stand.size()));
  }
  return way;
}

std::optional<std::vector<Eigen::VectorXd>> betweenOnOneFoot(const Robot& robot, SupportFoot supportFoot,
                                                             const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                                                             int parts) {
  const OneFoot feet{robot, supportFoot};
  const std::size_t support = supportSole(robot, supportFoot).link, other = otherSole(robot, supportFoot).link;
  struct End {
    RigidTransform soleFromTorso, soleFromOther;
    Eigen::Vector3d centre;
  };
  const auto end = [&](const Eigen::VectorXd& angles) {
    const Posture torsoFromLink = posture(robot, angles);
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
  Belief belief = drawnBelief(robot, Quantities{robot.joints.size(), robot.lengths.size(), 0});
  for (int i = 1; i < parts; ++i) {
    const double share = static_cast<double>(i) / parts;
    belief.values.head(from.size()) = (1 - share) * from + share * to;
    if (!feet.stand(belief, blend(one.soleFromTorso, two.soleFromTorso, share),
                    blend(one.soleFromOther, two.soleFromOther, share),
                    ((1 - share) * one.centre + share * two.centre).head<2>())) {
      return std::nullopt;
    }
    via.push_back(belief.values.head(from.size()));
  }
  return via;
}

} // namespace naocal

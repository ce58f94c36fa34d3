#include "PlainRobot.hpp"
#include "RobotV6.hpp"
#include "measurements/Measurements.hpp"
#include "robot/SelfCollision.hpp"

#include <catch2/catch.hpp>
#include <fcl/narrowphase/collision_object.h>
#include <fcl/narrowphase/distance.h>
#include <memory>
#include <random>

using namespace naocal;

namespace {

/// The drawing's capsules in the Flexible Collision Library, moved by the plain robot's kinematics.
class LibraryHull {
public:
  explicit LibraryHull(const plain::Json& robot) : robot_{robot} {
    for (const plain::Json& capsule : robot["hull"]["capsules"]) {
      const Eigen::Vector3d from = plain::metres(capsule["fromMillimetres"]),
                            to = plain::metres(capsule["toMillimetres"]);
      Eigen::Isometry3d linkFromShape = Eigen::Isometry3d::Identity();
      linkFromShape.translate((from + to) / 2);
      linkFromShape.rotate(Eigen::Quaterniond::FromTwoVectors(
          Eigen::Vector3d::UnitZ(), from == to ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d{to - from}));
      parts_.push_back(
          {capsule["link"].get<std::string>(), linkFromShape,
           std::make_shared<fcl::Capsuled>(capsule["radiusMillimetres"].get<double>() / 1000, (to - from).norm())});
    }
    plain::Angles resting;
    for (const auto& [name, joint] : robot["joints"].items()) {
      if (joint.is_object()) {
        resting[name] = joint.value("restingDegrees", 0.0) * plain::degree;
      }
    }
    const auto atRest = plain::posture(robot, resting);
    for (std::size_t a = 0; a < parts_.size(); ++a) {
      for (std::size_t b = a + 1; b < parts_.size(); ++b) {
        if (jointsBetween(parts_[a].link, parts_[b].link) > 2 && distance(a, b, atRest) >= 0.01) {
          pairs_.emplace_back(a, b);
        }
      }
    }
  }

  /// Least distance of two parts that may touch; 0 or less if some touch [m].
  double leastDistance(const plain::Angles& angles) const {
    const auto posture = plain::posture(robot_, angles);
    double least = 1;
    for (const auto& [a, b] : pairs_) {
      least = std::min(least, distance(a, b, posture));
    }
    return least;
  }

private:
  struct Part {
    std::string link;
    Eigen::Isometry3d linkFromShape;
    std::shared_ptr<fcl::Capsuled> shape;
  };

  double distance(std::size_t a, std::size_t b, const std::map<std::string, Eigen::Isometry3d>& posture) const {
    fcl::DistanceRequestd request;
    request.enable_signed_distance = true;
    fcl::DistanceResultd result;
    const fcl::CollisionObjectd one{parts_[a].shape, posture.at(parts_[a].link) * parts_[a].linkFromShape};
    const fcl::CollisionObjectd other{parts_[b].shape, posture.at(parts_[b].link) * parts_[b].linkFromShape};
    fcl::distance(&one, &other, request, result);
    return result.min_distance;
  }

  /// Joints between the root and a link.
  std::vector<std::string> jointsTo(std::string link) const {
    std::vector<std::string> joints;
    while (!link.empty()) {
      for (const plain::Json& each : robot_["tree"]["links"]) {
        if (each["name"] == link) {
          if (each.contains("joint")) {
            joints.push_back(each["joint"].get<std::string>());
          }
          link = each.value("parent", "");
          break;
        }
      }
    }
    return joints;
  }

  int jointsBetween(const std::string& a, const std::string& b) const {
    const auto ofA = jointsTo(a), ofB = jointsTo(b);
    const auto lacks = [](const std::vector<std::string>& list) {
      return [&list](const std::string& joint) { return std::find(list.begin(), list.end(), joint) == list.end(); };
    };
    return static_cast<int>(std::count_if(ofA.begin(), ofA.end(), lacks(ofB)) +
                            std::count_if(ofB.begin(), ofB.end(), lacks(ofA)));
  }

  const plain::Json& robot_;
  std::vector<Part> parts_;
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;
};

} // namespace

TEST_CASE("a collision library finds the same postures touching", "[slow]") {
  // Compares SelfCollision with FCL on 3000 random postures of the whole robot, in both directions, with kinematics and
  // selection of pairs reimplemented from the drawing; postures within 0.1 mm of the clearance are skipped. Whether the
  // capsules have the robot's shape is not tested.
  const plain::Json drawing = plain::drawing("V6");
  const LibraryHull library{drawing};
  const Robot robot = v6();
  constexpr double clearance = 0.005, unclear = 1e-4;
  const SelfCollision ours{robot, clearance};
  std::mt19937 random{4};
  int touching = 0, apart = 0;
  for (int draw = 0; draw < 3000; ++draw) {
    const double share = std::uniform_real_distribution{0.1, 0.8}(random); // of the range from rest to the limits
    plain::Angles angles;
    Eigen::VectorXd ofJoints(static_cast<Eigen::Index>(robot.joints.size()));
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
      const Joint& drawn = robot.joints[joint];
      const double resting = std::clamp(drawn.restAngle, drawn.limits.lower, drawn.limits.upper);
      const double to = std::uniform_real_distribution{drawn.limits.lower, drawn.limits.upper}(random);
      angles[drawn.name] = resting + share * (to - resting);
      ofJoints[static_cast<Eigen::Index>(joint)] = angles[drawn.name];
    }
    const double distance = library.leastDistance(angles);
    if (std::abs(distance - clearance) < unclear) {
      continue;
    }
    const bool touches = ours.collides(forwardKinematics(robot, ofJoints));
    CHECK(touches == (distance < clearance));
    ++(touches ? touching : apart);
  }
  CHECK(touching > 300);
  CHECK(apart > 300);
}

#include "writer/Poses.hpp"

#include "world/Pictures.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace blind {

namespace {

constexpr std::array<char, 2> letters{'L', 'R'};

/// Mirrors a left-side value for the right side.
double mirrored(int side, double left) {
  return side == 0 ? left : -left;
}

double interpolated(const std::vector<Drawing::Row>& rows, double other, double Drawing::Row::*limit) {
  if (other <= rows.front().other) {
    return rows.front().*limit;
  }
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (other <= rows[i].other) {
      const double share = (other - rows[i - 1].other) / (rows[i].other - rows[i - 1].other);
      return (1 - share) * rows[i - 1].*limit + share * rows[i].*limit;
    }
  }
  return rows.back().*limit;
}

} // namespace

std::vector<int> chainOf(const Drawing& drawing, int side) {
  std::vector<int> chain;
  for (const Drawing::Camera& camera : drawing.cameras) {
    for (int joint = camera.joint; joint >= 0 && chain.size() < 2; joint = drawing.joints[joint].parent) {
      chain.push_back(joint);
    }
  }
  for (int joint = drawing.soles[side].joint; joint >= 0; joint = drawing.joints[joint].parent) {
    const std::string& motor = drawing.joints[joint].drivenBy;
    chain.push_back(motor.empty() ? joint : drawing.joint(motor));
  }
  std::sort(chain.begin(), chain.end());
  return chain;
}

std::vector<FloorPlace> placeBoards(int boards, RandomStream& chance) {
  std::vector<FloorPlace> places;
  const double spread = 2.9, between = spread / (boards - 1); // [rad]
  for (int board = 0; board < boards; ++board) {
    const double bearing = -spread / 2 + board * between + chance.uniformWithin(0.05);
    const double distance = chance.between(0.5, 0.66);
    const double yaw = bearing - std::numbers::pi / 2 + chance.uniformWithin(0.3); // upper edge away from the robot
    const Transform turned = floorTransform(0, 0, yaw);
    const Eigen::Vector3d middle{0.5 * Sheet::squaresX * Sheet::square, -0.5 * Sheet::squaresY * Sheet::square, 0};
    const Eigen::Vector3d corner =
        Eigen::Vector3d{distance * std::cos(bearing), distance * std::sin(bearing), 0} - turned * middle;
    places.push_back({corner.x(), corner.y(), yaw});
  }
  return places;
}

Eigen::VectorXd PoseDrawer::drawStable(const PoseWish& wish, RandomStream& chance) const {
  constexpr int tries = 20000, looks = 4;
  for (int attempt = 0; attempt < tries; ++attempt) {
    Eigen::VectorXd angles{static_cast<Eigen::Index>(drawing_.joints.size())};
    if (!bend(wish.side, chance, wish.hipYawPitch, angles)) {
      continue;
    }
    double best = wish.enough;
    Eigen::VectorXd bestAngles;
    for (int turn = 0; turn < looks; ++turn) {
      const auto target = static_cast<std::size_t>(chance.below(static_cast<int>(wish.targetsInSole.size())));
      look(wish.side, wish.camera, wish.targetsInSole[target], chance, angles);
      if (withinLimits(angles)) {
        if (const double value = wish.worth(angles) * chance.between(0.7, 1); value > best) {
          best = value;
          bestAngles = angles;
        }
      }
    }
    if (bestAngles.size() > 0) {
      return bestAngles;
    }
  }
  throw std::runtime_error{"no stable attitude sees a board: the boards lie too far away"};
}

bool PoseDrawer::bend(int side, RandomStream& chance, std::optional<double> hipYawPitch,
                      Eigen::VectorXd& angles) const {
  for (std::size_t i = 0; i < drawing_.joints.size(); ++i) {
    angles[static_cast<Eigen::Index>(i)] = drawing_.joints[i].resting;
  }
  const auto set = [&](int leg, const char* joint, double angle) {
    angles[drawing_.joint(letters[leg] + std::string{joint})] = angle;
  };
  const double yawPitch = hipYawPitch.value_or(chance.between(-0.6, 0.2)), roll = chance.uniformWithin(0.3);
  const double hip = chance.between(-1.1, 0.25), knee = chance.between(0.05, 1.5);
  for (int leg = 0; leg < 2; ++leg) {
    set(leg, "HipYawPitch", yawPitch);
  }
  set(side, "HipRoll", mirrored(side, roll));
  set(side, "HipPitch", hip);
  set(side, "KneePitch", knee);
  set(side, "AnklePitch", chance.between(-0.9, 0.2));
  set(side, "AnkleRoll", mirrored(side, -roll));
  set(1 - side, "HipRoll", mirrored(side, chance.between(-0.6, 0.2)));
  set(1 - side, "HipPitch", chance.between(-1.3, 0.3));
  set(1 - side, "KneePitch", chance.between(0, 1.8));
  set(1 - side, "AnklePitch", chance.uniformWithin(0.5));
  set(1 - side, "AnkleRoll", chance.uniformWithin(0.2));
  const Eigen::Vector2d target{chance.between(-0.02, 0.06), mirrored(side, chance.between(-0.012, 0.024))};
  if (!balance(side, target, angles) || !withinLimits(angles)) {
    return false;
  }
  const Skeleton::Posture posture = skeleton_.posture(angles);
  constexpr double leastUpright = 0.77; // cosine of the torso's tilt
  return skeleton_.torsoFromSole(posture, side).turn(2, 2) > leastUpright && feetApart(side, posture);
}

/// Turns the head so that the target is near the image centre.
void PoseDrawer::look(int side, int camera, const Eigen::Vector3d& targetInSole, RandomStream& chance,
                      Eigen::VectorXd& angles) const {
  const Eigen::Vector3d fromNeck = skeleton_.torsoFromSole(skeleton_.posture(angles), side) * targetInSole -
                                   drawing_.lengths.at("neckZ") * Eigen::Vector3d::UnitZ();
  constexpr double beside = 0.35, above = 0.2; // [rad]
  angles[drawing_.joint("HeadYaw")] = std::atan2(fromNeck.y(), fromNeck.x()) + chance.uniformWithin(beside);
  angles[drawing_.joint("HeadPitch")] = std::atan2(-fromNeck.z(), fromNeck.head<2>().norm()) -
                                        drawing_.cameras[camera].pitch + chance.uniformWithin(above);
}

Eigen::Vector2d PoseDrawer::balancePoint(int side, const Eigen::VectorXd& angles) const {
  const Skeleton::Posture posture = skeleton_.posture(angles);
  return (skeleton_.torsoFromSole(posture, side).inverse() * skeleton_.centreOfMass(posture)).head<2>();
}

/// Moves the centre of mass above the target by Newton's method on the support ankle's two angles.
bool PoseDrawer::balance(int side, const Eigen::Vector2d& target, Eigen::VectorXd& angles) const {
  constexpr double step = 1e-5, closeEnough = 1e-4; // [rad], [m]
  const std::array<int, 2> ankle{drawing_.joint(letters[side] + std::string{"AnklePitch"}),
                                 drawing_.joint(letters[side] + std::string{"AnkleRoll"})};
  for (int round = 0; round < 8; ++round) {
    const Eigen::Vector2d missing = target - balancePoint(side, angles);
    if (missing.norm() < closeEnough) {
      return true;
    }
    Eigen::Matrix2d slope;
    for (int i = 0; i < 2; ++i) {
      Eigen::VectorXd moved = angles;
      moved[ankle[i]] += step;
      slope.col(i) = (balancePoint(side, moved) - (target - missing)) / step;
    }
    const Eigen::Vector2d change = slope.inverse() * missing;
    if (!(change.norm() < 1)) {
      return false;
    }
    angles[ankle[0]] += change[0];
    angles[ankle[1]] += change[1];
  }
  return false;
}

bool PoseDrawer::withinLimits(const Eigen::VectorXd& angles) const {
  for (std::size_t i = 0; i < drawing_.joints.size(); ++i) {
    const Drawing::Joint& joint = drawing_.joints[i];
    const double angle = angles[static_cast<Eigen::Index>(i)];
    double lower = joint.lower, upper = joint.upper;
    if (!joint.coupled.empty()) {
      const double other = angles[drawing_.joint(joint.coupledTo)];
      lower = std::max(lower, interpolated(joint.coupled, other, &Drawing::Row::lower));
      upper = std::min(upper, interpolated(joint.coupled, other, &Drawing::Row::upper));
    }
    const bool resting = angle == joint.resting; // hanging arms are not checked
    if (!resting && (angle < lower || angle > upper)) {
      return false;
    }
  }
  return true;
}

/// Whether the lifted foot is above the floor and beside the support foot.
bool PoseDrawer::feetApart(int side, const Skeleton::Posture& posture) const {
  constexpr double clearance = 0.01, apart = 0.08; // [m]
  const Transform standingFromLifted =
      skeleton_.torsoFromSole(posture, side).inverse() * skeleton_.torsoFromSole(posture, 1 - side);
  if (mirrored(side, -standingFromLifted.shift.y()) < apart) {
    return false;
  }
  const auto& outline = drawing_.soles[1 - side].outline;
  return std::all_of(outline.begin(), outline.end(), [&](const Eigen::Vector2d& point) {
    return (standingFromLifted * Eigen::Vector3d{point.x(), point.y(), 0}).z() > clearance;
  });
}

} // namespace blind

#include "synthetic/SyntheticRobot.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace naocal {

namespace {

bool carries(SupportFoot supportFoot, std::size_t side) {
  return supportFoot == SupportFoot::both || (supportFoot == SupportFoot::left) == (side == 0);
}

constexpr std::array<const char*, 2> sides{"left", "right"};

} // namespace

/// The weight on the sensors of the loaded soles: of all distributions whose sum is the weight and whose middle lies
/// below the centre of mass the one with the least sum of squares; sensors cannot pull.
std::array<double, 8> SyntheticRobot::forces(const Eigen::VectorXd& joints, SupportFoot supportFoot) const {
  const std::vector<Eigen::Isometry3d> torsoFromLink = body_.posture(joints);
  const Eigen::Isometry3d soleFromTorso = torsoFromLink[soleLink(supportFoot)].inverse();
  Eigen::Matrix<double, 3, 8> balance = Eigen::Matrix<double, 3, 8>::Zero(); // sum, moments in x and y
  for (std::size_t side = 0; side < sides.size(); ++side) {
    const Sole* sole = drawing_.sole(sides[side]);
    for (std::size_t sensor = 0; carries(supportFoot, side) && sensor < sole->forceSensors.size(); ++sensor) {
      const Eigen::Vector2d& place = sole->forceSensors[sensor];
      const Eigen::Vector3d inSupport =
          soleFromTorso * torsoFromLink[sole->link] * Eigen::Vector3d{place.x(), place.y(), 0};
      balance.col(static_cast<Eigen::Index>(4 * side + sensor)) << 1, inSupport.x(), inSupport.y();
    }
  }
  const Eigen::Vector3d centre = soleFromTorso * body_.centreOfMass(torsoFromLink);
  const Eigen::Vector3d load = body_.mass() * Eigen::Vector3d{1, centre.x(), centre.y()};
  const Eigen::Matrix<double, 8, 1> weights = balance.transpose() * (balance * balance.transpose()).inverse() * load;
  std::array<double, 8> result{};
  std::transform(weights.begin(), weights.end(), result.begin(), [](double weight) { return std::max(weight, 0.0); });
  return result;
}

Eigen::VectorXd SyntheticRobot::gravityTorques(const Eigen::VectorXd& joints, SupportFoot supportFoot) const {
  if (supportFoot != SupportFoot::both) {
    return body_.gravityTorques(joints, soleLink(supportFoot));
  }
  const std::array<double, 8> weights = forces(joints, supportFoot);
  const double left = std::accumulate(weights.begin(), weights.begin() + 4, 0.0);
  const double right = std::accumulate(weights.begin() + 4, weights.end(), 0.0);
  return (left * body_.gravityTorques(joints, soleLink(SupportFoot::left)) +
          right * body_.gravityTorques(joints, soleLink(SupportFoot::right))) /
         (left + right);
}

std::array<double, 8> SyntheticRobot::forceReadings(const TakenPose& taken, Randomness& chance) const {
  std::array<double, 8> readings = forces(jointAngles(taken, Seconds{0}), taken.supportFoot);
  for (double& reading : readings) {
    reading = std::max(reading + chance.normal(mechanics_.forceNoise), 0.0);
  }
  return readings;
}

Eigen::Vector2d SyntheticRobot::imuReading(const Eigen::Matrix3d& worldFromTorso, Randomness& chance) const {
  const double roll = std::atan2(worldFromTorso(2, 1), worldFromTorso(2, 2));
  const double pitch = std::asin(-worldFromTorso(2, 0));
  return {roll + chance.normal(mechanics_.imuNoise), pitch + chance.normal(mechanics_.imuNoise)};
}

Eigen::VectorXd SyntheticRobot::currentReadings(const TakenPose& taken, Randomness& chance) const {
  Eigen::VectorXd currents = mechanics_.currentPerTorque * taken.torques;
  for (double& current : currents) {
    current = std::abs(current + chance.normal(mechanics_.currentNoise));
  }
  return currents;
}

void SyntheticRobot::warm(Eigen::VectorXd& temperatures, const Eigen::VectorXd& torques, Seconds duration) const {
  const Eigen::ArrayXd target =
      mechanics_.ambientTemperature + mechanics_.heatPerTorqueSquared * torques.array().square();
  const double towards = 1 - std::exp(-duration.count() / mechanics_.thermalTimeConstant);
  temperatures.array() += towards * (target - temperatures.array());
}

} // namespace naocal

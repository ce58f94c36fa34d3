#include "calibrate/BoardAlignment.hpp"
#include "camera/BoardPose.hpp"
#include "math/LinearAlgebra.hpp"
#include "residuals/PictureGram.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <set>

namespace naocal {

namespace {

constexpr double angleScale = 0.1;    // [rad]
constexpr double distanceScale = 0.1; // of the depth
constexpr double huber = 2;           // in units of those
constexpr double cornerNoise = 1;     // [px]: generous, false corners and a wrong lens included

Eigen::Vector3d rotationVector(const Eigen::Matrix3d& rotation) {
  const Eigen::AngleAxisd turn{rotation};
  return turn.angle() * turn.axis();
}

Eigen::Vector3d middleOf(const CornerBlocks& corners) {
  Eigen::Vector3d total = Eigen::Vector3d::Zero();
  double count = 0;
  for (const CornerBlock& block : corners) {
    total += Eigen::Vector3d{sum(block.x * block.present), sum(block.y * block.present), sum(block.z * block.present)};
    count += sum(block.present);
  }
  return total / count;
}

/// A board's pose in the camera improved on its corners (Gauss-Newton), and the information that they hold about its
/// motion (omega, v). Absent where the corners do not fit any pose.
struct SeenPose {
  RigidTransform opticalFromBoard;
  Eigen::Matrix<double, 6, 6> information;
};
std::optional<SeenPose> seenPose(const Sighting& sighting, const Belief& belief) {
  const auto start = boardPose(sighting.corners, belief.lens());
  if (!start) {
    return std::nullopt;
  }
  Attitude attitude;
  attitude.opticalFromBoard = *start;
  ProjectedBlocks projected;
  PictureGram sums;
  for (int i = 0; i < 10; ++i) {
    if (!sighting.view.project(attitude, belief, sighting.corners, projected)) {
      return std::nullopt;
    }
    sums.clear();
    sums.add(sighting.corners, projected, {}, cornerNoise, {}, {});
    const Eigen::VectorXd step = -sums.gram().ldlt().solve(sums.gradient());
    const Eigen::Vector3d omega = step.head<3>(), v = step.tail<3>();
    attitude.opticalFromBoard = RigidTransform{rotationAbout(omega), v} * attitude.opticalFromBoard;
  }
  const bool fits = std::isfinite(sums.squares()) && sums.squares() < 25 * sums.corners() * cornerNoise * cornerNoise;
  return fits ? std::optional{SeenPose{attitude.opticalFromBoard, sums.gram() / (cornerNoise * cornerNoise)}}
              : std::nullopt;
}

} // namespace

BoardAlignment::BoardAlignment(const Measurements& measurements, const Model& model)
    : measurements_{measurements}, model_{model}, sigmas_{model.sigmas()} {
  for (const PoseGroup& pose : measurements.poses) {
    std::set<std::size_t> stances;
    for (const Reading& reading : pose.readings) {
      if (stances.insert(measurements.pictures[reading.pictures.front()].stance).second) {
        addReading(reading);
      }
    }
  }
}

void BoardAlignment::addReading(const Reading& reading) {
  for (std::size_t index : reading.pictures) {
    const Picture& picture = measurements_.pictures[index];
    const std::vector<Slope> all = slopes(measurements_, model_, picture, Eigen::VectorXd::Zero(sigmas_.size()));
    for (const Sighting& sighting : picture.sightings) {
      addSeen(picture, sighting, all);
    }
  }
}

void BoardAlignment::addSeen(const Picture& picture, const Sighting& sighting, const std::vector<Slope>& slopes) {
  const auto pose = seenPose(sighting, picture.drawn);
  if (!pose) {
    return;
  }
  const Eigen::Vector3d middle = middleOf(sighting.corners), middleInOptical = pose->opticalFromBoard * middle;
  Eigen::Matrix<double, 6, 6> middleFromOrigin = Eigen::Matrix<double, 6, 6>::Identity(); // omega x m + v
  middleFromOrigin.bottomLeftCorner<3, 3>() = -crossMatrix(middleInOptical);
  Eigen::Matrix<double, 6, 6> information = pose->information;
  information.diagonal().array() += 1e-6 * information.diagonal().maxCoeff();
  Eigen::Matrix<double, 6, 6> covariance = middleFromOrigin * information.inverse() * middleFromOrigin.transpose();
  covariance.diagonal().head<3>().array() += std::pow(angleScale, 2);
  covariance.diagonal().tail<3>().array() += std::pow(distanceScale * middleInOptical.z(), 2);
  seen_.push_back({&picture, &sighting, slopes, pose->opticalFromBoard, middle, covariance.inverse()});
}

bool BoardAlignment::knows(std::size_t target) const {
  return std::any_of(seen_.begin(), seen_.end(),
                     [&](const Seen& seen) { return seen.sighting->view.board() == target; });
}

void BoardAlignment::add(const Seen& seen, const Eigen::VectorXd& unknowns, Linear& sums) const {
  const View& view = seen.sighting->view;
  const Belief belief = believed(measurements_, model_, *seen.picture, unknowns);
  Posture torsoFromLink;
  posture(measurements_.robot, belief, view.links(), torsoFromLink);
  const Attitude attitude = view.attitude(measurements_.robot, belief, torsoFromLink);
  const RigidTransform& chain = attitude.opticalFromBoard;
  const Eigen::Vector3d middle = chain * seen.middle, middleSeen = seen.opticalFromBoard * seen.middle;
  Eigen::Matrix<double, 6, 1> residual;
  residual << rotationVector(chain.rotation * seen.opticalFromBoard.rotation.transpose()), middle - middleSeen;

  std::vector<std::size_t> quantities;
  for (const Slope& slope : seen.slopes) {
    quantities.push_back(slope.quantity);
  }
  std::vector<std::size_t> extras;
  for (std::size_t quantity : quantities) {
    const auto extra = view.extra(quantity);
    if (extra && std::find(extras.begin(), extras.end(), *extra) == extras.end()) {
      extras.push_back(*extra);
    }
  }
  Eigen::MatrixXd columns(at(6 + extras.size()), at(quantities.size()));
  view.motion(measurements_.robot, attitude, belief, torsoFromLink, quantities, extras, columns);
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(6, unknowns.size());
  for (std::size_t i = 0; i < seen.slopes.size(); ++i) {
    const Eigen::Vector3d omega = columns.col(at(i)).head<3>(), v = columns.col(at(i)).segment<3>(3);
    Eigen::Matrix<double, 6, 1> change;
    change << omega, omega.cross(middle) + v;
    jacobian.col(at(seen.slopes[i].unknown)) += seen.slopes[i].value * change;
  }
  const double size = std::sqrt(residual.dot(seen.weight * residual));
  const double weight = size <= huber ? 1 : huber / size;
  sums.cost += size <= huber ? 0.5 * size * size : huber * (size - 0.5 * huber);
  const Eigen::MatrixXd weighted = weight * jacobian.transpose() * seen.weight;
  sums.gradient += weighted * residual;
  sums.hessian += weighted * jacobian;
}

bool BoardAlignment::linearise(const Eigen::VectorXd& unknowns, Linear& sums) const {
  const Eigen::VectorXd information = sigmas_.cwiseAbs2().cwiseInverse();
  sums = {0.5 * unknowns.cwiseAbs2().dot(information), information.cwiseProduct(unknowns), information.asDiagonal()};
  for (const Seen& seen : seen_) {
    add(seen, unknowns, sums);
  }
  return true;
}

} // namespace naocal

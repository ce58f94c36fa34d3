#include "calibration/Initialization.hpp"

#include "camera/BoardPose.hpp"
#include "estimation/DriverState.hpp"
#include "estimation/EffectJacobian.hpp"
#include "estimation/NormalEquations.hpp"
#include "math/Angles.hpp"
#include "math/LevenbergMarquardt.hpp"
#include "math/LinearAlgebra.hpp"
#include "measurements/Measurements.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <vector>

namespace naocal {

namespace {

/// Board-pose alignment: a problem better conditioned far from the minimum than that of the corners. Compares each
/// board's pose in the camera, estimated from its corners alone, with that of the kinematic chain; valid even beyond
/// the horizon or behind the camera.
///
///   residual = (log(R_chain R_seen^T), c_chain - c_seen), c the middle of the corners,
///
/// weighted by the information of the corners, limited to 0.1 rad and a tenth of the depth, with a Huber loss.
/// A problem for `levenbergMarquardt`. Uses the first reading of each pose in each stance.
class BoardAlignment {
public:
  BoardAlignment(const Measurements& measurements, const Model& model);

  using Linear = DenseLinear;
  bool linearize(const Eigen::VectorXd& unknowns, Linear& sums) const;
  Eigen::VectorXd applyStep(const Eigen::VectorXd& unknowns, const Linear&, const Eigen::VectorXd& step) const {
    return unknowns + step;
  }
  const Eigen::VectorXd& scales() const { return sigmas_; }
  /// Number of observations whose board pose could be estimated.
  std::size_t size() const { return seen_.size(); }
  /// Whether one of them shows this target.
  bool includes(std::size_t target) const;

private:
  struct Seen {
    const ImageObservation* picture;
    const BoardObservation* observation;
    std::vector<StateDerivative> slopes;
    RigidTransform opticalFromBoard;
    Eigen::Vector3d middle;             // of the corners, in the board frame [m]
    Eigen::Matrix<double, 6, 6> weight; // inverse covariance of the residual
  };
  void addReading(const EncoderSample& reading);
  void addSeen(const ImageObservation& picture, const BoardObservation& observation,
               const std::vector<StateDerivative>& slopes);
  void add(const Seen& seen, const Eigen::VectorXd& unknowns, Linear& sums) const;

  const Measurements& measurements_;
  const Model& model_;
  Eigen::VectorXd sigmas_;
  std::vector<Seen> seen_;
};

constexpr double angleScale = 0.1; // [rad]

constexpr double distanceScale = 0.1; // relative to the depth

constexpr double huber = 2; // in units of the residual's standard deviation

constexpr double cornerNoise = 1; // [px]: generous, covers outliers and lens errors

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

/// A board's pose in the camera, refined on its corners by Gauss-Newton, and the information of its motion (omega, v).
/// Absent if no pose fits the corners.
struct SeenPose {
  RigidTransform opticalFromBoard;
  Eigen::Matrix<double, 6, 6> information;
};

std::optional<SeenPose> estimateSeenPose(const BoardObservation& observation, const ModelState& modelState) {
  const auto start = estimateBoardPose(observation.corners, modelState.lens());
  if (!start) {
    return std::nullopt;
  }
  CameraFrames attitude;
  attitude.opticalFromBoard = *start;
  ProjectedBlocks projected;
  ImageNormalEquations sums;
  for (int i = 0; i < 10; ++i) {
    if (!observation.view.project(attitude, modelState, observation.corners, projected)) {
      return std::nullopt;
    }
    sums.clear();
    sums.add(observation.corners, projected, {}, cornerNoise, {}, {});
    const Eigen::VectorXd step = -sums.gram().ldlt().solve(sums.gradient());
    const Eigen::Vector3d omega = step.head<3>(), v = step.tail<3>();
    attitude.opticalFromBoard = RigidTransform{rotationAbout(omega), v} * attitude.opticalFromBoard;
  }
  const bool fits = std::isfinite(sums.squares()) && sums.squares() < 25 * sums.corners() * cornerNoise * cornerNoise;
  return fits ? std::optional{SeenPose{attitude.opticalFromBoard, sums.gram() / (cornerNoise * cornerNoise)}}
              : std::nullopt;
}

BoardAlignment::BoardAlignment(const Measurements& measurements, const Model& model)
    : measurements_{measurements}, model_{model}, sigmas_{model.sigmas()} {
  for (const PoseGroup& pose : measurements.poses) {
    std::set<std::size_t> stances;
    for (const EncoderSample& reading : pose.readings) {
      if (stances.insert(measurements.pictures[reading.pictures.front()].stance).second) {
        addReading(reading);
      }
    }
  }
}

void BoardAlignment::addReading(const EncoderSample& reading) {
  for (std::size_t index : reading.pictures) {
    const ImageObservation& picture = measurements_.pictures[index];
    const std::vector<StateDerivative> all =
        evaluateJacobian(measurements_, model_, picture, Eigen::VectorXd::Zero(sigmas_.size()));
    for (const BoardObservation& observation : picture.observations) {
      addSeen(picture, observation, all);
    }
  }
}

void BoardAlignment::addSeen(const ImageObservation& picture, const BoardObservation& observation,
                             const std::vector<StateDerivative>& slopes) {
  const auto pose = estimateSeenPose(observation, picture.nominal);
  if (!pose) {
    return;
  }
  const Eigen::Vector3d middle = middleOf(observation.corners), middleInOptical = pose->opticalFromBoard * middle;
  Eigen::Matrix<double, 6, 6> middleFromOrigin = Eigen::Matrix<double, 6, 6>::Identity(); // omega x m + v
  middleFromOrigin.bottomLeftCorner<3, 3>() = -crossMatrix(middleInOptical);
  Eigen::Matrix<double, 6, 6> information = pose->information;
  information.diagonal().array() += 1e-6 * information.diagonal().maxCoeff();
  Eigen::Matrix<double, 6, 6> covariance = middleFromOrigin * information.inverse() * middleFromOrigin.transpose();
  covariance.diagonal().head<3>().array() += std::pow(angleScale, 2);
  covariance.diagonal().tail<3>().array() += std::pow(distanceScale * middleInOptical.z(), 2);
  seen_.push_back({&picture, &observation, slopes, pose->opticalFromBoard, middle, covariance.inverse()});
}

bool BoardAlignment::includes(std::size_t target) const {
  return std::any_of(seen_.begin(), seen_.end(),
                     [&](const Seen& seen) { return seen.observation->view.board() == target; });
}

void BoardAlignment::add(const Seen& seen, const Eigen::VectorXd& unknowns, Linear& sums) const {
  const ObservationChain& view = seen.observation->view;
  const ModelState modelState = predictState(measurements_, model_, *seen.picture, unknowns);
  LinkPoses torsoFromLink;
  forwardKinematics(measurements_.robot, modelState, view.links(), torsoFromLink);
  const CameraFrames attitude = view.cameraFrames({measurements_.robot, modelState, torsoFromLink});
  const RigidTransform& chain = attitude.opticalFromBoard;
  const Eigen::Vector3d middle = chain * seen.middle, middleSeen = seen.opticalFromBoard * seen.middle;
  Eigen::Matrix<double, 6, 1> residual;
  residual << rotationVector(chain.rotation * seen.opticalFromBoard.rotation.transpose()), middle - middleSeen;

  std::vector<std::size_t> quantities;
  for (const StateDerivative& slope : seen.slopes) {
    quantities.push_back(slope.quantity);
  }
  std::vector<std::size_t> extras;
  for (std::size_t quantity : quantities) {
    const auto extra = view.extraIndex(quantity);
    if (extra && std::find(extras.begin(), extras.end(), *extra) == extras.end()) {
      extras.push_back(*extra);
    }
  }
  Eigen::MatrixXd columns(eigenIndex(6 + extras.size()), eigenIndex(quantities.size()));
  view.fillMotionColumns({measurements_.robot, modelState, torsoFromLink}, attitude, quantities, extras, columns);
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(6, unknowns.size());
  for (std::size_t i = 0; i < seen.slopes.size(); ++i) {
    const Eigen::Vector3d omega = columns.col(eigenIndex(i)).head<3>(), v = columns.col(eigenIndex(i)).segment<3>(3);
    Eigen::Matrix<double, 6, 1> change;
    change << omega, omega.cross(middle) + v;
    jacobian.col(eigenIndex(seen.slopes[i].unknown)) += seen.slopes[i].value * change;
  }
  const double size = std::sqrt(residual.dot(seen.weight * residual));
  const double weight = size <= huber ? 1 : huber / size;
  sums.cost += size <= huber ? 0.5 * size * size : huber * (size - 0.5 * huber);
  const Eigen::MatrixXd weighted = weight * jacobian.transpose() * seen.weight;
  sums.gradient += weighted * residual;
  sums.hessian += weighted * jacobian;
}

bool BoardAlignment::linearize(const Eigen::VectorXd& unknowns, Linear& sums) const {
  const Eigen::VectorXd information = sigmas_.cwiseAbs2().cwiseInverse();
  sums = {0.5 * unknowns.cwiseAbs2().dot(information), information.cwiseProduct(unknowns), information.asDiagonal()};
  for (const Seen& seen : seen_) {
    add(seen, unknowns, sums);
  }
  return true;
}

/// A pose on the floor: x, y [m], yaw [rad] in the parent frame.
using OnFloor = Eigen::Vector3d;

OnFloor compose(const OnFloor& a, const OnFloor& b) {
  const double c = std::cos(a.z()), s = std::sin(a.z());
  return {a.x() + c * b.x() - s * b.y(), a.y() + s * b.x() + c * b.y(), wrapAngle(a.z() + b.z())};
}

OnFloor invert(const OnFloor& a) {
  const double c = std::cos(a.z()), s = std::sin(a.z());
  return {-c * a.x() - s * a.y(), s * a.x() - c * a.y(), -a.z()};
}

/// Medoid: the member with the smallest total distance to all others, robust against a few outliers.
OnFloor medoid(const std::vector<OnFloor>& all) {
  const auto distance = [](const OnFloor& a, const OnFloor& b) {
    return (a - b).head<2>().norm() + 0.5 * std::abs(wrapAngle(a.z() - b.z()));
  };
  double least = std::numeric_limits<double>::infinity();
  OnFloor best = all.front();
  for (const OnFloor& candidate : all) {
    const double sum = std::accumulate(all.begin(), all.end(), 0.0,
                                       [&](double s, const OnFloor& other) { return s + distance(candidate, other); });
    if (sum < least) {
      least = sum;
      best = candidate;
    }
  }
  return best;
}

/// Where a corner's ray meets the floor, at most 2 m from the camera: x, y in the sole's frame.
Eigen::Vector2d meetFloor(const RigidTransform& soleFromOptical, const Eigen::Matrix<double, 9, 1>& lens,
                          const Eigen::Vector2d& pixel) {
  constexpr double farthest = 2; // [m]
  const Eigen::Vector3d ray =
      soleFromOptical.rotation * Eigen::Vector3d{(pixel.x() - lens[2]) / lens[0], (pixel.y() - lens[3]) / lens[1], 1};
  const double down = -ray.z() / soleFromOptical.translation.z(); // 1 / (distance along the ray to the floor)
  const double reach = std::min(1 / std::max(down, 1e-9), farthest / ray.head<2>().norm());
  return (soleFromOptical.translation + reach * ray).head<2>();
}

/// The placement that brings points of a board closest to where they were seen on the floor (Umeyama, 2-D).
OnFloor placeOnFloor(const std::vector<Eigen::Vector2d>& onBoard, const std::vector<Eigen::Vector2d>& onFloor) {
  const auto columns = [](const std::vector<Eigen::Vector2d>& points) {
    return Eigen::Matrix2Xd::Map(points.front().data(), 2, eigenIndex(points.size()));
  };
  const Eigen::Matrix3d motion = Eigen::umeyama(columns(onBoard), columns(onFloor), false);
  return {motion(0, 2), motion(1, 2), std::atan2(motion(1, 0), motion(0, 0))};
}

/// A board's placement in the support sole's frame: from its pose in the camera, or, where its corners do not determine
/// one, from where their rays meet the floor.
OnFloor soleFromBoard(const Measurements& measurements, const ModelState& modelState,
                      const BoardObservation& observation) {
  LinkPoses torsoFromLink;
  forwardKinematics(measurements.robot, modelState, observation.view.links(), torsoFromLink);
  const CameraFrames attitude = observation.view.cameraFrames({measurements.robot, modelState, torsoFromLink});
  const RigidTransform soleFromOptical = attitude.opticalFromTarget.inverse();
  if (const auto opticalFromBoard = estimateBoardPose(observation.corners, modelState.lens())) {
    const RigidTransform pose = soleFromOptical * *opticalFromBoard;
    return {pose.translation.x(), pose.translation.y(), std::atan2(pose.rotation(1, 0), pose.rotation(0, 0))};
  }
  std::vector<Eigen::Vector2d> onBoard, onFloor;
  for (const CornerBlock& block : observation.corners) {
    for (Eigen::Index i = 0; i < 4; ++i) {
      if (block.present[i] > 0) {
        onBoard.emplace_back(block.x[i], block.y[i]);
        onFloor.push_back(meetFloor(soleFromOptical, modelState.lens(), {block.u[i], block.v[i]}));
      }
    }
  }
  return placeOnFloor(onBoard, onFloor);
}

using Placements = std::vector<std::optional<OnFloor>>;
using StanceAndBoard = std::pair<std::size_t, std::size_t>; // indices

/// Whether any corner counts: an observation that was set aside keeps its corners at no weight.
bool isSeen(const BoardObservation& observation) {
  return std::any_of(observation.corners.begin(), observation.corners.end(),
                     [](const CornerBlock& block) { return sum(block.present) > 0; });
}

/// Placement of each floor board in the frame of each sole that it was seen from. Views without an estimate of the
/// board's pose count only for pairs that have no other.
std::map<StanceAndBoard, OnFloor> locateBoards(const Measurements& measurements, const Model& model,
                                               const Eigen::VectorXd& unknowns) {
  std::map<StanceAndBoard, std::vector<OnFloor>> observations, glimpses;
  for (const ImageObservation& picture : measurements.pictures) {
    const ModelState modelState = predictState(measurements, model, picture, unknowns);
    for (const BoardObservation& observation : picture.observations) {
      const std::size_t board = observation.view.board();
      if (measurements.targets[board].isFlat && isSeen(observation)) {
        auto& views = estimateBoardPose(observation.corners, modelState.lens()) ? observations : glimpses;
        views[{picture.stance, board}].push_back(soleFromBoard(measurements, modelState, observation));
      }
    }
  }
  observations.merge(glimpses); // keeps the observations of a pair
  std::map<StanceAndBoard, OnFloor> seen;
  for (const auto& [key, placements] : observations) {
    seen[key] = medoid(placements);
  }
  return seen;
}

Placements knownStances(const Measurements& measurements) {
  Placements stances(measurements.stances.size());
  for (const ImageObservation& picture : measurements.pictures) {
    if (!measurements.stances[picture.stance].unknown) {
      const auto ground = picture.nominal.worldFromSupport();
      stances[picture.stance] = OnFloor{ground[0], ground[1], ground[5]};
    }
  }
  return stances;
}

/// Placements of the floor boards that were surveyed or have a guess.
Placements knownBoards(const Measurements& measurements) {
  Placements boards(measurements.targets.size());
  for (std::size_t board = 0; !measurements.pictures.empty() && board < boards.size(); ++board) {
    const Target& target = measurements.targets[board];
    if (target.isFlat && (!target.unknown || target.board.hasGuess)) {
      const auto placement = measurements.pictures.back().nominal.boardPlacement(board);
      boards[board] = OnFloor{placement[0], placement[1], placement[5]};
    }
  }
  return boards;
}

/// Propagates placements along the observations until all are reached. A connected component without a known placement
/// is anchored at its first stance.
void spread(const std::map<StanceAndBoard, OnFloor>& seen, Placements& boards, Placements& stances) {
  for (bool all = false; !all;) {
    bool moved = false;
    for (const auto& [key, soleFromThatBoard] : seen) {
      auto& board = boards[key.second];
      auto& stance = stances[key.first];
      if (stance && !board) {
        board = compose(*stance, soleFromThatBoard);
        moved = true;
      } else if (board && !stance) {
        stance = compose(*board, invert(soleFromThatBoard));
        moved = true;
      }
    }
    const auto lost =
        std::find_if(seen.begin(), seen.end(), [&](const auto& entry) { return !stances[entry.first.first]; });
    all = !moved && lost == seen.end();
    if (!moved && lost != seen.end()) {
      stances[lost->first.first] = OnFloor::Zero();
    }
  }
}

} // namespace

Eigen::VectorXd initializePlacements(const Measurements& measurements, const Model& model,
                                     const Eigen::VectorXd& unknowns) {
  Placements boards = knownBoards(measurements), stances = knownStances(measurements);
  spread(locateBoards(measurements, model, unknowns), boards, stances);
  Eigen::VectorXd result = unknowns;
  for (const Term& term : model.terms()) {
    if (!term.isPlacement) {
      continue;
    }
    const bool isBoard = term.effect.placeKind == PlaceKind::board;
    const bool isOnFloor =
        isBoard ? measurements.targets[term.placeIndex].isFlat && !measurements.targets[term.placeIndex].board.hasGuess
                : term.effect.placeKind == PlaceKind::stance && measurements.stances[term.placeIndex].isFlat;
    if (term.effect.placeKind == PlaceKind::marker) {
      const MarkerInstance& marker = measurements.instruments.markers[term.placeIndex];
      result.segment<3>(static_cast<Eigen::Index>(term.first)) = marker.start - marker.marker.pointGuess;
    } else if (term.effect.placeKind == PlaceKind::place) {
      result.segment<3>(static_cast<Eigen::Index>(term.first)) = measurements.instruments.places[term.placeIndex].start;
    }
    if (!isOnFloor) {
      continue; // starts from its guess
    }
    const auto& placement = isBoard ? boards[term.placeIndex] : stances[term.placeIndex];
    if (!placement) {
      continue;
    }
    result.segment<3>(static_cast<Eigen::Index>(term.first)) = *placement; // start is zero
  }
  return result;
}

Eigen::VectorXd alignBoards(const Measurements& measurements, const Model& model, const Eigen::VectorXd& unknowns) {
  const Eigen::VectorXd start = initializePlacements(measurements, model, unknowns);
  const BoardAlignment alignment{measurements, model};
  if (alignment.size() == 0) {
    return start;
  }
  Eigen::VectorXd aligned =
      levenbergMarquardt(alignment, start, {.maxIterations = 30, .minCostDecrease = 1e-3}).value().state;
  const Eigen::VectorXd placedAnew = initializePlacements(measurements, model, aligned);
  for (const Term& term : model.terms()) {
    if (term.isPlacement && term.effect.placeKind == PlaceKind::board && !alignment.includes(term.placeIndex)) {
      const auto first = static_cast<Eigen::Index>(term.first),
                 count = static_cast<Eigen::Index>(term.effect.unknowns.size());
      aligned.segment(first, count) = placedAnew.segment(first, count);
    }
  }
  return aligned;
}

} // namespace naocal

#include "calibration/Outliers.hpp"

#include "calibration/Fit.hpp"
#include "inference/Thresholds.hpp"
#include "math/Statistics.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace naocal {

std::vector<Outlier> findOutliers(const Measurements& measurements, const CalibrationResult& result) {
  std::vector<Outlier> all;
  for (const BoardResidual& seen : result.residuals) {
    const BoardObservation& observation = measurements.pictures[seen.picture].observations[seen.observation];
    Outlier outlier{seen.picture, seen.observation, {}, false, 0};
    double squares = 0;
    for (Eigen::Index i = 0; i < seen.weight.size(); ++i) {
      if (seen.weight[i] < outlierWeight) {
        outlier.corners.push_back(observation.ids[static_cast<std::size_t>(i)]);
        squares += seen.residual.col(i).squaredNorm();
      }
    }
    if (!outlier.corners.empty()) {
      outlier.distance = std::sqrt(squares / static_cast<double>(outlier.corners.size()));
      outlier.whole = isMostlyOutliers(seen);
      all.push_back(std::move(outlier));
    }
  }
  return all;
}

std::vector<DoubtfulReading> findDoubtfulReadings(const std::vector<WitnessResidual>& residuals) {
  std::vector<DoubtfulReading> all;
  for (const WitnessResidual& one : residuals) {
    if (one.weight < outlierWeight) {
      all.push_back({one.picture, one.witness});
    }
  }
  return all;
}

std::optional<Measurements> weighDoubtful(const Measurements& measurements, const Model& model, const Fit& fit) {
  const Residuals residuals{measurements, model, fit.noise, fit.loss};
  const std::vector<BoardResidual> boards = residuals.boardResiduals(fit.minimum.state);
  const std::vector<WitnessResidual> readings = residuals.witnessResiduals(fit.minimum.state);
  if (std::all_of(boards.begin(), boards.end(),
                  [](const BoardResidual& board) { return (board.weight.array() >= 1).all(); }) &&
      std::all_of(readings.begin(), readings.end(), [](const WitnessResidual& one) { return one.weight >= 1; })) {
    return std::nullopt;
  }
  Measurements weighed = measurements;
  for (const BoardResidual& board : boards) {
    CornerBlocks& blocks = weighed.pictures[board.picture].observations[board.observation].corners;
    for (Eigen::Index i = 0; i < board.weight.size(); ++i) {
      blocks[static_cast<std::size_t>(i / 4)].present[i % 4] = board.weight[i];
    }
  }
  for (const WitnessResidual& one : readings) {
    weighed.pictures[one.picture].witnesses[one.witness].weight = one.weight;
  }
  return weighed;
}

double shareOfDoubtful(const Measurements& measurements, const Model& model, const Fit& fit) {
  const Residuals residuals{measurements, model, fit.noise, fit.loss};
  double corners = 0;
  for (const BoardResidual& board : residuals.boardResiduals(fit.minimum.state)) {
    corners += static_cast<double>((board.weight.array() < outlierWeight).count());
  }
  const auto readings = static_cast<double>(findDoubtfulReadings(residuals.witnessResiduals(fit.minimum.state)).size());
  return std::max(corners / std::max<double>(1, static_cast<double>(measurements.cornerCount)),
                  readings / std::max<double>(1, static_cast<double>(measurements.witnessCount)));
}

std::size_t countViews(const Measurements& measurements) {
  return std::accumulate(measurements.pictures.begin(), measurements.pictures.end(), std::size_t{0},
                         [](std::size_t sum, const ImageObservation& one) { return sum + one.observations.size(); });
}

void excludeReadings(Measurements& measurements, std::size_t picture) {
  measurements.witnessCount -= std::erase_if(measurements.pictures[picture].witnesses,
                                             [](const WitnessObservation& one) { return one.view.has_value(); });
}

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// The statistic of one observation's motion and its distance. `hessian`: of the fit, decomposed.
BoardDisplacement testMotion(const BoardMotionSums& motion, const Fit& fit,
                             const Eigen::LLT<Eigen::MatrixXd>& hessian) {
  const PoseSystem& pose = fit.minimum.linear.poses[motion.pose];
  const MarginalSystem& part = fit.minimum.linear.eliminated[motion.pose];
  const JointErrorRoot root = jointErrorRoot(pose, fit.noise);
  const Eigen::VectorXd deflections = root * fit.minimum.state.deflections[motion.pose]; // [rad]
  const auto unknowns = static_cast<Eigen::Index>(pose.unknowns.size()), joints = deflections.size();
  const double information = 1 / (fit.noise.pixel * fit.noise.pixel);
  const Eigen::MatrixXd byDeflections = motion.cross.rightCols(joints);
  Vector6 score = information * (motion.gradient - byDeflections * deflections);
  Matrix6 kept = information * motion.gram;
  Eigen::MatrixXd byUnknowns = information * motion.cross.leftCols(unknowns);
  if (joints > 0) {
    Eigen::MatrixXd half = information * (root.transpose() * byDeflections.transpose());
    part.inner.matrixL().solveInPlace(half);
    score -= half.transpose() * part.half.rightCols<1>();
    kept -= half.transpose() * half;
    byUnknowns -= half.transpose() * part.half.leftCols(unknowns);
  }
  Eigen::MatrixXd scattered = Eigen::MatrixXd::Zero(hessian.rows(), 6);
  for (Eigen::Index i = 0; i < unknowns; ++i) {
    scattered.row(static_cast<Eigen::Index>(pose.unknowns[static_cast<std::size_t>(i)])) =
        byUnknowns.col(i).transpose();
  }
  hessian.matrixL().solveInPlace(scattered);
  kept -= scattered.transpose() * scattered;
  constexpr double absorbed = 1e-6; // share of its information that a motion keeps when the fit absorbs it; regularises
  kept.diagonal() += absorbed * information * motion.gram.diagonal();
  const Vector6 best = kept.ldlt().solve(score);
  BoardDisplacement move{motion.picture, motion.observation};
  move.chi2 = score.dot(best);
  move.distance = std::sqrt(best.dot(motion.gram * best));
  return move;
}

} // namespace

std::vector<BoardDisplacement> testDisplacements(const Measurements& measurements, const Model& model, const Fit& fit) {
  const Residuals residuals{measurements, model, fit.noise, fit.loss};
  const Eigen::LLT<Eigen::MatrixXd> hessian{fit.minimum.linear.hessian};
  std::vector<BoardDisplacement> result;
  const auto motions = residuals.boardMotions(fit.minimum.state);
  for (const BoardMotionSums& motion : motions.value()) {
    result.push_back(testMotion(motion, fit, hessian));
    result.back().distance /= std::sqrt(
        static_cast<double>(measurements.pictures[motion.picture].observations[motion.observation].ids.size()));
  }
  return result;
}

std::optional<BoardDisplacement> findDisplacedBoard(const Measurements& measurements, const Model& model,
                                                    const Fit& fit, double misfit) {
  std::vector<BoardDisplacement> all = testDisplacements(measurements, model, fit);
  const auto count = static_cast<double>(all.size());
  std::erase_if(all, [](const BoardDisplacement& move) { return move.distance < threshold::negligiblePx; });
  const auto most = std::max_element(
      all.begin(), all.end(), [](const BoardDisplacement& a, const BoardDisplacement& b) { return a.chi2 < b.chi2; });
  if (most == all.end()) {
    return std::nullopt;
  }
  const double p = chiSquaredTail(std::max(0.0, most->chi2 / misfit), 6);
  return p * count < threshold::movedBoardAlarm ? std::optional{*most} : std::nullopt;
}

void excludeObservation(Measurements& measurements, const BoardDisplacement& move) {
  for (CornerBlock& block : measurements.pictures[move.picture].observations[move.observation].corners) {
    block.present = Double4{};
  }
}

} // namespace naocal

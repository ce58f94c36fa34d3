#include "diagnose/LackOfFit.hpp"

#include "calibrate/Tails.hpp"
#include "diagnose/ModelAlone.hpp"
#include "geometry/SymmetricEigen.hpp"

#include <cmath>

namespace naocal {

namespace {

constexpr double everything = 0.05; // [rad]: a pose noise that lets every joint go where it likes

/// How many directions of one pose's deflections the pictures tell: sum of l s^2 / (1 + l s^2) over the eigenvalues l
/// of their information.
double toldDirections(const PoseSystem& pose, const Noise& noise) {
  Eigen::Index motors = 0;
  Eigen::MatrixXd pooled = Eigen::MatrixXd::Zero(pose.deflectionGram.rows(), pose.deflectionGram.rows());
  for (std::size_t i = 0; i < pose.joints.size(); ++i) {
    motors += i == 0 || pose.joints[i] != pose.joints[i - 1];
    pooled(static_cast<Eigen::Index>(i), motors - 1) = 1;
  }
  PoseSystem only = pose; // the pooled deflections, seen as unknowns
  const auto columns = pooled.leftCols(motors);
  only.unknownGram = columns.transpose() * pose.deflectionGram * columns;
  only.cross = columns.transpose() * pose.deflectionGram;
  only.unknownGradient = Eigen::VectorXd::Zero(motors);
  const Eigen::MatrixXd information = eliminated(only, noise, deflectionRoot(pose, noise)).hessian;
  const Eigen::ArrayXd inUnits = symmetricEigenvalues(information).array().max(0) * everything * everything;
  return (inUnits / (1 + inUnits)).sum();
}

} // namespace

LackOfFit lackOfFit(const Inquiry& inquiry) {
  const ScoreProblem& problem = inquiry.problem();
  const std::vector<PoseSystem>& poses = inquiry.linear().poses;
  const Noise noise = inquiry.noise();
  Noise readings = noise, free = noise;
  readings.pose = 0;
  constexpr double alarm = 0.05; // then what looks like scatter may be the missing effect, and is no noise
  const Noise& floor = inquiry.evidence().pValue <= alarm ? readings : noise;
  free.pose = everything;
  const PoseScores scores = measuredScores(inquiry.linear(), noise);
  const double own = problem.unknowns.cwiseQuotient(problem.sigmas).squaredNorm();
  const auto chi2 = [&](const Noise& level) {
    return ModelAlone{problem, level}(scores, problem.priorScore()).chi2[0] + own;
  };
  LackOfFit result;
  double squares = 0, numbers = 0, directions = 0, expected = 0;
  for (const PoseSystem& pose : poses) {
    squares += pose.squares;
    numbers += pose.numbers;
    directions += toldDirections(pose, readings);
    const DeflectionRoot root = deflectionRoot(pose, floor);
    expected += noise.pixel * noise.pixel * pose.numbers +
                Eigen::MatrixXd{root.transpose() * Eigen::MatrixXd{pose.deflectionGram * root}}.trace();
  }
  const double constant = squares / (noise.pixel * noise.pixel);
  const double all = chi2(readings) + constant, within = chi2(free) + constant;
  const auto learned = static_cast<double>(problem.own());
  result.dof[0] = std::max(1.0, directions - learned);
  result.dof[1] = std::max(0.0, numbers - learned - result.dof[0]);
  const double between = std::max(0.0, all - within) / result.dof[0];
  constexpr double few = 20; // single marks instead of boards: nothing within pictures tells the noise
  if (result.dof[1] < few) {
    result.dof[1] = 0;
    result.statistic = between;
    result.pValue = chiSquaredTail(between * result.dof[0], result.dof[0]);
  } else {
    result.statistic = between / (within / result.dof[1]);
    result.pValue = fisherTail(result.statistic, result.dof[0], result.dof[1]);
  }
  result.noiseFloorPx = std::sqrt(2 * expected / numbers);
  return result;
}

} // namespace naocal

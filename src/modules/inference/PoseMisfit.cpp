#include "inference/PoseMisfit.hpp"

#include "inference/ScoreTest.hpp"

#include <algorithm>

namespace naocal {

namespace {

constexpr double everything = 0.05; // [rad]: pose noise that leaves every joint practically unconstrained

Eigen::MatrixXd deflectionCovariance(const PosePart& pose, const Noise& noise) {
  const JointErrorRoot root = jointErrorRoot(pose, noise);
  return Eigen::MatrixXd{root * JointErrorRoot{root.transpose()}};
}

/// chi2 of the model without candidates at its minimum, including the priors of its unknowns.
double computeChi2(const NullModel& alone) {
  const ScoreProblem& problem = alone.problem();
  double squares = 0;
  for (const PoseRows& pose : *problem.poses) {
    squares += pose.squares;
  }
  return alone(measuredResiduals(*problem.poses), problem.priorScore()).chi2[0] +
         problem.unknowns.cwiseQuotient(problem.sigmas).squaredNorm() +
         squares / (alone.noise().pixel * alone.noise().pixel);
}

} // namespace

PoseMisfit testPoseMisfit(const ScoreProblem& problem, const Noise& noise) {
  Noise loose = noise;
  loose.pose = everything;
  const NullModel held{problem, noise}, free{problem, loose};
  PoseMisfit result;
  result.within = computeChi2(free);
  result.chi2 = std::max(0.0, computeChi2(held) - result.within);
  Eigen::MatrixXd learned = Eigen::MatrixXd::Zero(problem.ownCount(), problem.ownCount());
  const double information = 1 / (noise.pixel * noise.pixel);
  for (std::size_t number = 0; number < problem.poses->size(); ++number) {
    const PoseRows& pose = (*problem.poses)[number];
    const NullModel::Whitener& whitener = free.whitener(number);
    const Eigen::MatrixXd more = deflectionCovariance(pose, loose) - deflectionCovariance(pose, noise);
    const Eigen::MatrixXd bent = whitener.half * pose.byDeflections / noise.pixel;
    result.directions += (information * (pose.byDeflections.transpose() * pose.byDeflections) - bent.transpose() * bent)
                             .cwiseProduct(more)
                             .sum();
    const Eigen::Index own = problem.ownCountIn(pose);
    const std::vector<std::size_t> unknowns = problem.ownUnknownsIn(pose);
    const Eigen::MatrixXd cross = information * (pose.byUnknowns.leftCols(own).transpose() * pose.byDeflections) -
                                  whitener.unknowns.leftCols(own).transpose() * bent;
    learned(unknowns, unknowns) += cross * more * cross.transpose();
  }
  result.freedom = std::max(1.0, result.directions - free.factor().solve(learned).trace());
  return result;
}

} // namespace naocal

#include "evidence/ModelAlone.hpp"

namespace naocal {

ModelAlone::ModelAlone(const ScoreProblem& problem, const Noise& noise) : problem_{problem}, noise_{noise} {
  const double information = 1 / (noise.pixel * noise.pixel);
  Eigen::MatrixXd hessian = problem.sigmas.cwiseAbs2().cwiseInverse().asDiagonal();
  for (const PoseSystem& system : problem.linear->poses) {
    const DeflectionRoot root = deflectionRoot(system, noise);
    Eigen::MatrixXd inner = information * (root.transpose() * Eigen::MatrixXd{system.deflectionGram * root});
    inner.diagonal().array() += 1;
    const Eigen::LLT<Eigen::MatrixXd> factor{inner};
    logDeterminant_ += 2 * factor.matrixLLT().diagonal().array().log().sum();
    Whitener& whitener = whiteners_.emplace_back();
    whitener.half = factor.matrixL().solve(Eigen::MatrixXd{root.transpose()});
    whitener.unknowns = information * (root.transpose() * Eigen::MatrixXd{system.cross.transpose()});
    factor.matrixL().solveInPlace(whitener.unknowns);
    const Eigen::Index own = problem.ownOf(system);
    const std::vector<std::size_t> unknowns = problem.ownUnknownsOf(system);
    const auto answers = whitener.unknowns.leftCols(own);
    hessian(unknowns, unknowns) +=
        information * system.unknownGram.topLeftCorner(own, own) - answers.transpose() * answers;
  }
  factor_.compute(hessian);
}

ModelAlone::Outcome ModelAlone::operator()(const PoseScores& scores, const Eigen::VectorXd& priorScore) const {
  const Eigen::Index draws = scores.front().unknowns.cols();
  Outcome result;
  result.own = priorScore.replicate(1, draws);
  result.chi2.setZero(draws);
  for (std::size_t pose = 0; pose < scores.size(); ++pose) {
    const PoseSystem& system = problem_.linear->poses[pose];
    const Eigen::Index own = problem_.ownOf(system);
    const Eigen::MatrixXd bent = whiteners_[pose].half * scores[pose].deflections;
    result.chi2 -= bent.colwise().squaredNorm();
    result.own(problem_.ownUnknownsOf(system), Eigen::all) +=
        scores[pose].unknowns.topRows(own) - whiteners_[pose].unknowns.leftCols(own).transpose() * bent;
  }
  factor_.matrixL().solveInPlace(result.own);
  result.chi2 -= result.own.colwise().squaredNorm();
  result.deviance = result.chi2.array() + logDeterminant_ + 2 * factor_.matrixLLT().diagonal().array().log().sum();
  return result;
}

} // namespace naocal

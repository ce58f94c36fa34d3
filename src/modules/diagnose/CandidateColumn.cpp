#include "diagnose/CandidateColumn.hpp"

#include "math/LinearAlgebra.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

namespace naocal {

namespace {

/// The candidate's unknowns stand `first` and move together along `direction`.
CandidateColumn::Pose summed(const PoseRows& pose, const Noise& noise, Eigen::Index own, Eigen::Index first,
                             const Eigen::VectorXd& direction) {
  CandidateColumn::Pose result;
  std::vector<Eigen::Index> rows, moving; // of the sums; of `direction`
  for (std::size_t i = 0; i < pose.unknowns.size(); ++i) {
    const Eigen::Index unknown = at(pose.unknowns[i]);
    if (unknown < own) {
      result.columns.push_back(unknown);
      rows.push_back(at(i));
    } else if (unknown >= first && unknown < first + direction.size()) {
      moving.push_back(unknown - first);
      rows.push_back(at(i));
    }
  }
  const Eigen::Index kept = at(result.columns.size());
  result.columns.push_back(own);
  Eigen::MatrixXd together = Eigen::MatrixXd::Zero(at(rows.size()), kept + 1);
  together.topLeftCorner(kept, kept).setIdentity();
  together.col(kept).tail(at(moving.size())) = direction(moving);
  const PoseRows part{pose, pose.byUnknowns(Eigen::all, rows) * together, pose.byDeflections, pose.residual};
  Eliminated whitened = eliminated(systemOf(part), noise, deflectionRoot(pose, noise));
  result.information = std::move(whitened.hessian);
  result.gradient = std::move(whitened.unknownGradient);
  return result;
}

} // namespace

std::string labelOf(const Model& model, Eigen::Index unknown) {
  const auto& terms = model.terms();
  const auto term = std::find_if(terms.begin(), terms.end(),
                                 [&](const Term& one) { return unknown < at(one.first + one.effect.unknowns.size()); });
  return term->label();
}

CandidateColumn::CandidateColumn(const Inquiry& inquiry, std::size_t candidate, const Eigen::VectorXd& direction,
                                 const Noise& noise) {
  const ScoreProblem& problem = inquiry.problem();
  const Eigen::Index own = problem.own();
  prior = problem.sigmas.cwiseAbs2().cwiseInverse();
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(own + 1, own + 1);
  information.topLeftCorner(own, own) = prior.asDiagonal();
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(own + 1);
  gradient.head(own) = prior.cwiseProduct(problem.unknowns);
  for (const PoseRows& pose : inquiry.poses()) {
    const Pose& sums = poses.emplace_back(summed(pose, noise, own, own + problem.groups[candidate].first, direction));
    information(sums.columns, sums.columns) += sums.information;
    gradient(sums.columns) += sums.gradient;
  }
  const Eigen::LLT<Eigen::MatrixXd> factor{information.topLeftCorner(own, own)};
  const Eigen::VectorXd shared = information.col(own).head(own);
  imitation = factor.solve(shared);
  fitted = -factor.solve(gradient.head(own));
  shared.cwiseAbs2().cwiseQuotient(information.diagonal().head(own)).maxCoeff(&like);
}

} // namespace naocal

#include "diagnosis/views/AddedVariable.hpp"

#include "math/LinearAlgebra.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace naocal {

std::optional<AddedVariable> computeAddedVariable(const CandidateTests& candidateTests, const Model& model,
                                                  std::size_t candidate) {
  const ScoreProblem& problem = candidateTests.problem();
  const GroupEvidence& evidence = candidateTests.candidateEvidence(candidate);
  if (evidence.freedom < 1) {
    return std::nullopt;
  }
  const Eigen::VectorXd direction = evidence.estimate.size() == 1 ? Eigen::VectorXd::Ones(1) : evidence.estimate;
  const CandidateColumn column{candidateTests, candidate, direction, candidateTests.noise()};
  const Eigen::Index own = problem.ownCount();
  Eigen::VectorXd left(own + 1), fitted(own + 1); // e = J left, M r = r + J fitted
  left << -column.imitation, 1;
  fitted << column.fitted, 0;

  AddedVariable result;
  result.like = termLabel(model, column.like);
  double squares = 0, products = 0;
  const auto add = [&](std::optional<std::size_t> pose, double square, double product, double sense) {
    const double signature = std::copysign(std::sqrt(std::max(0.0, square)), sense);
    result.points.push_back({pose, signature, signature == 0 ? 0 : product / signature});
    squares += square;
    products += product;
  };
  for (std::size_t i = 0; i < column.poses.size(); ++i) {
    const CandidateColumn::Pose& pose = column.poses[i];
    const Eigen::VectorXd e = left(pose.columns), moved = pose.information * e;
    const auto place = std::find(pose.columns.begin(), pose.columns.end(), column.like);
    add(i, e.dot(moved), -moved.dot(fitted(pose.columns)) - e.dot(pose.gradient),
        place == pose.columns.end() ? 1 : moved[place - pose.columns.begin()]);
  }
  const Eigen::VectorXd believed = left.head(own), weighted = column.prior.cwiseProduct(believed);
  add(std::nullopt, believed.dot(weighted), -weighted.dot(problem.unknowns + column.fitted),
      own > 0 ? weighted[column.like] : 1);
  if (!(squares > 0)) {
    return std::nullopt;
  }
  result.slope = products / squares;
  result.sigma = 1 / std::sqrt(squares);
  return result;
}

namespace {

/// The candidate's unknowns start at `first` and move jointly along `direction`.
CandidateColumn::Pose sumColumn(const PoseRows& pose, const Noise& noise, Eigen::Index own, Eigen::Index first,
                                const Eigen::VectorXd& direction) {
  CandidateColumn::Pose result;
  std::vector<Eigen::Index> rows, moving; // of the sums; of `direction`
  for (std::size_t i = 0; i < pose.unknowns.size(); ++i) {
    const Eigen::Index unknown = eigenIndex(pose.unknowns[i]);
    if (unknown < own) {
      result.columns.push_back(unknown);
      rows.push_back(eigenIndex(i));
    } else if (unknown >= first && unknown < first + direction.size()) {
      moving.push_back(unknown - first);
      rows.push_back(eigenIndex(i));
    }
  }
  const Eigen::Index kept = eigenIndex(result.columns.size());
  result.columns.push_back(own);
  Eigen::MatrixXd together = Eigen::MatrixXd::Zero(eigenIndex(rows.size()), kept + 1);
  together.topLeftCorner(kept, kept).setIdentity();
  together.col(kept).tail(eigenIndex(moving.size())) = direction(moving);
  const PoseRows part{pose, pose.byUnknowns(Eigen::all, rows) * together, pose.byDeflections, pose.residual};
  MarginalSystem whitened = marginalize(systemOf(part), noise, jointErrorRoot(pose, noise));
  result.information = std::move(whitened.hessian);
  result.gradient = std::move(whitened.unknownGradient);
  return result;
}

} // namespace

std::string termLabel(const Model& model, Eigen::Index unknown) {
  const auto& terms = model.terms();
  const auto term = std::find_if(terms.begin(), terms.end(), [&](const Term& one) {
    return unknown < eigenIndex(one.first + one.effect.unknowns.size());
  });
  return term == terms.end() ? "" : term->label();
}

CandidateColumn::CandidateColumn(const CandidateTests& candidateTests, std::size_t candidate,
                                 const Eigen::VectorXd& direction, const Noise& noise) {
  const ScoreProblem& problem = candidateTests.problem();
  const Eigen::Index own = problem.ownCount();
  prior = problem.sigmas.cwiseAbs2().cwiseInverse();
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(own + 1, own + 1);
  information.topLeftCorner(own, own) = prior.asDiagonal();
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(own + 1);
  gradient.head(own) = prior.cwiseProduct(problem.unknowns);
  for (const PoseRows& pose : candidateTests.poses()) {
    const Pose& sums =
        poses.emplace_back(sumColumn(pose, noise, own, own + problem.groups[candidate].first, direction));
    information(sums.columns, sums.columns) += sums.information;
    gradient(sums.columns) += sums.gradient;
  }
  const Eigen::LLT<Eigen::MatrixXd> factor{information.topLeftCorner(own, own)};
  const Eigen::VectorXd shared = information.col(own).head(own);
  imitation = factor.solve(shared);
  fitted = -factor.solve(gradient.head(own));
  if (own > 0) {
    shared.cwiseAbs2().cwiseQuotient(information.diagonal().head(own)).maxCoeff(&like);
  }
}

} // namespace naocal

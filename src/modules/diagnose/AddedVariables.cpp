#include "diagnose/AddedVariables.hpp"

#include "diagnose/CandidateColumn.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cmath>

namespace naocal {

std::optional<AddedVariable> addedVariable(const Inquiry& inquiry, const Model& model, std::size_t candidate) {
  const ScoreProblem& problem = inquiry.problem();
  const GroupEvidence& evidence = inquiry.ofCandidate(candidate);
  if (evidence.freedom < 1) {
    return std::nullopt;
  }
  const Eigen::VectorXd direction = evidence.estimate.size() == 1 ? Eigen::VectorXd::Ones(1) : evidence.estimate;
  const CandidateColumn column{inquiry, candidate, direction, inquiry.noise()};
  const Eigen::Index own = problem.own();
  Eigen::VectorXd left(own + 1), fitted(own + 1); // e = J left, M r = r + J fitted
  left << -column.imitation, 1;
  fitted << column.fitted, 0;

  AddedVariable result;
  result.like = labelOf(model, column.like);
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
  add(std::nullopt, believed.dot(weighted), -weighted.dot(problem.unknowns + column.fitted), weighted[column.like]);
  if (!(squares > 0)) {
    return std::nullopt;
  }
  result.slope = products / squares;
  result.sigma = 1 / std::sqrt(squares);
  return result;
}

} // namespace naocal

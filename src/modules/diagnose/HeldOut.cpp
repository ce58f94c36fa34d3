#include "diagnose/HeldOut.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace naocal {

namespace {

constexpr std::size_t folds = 5;

/// Sums over some poses: whitened ones to learn from, plain ones to measure by.
struct Sums {
  Eigen::MatrixXd hessian, gram;
  Eigen::VectorXd gradient, plainGradient;
  double squares = 0, numbers = 0;

  explicit Sums(Eigen::Index size)
      : hessian{Eigen::MatrixXd::Zero(size, size)}, gram{hessian}, gradient{Eigen::VectorXd::Zero(size)},
        plainGradient{gradient} {}

  void add(const PoseSystem& pose, const Eliminated& part) {
    hessian(pose.unknowns, pose.unknowns) += part.hessian;
    gradient(pose.unknowns) += part.unknownGradient;
    gram(pose.unknowns, pose.unknowns) += pose.unknownGram;
    plainGradient(pose.unknowns) += pose.unknownGradient;
    squares += pose.squares;
    numbers += pose.numbers;
  }
};

/// Squares of the corners' errors [px^2] of `held` when `columns` are learned from all but it.
double squaresLeft(const Sums& all, const Sums& held, const ScoreProblem& problem,
                   const std::vector<Eigen::Index>& columns) {
  Eigen::MatrixXd hessian = all.hessian(columns, columns) - held.hessian(columns, columns);
  Eigen::VectorXd gradient = all.gradient(columns) - held.gradient(columns);
  std::vector<Eigen::Index> unseen; // no other fold tells them
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (hessian(row, row) < 1e-9 * all.hessian(columns[i], columns[i])) {
      unseen.push_back(row);
    }
    if (columns[i] < problem.own()) {
      const double information = std::pow(problem.sigmas[columns[i]], -2);
      hessian(row, row) += information;
      gradient[row] += information * problem.unknowns[columns[i]];
    } else {
      hessian(row, row) += 1e-12 * all.hessian(columns[i], columns[i]);
    }
  }
  for (Eigen::Index row : unseen) {
    hessian.row(row).setZero();
    hessian.col(row).setZero();
    hessian(row, row) = 1;
    gradient[row] = 0;
  }
  Eigen::VectorXd step = -hessian.ldlt().solve(gradient);
  const Eigen::MatrixXd gram = held.gram(columns, columns);
  const Eigen::VectorXd plain = held.plainGradient(columns);
  if (!unseen.empty()) {
    Eigen::MatrixXd own = gram(unseen, unseen);
    own.diagonal().array() += 1e-12 * (1 + own.diagonal().array());
    step(unseen) = -own.ldlt().solve((plain + gram * step)(unseen));
  }
  return held.squares + 2 * plain.dot(step) + step.dot(gram * step);
}

/// The candidate with the largest Bayes factor in all but `held`, absent when none beats the model alone.
std::optional<std::size_t> chosenWithout(const Sums& all, const Sums& held, const ScoreProblem& problem,
                                         std::size_t candidates) {
  const Eigen::Index own = problem.own();
  const Eigen::MatrixXd hessian = all.hessian - held.hessian;
  const Eigen::VectorXd gradient = all.gradient - held.gradient;
  Eigen::MatrixXd ownPart = hessian.topLeftCorner(own, own);
  ownPart.diagonal() += problem.sigmas.cwiseAbs2().cwiseInverse();
  const Eigen::LLT<Eigen::MatrixXd> factor{ownPart};
  const Eigen::MatrixXd half = factor.matrixL().solve(hessian.topRightCorner(own, problem.candidates));
  const Eigen::VectorXd ownGradient = factor.matrixL().solve(gradient.head(own) + problem.priorScore());
  std::optional<std::size_t> best;
  double bestBayes = 0;
  for (std::size_t i = 0; i < candidates; ++i) {
    const ColumnGroup& group = problem.groups[i];
    const auto part = half.middleCols(group.first, group.count);
    const Eigen::VectorXd plausible = problem.plausible.segment(group.first, group.count);
    const Eigen::VectorXd score =
        plausible.cwiseProduct(part.transpose() * ownGradient - gradient.segment(own + group.first, group.count));
    Eigen::MatrixXd posterior =
        plausible.asDiagonal() *
        (hessian.block(own + group.first, own + group.first, group.count, group.count) - part.transpose() * part) *
        plausible.asDiagonal();
    posterior.diagonal().array() += 1;
    const Eigen::LLT<Eigen::MatrixXd> inner{posterior};
    const double bayes = score.dot(inner.solve(score)) - 2 * inner.matrixLLT().diagonal().array().log().sum();
    if (bayes > bestBayes) {
      bestBayes = bayes;
      best = i;
    }
  }
  return best;
}

} // namespace

HeldOut heldOut(const Inquiry& inquiry, const std::vector<std::size_t>& candidates) {
  const ScoreProblem& problem = inquiry.problem();
  const std::vector<PoseSystem>& poses = inquiry.linear().poses;
  const Noise noise = inquiry.noise();
  Sums all{problem.own() + problem.candidates};
  std::vector<Sums> parts(std::min(folds, poses.size()), all);
  for (std::size_t pose = 0; pose < poses.size(); ++pose) {
    const Eliminated part = eliminated(poses[pose], noise, deflectionRoot(poses[pose], noise));
    all.add(poses[pose], part);
    parts[pose % parts.size()].add(poses[pose], part);
  }
  std::vector<Eigen::Index> own;
  for (Eigen::Index i = 0; i < problem.own(); ++i) {
    own.push_back(i);
  }
  const auto with = [&](std::size_t candidate) {
    std::vector<Eigen::Index> columns = own;
    const ColumnGroup& group = problem.groups[candidate];
    for (Eigen::Index i = 0; i < group.count; ++i) {
      columns.push_back(problem.own() + group.first + i);
    }
    return columns;
  };
  const auto rms = [&](double squares) { return std::sqrt(2 * std::max(0.0, squares) / all.numbers); };
  HeldOut result;
  double before = 0, selected = 0;
  std::vector<double> after(candidates.size(), 0);
  for (const Sums& held : parts) {
    const double plain = squaresLeft(all, held, problem, own);
    before += plain;
    const auto chosen = chosenWithout(all, held, problem, inquiry.candidates().size());
    selected += chosen ? squaresLeft(all, held, problem, with(*chosen)) : plain;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      after[i] += squaresLeft(all, held, problem, with(candidates[i]));
    }
  }
  result.beforePx = rms(before);
  result.selectedPx = rms(selected);
  for (double squares : after) {
    result.afterPx.push_back(rms(squares));
  }
  return result;
}

} // namespace naocal

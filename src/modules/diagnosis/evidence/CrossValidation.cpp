#include "diagnosis/evidence/CrossValidation.hpp"

#include "calibration/CandidateTests.hpp"
#include "inference/ScoreProblem.hpp"
#include "inference/ScoreTest.hpp"
#include "math/LinearAlgebra.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace naocal {

namespace {

/// Sums over some poses of all columns of a linearised problem: whitened for fitting, plain for measuring the error.
struct FoldSums {
  Eigen::MatrixXd hessian, gram;
  Eigen::VectorXd gradient, plainGradient;
  double squares = 0, numbers = 0;
};

/// Sums of all poses and of each of the five folds (or one per pose, if fewer), with the unknowns moved by `step`.
struct Folds {
  FoldSums all;
  std::vector<FoldSums> parts;
};

using Columns = std::vector<Eigen::Index>;

/// Minimum share of a direction's total information (all poses and prior) that the other folds and the prior must hold.
/// Below it (a fold determines a board or stance ten times as precisely), the direction is fitted to the fold itself.
constexpr double told = 0.01;

/// Prediction of one fold from all other poses.
class Fold {
public:
  /// `prior`: information of every column; `start`: its unknown at the linearisation point; `given`: columns that are
  /// always fitted, the first of each set of columns.
  Fold(const FoldSums& all, const FoldSums& held, const Eigen::VectorXd& prior, const Eigen::VectorXd& start,
       const Columns& given)
      : held_{held}, hessian_{all.hessian - held.hessian}, gradient_{all.gradient - held.gradient}, prior_{prior},
        pull_{prior.cwiseProduct(start)} {
    Eigen::MatrixXd whole = all.hessian(given, given);
    whole.diagonal() += prior(given);
    const Eigen::LLT<Eigen::MatrixXd> factor{whole};
    Eigen::MatrixXd rest = hessian_(given, given);
    rest.diagonal() +=
        prior(given); // directions known from the prior alone count as determined: the fold must not fit its own noise
    rest = factor.matrixL().solve(rest);
    rest = factor.matrixL().solve(rest.transpose().eval());
    const SymmetricEigen eigen = symmetricEigen(rest);
    Eigen::Index untold = 0;
    while (untold < eigen.values.size() && eigen.values[untold] < told) {
      ++untold;
    }
    untold_ = factor.matrixU().solve(eigen.vectors.leftCols(untold));
    holding_ = factor.matrixL() * eigen.vectors.leftCols(untold);
  }

  /// Sum of squared errors of the fold [px^2] when `columns` are fitted to the other folds; directions that those leave
  /// undetermined are fitted to the fold itself.
  double remainingSquares(const Columns& columns) const {
    Eigen::MatrixXd hessian = hessian_(columns, columns);
    hessian.diagonal() += prior_(columns);
    hessian.topLeftCorner(holding_.rows(), holding_.rows()) += holding_ * holding_.transpose();
    Eigen::VectorXd step = -hessian.ldlt().solve((gradient_ + pull_)(columns));
    const Eigen::MatrixXd gram = held_.gram(columns, columns);
    const Eigen::VectorXd plain = held_.plainGradient(columns);
    if (untold_.cols() > 0) {
      const Eigen::Index given = untold_.rows();
      Eigen::MatrixXd own = untold_.transpose() * gram.topLeftCorner(given, given) * untold_;
      own.diagonal().array() += 1e-12 * (1 + own.diagonal().array());
      step.head(given) -= untold_ * own.ldlt().solve(untold_.transpose() * (plain + gram * step).head(given));
    }
    return held_.squares + 2 * plain.dot(step) + step.dot(gram * step);
  }

  /// Adds the group with the largest Bayes factor in the other folds to `columns`, if it improves the model.
  void addBest(const std::vector<Columns>& groups, Columns& columns) const {
    Eigen::MatrixXd known = hessian_(columns, columns);
    known.diagonal() += prior_(columns);
    const Eigen::LLT<Eigen::MatrixXd> factor{known};
    const Eigen::MatrixXd half = factor.matrixL().solve(hessian_(columns, Eigen::all));
    const Eigen::VectorXd gradient = gradient_ + pull_;
    const Eigen::VectorXd left = gradient - half.transpose() * factor.matrixL().solve(gradient(columns));
    const Columns* best = nullptr;
    double bestBayes = 0;
    for (const Columns& group : groups) {
      if (std::find(columns.begin(), columns.end(), group.front()) != columns.end()) {
        continue;
      }
      const Eigen::MatrixXd part = half(Eigen::all, group);
      const Eigen::VectorXd plausible = prior_(group).cwiseSqrt().cwiseInverse();
      const Eigen::VectorXd score = plausible.cwiseProduct(left(group));
      Eigen::MatrixXd posterior =
          plausible.asDiagonal() * (hessian_(group, group) - part.transpose() * part) * plausible.asDiagonal();
      posterior.diagonal().array() += 1;
      const Eigen::LLT<Eigen::MatrixXd> inner{posterior};
      const double bayes = score.dot(inner.solve(score)) - 2 * inner.matrixLLT().diagonal().array().log().sum();
      if (bayes > bestBayes) {
        bestBayes = bayes;
        best = &group;
      }
    }
    if (best) {
      columns.insert(columns.end(), best->begin(), best->end());
    }
  }

private:
  const FoldSums& held_;
  Eigen::MatrixXd hessian_;
  Eigen::VectorXd gradient_, prior_, pull_;
  Eigen::MatrixXd untold_, holding_; // directions of `given` that the other folds leave undetermined: D, L L^T D
};

Columns range(Eigen::Index first, Eigen::Index count) {
  Columns result(static_cast<std::size_t>(count));
  std::iota(result.begin(), result.end(), first);
  return result;
}

Columns joinColumns(Columns columns, const Columns& more) {
  columns.insert(columns.end(), more.begin(), more.end());
  return columns;
}

/// Columns available in a fold.
struct Choices {
  std::vector<Columns> candidates, chosen; // per candidate; per effect selected on all poses
  Columns given;                           // all other columns of the model
  Columns model;                           // all columns of the model: given, then chosen
  std::vector<Columns> groups;             // candidates, then chosen

  Choices(const CandidateTests& candidateTests, const Model& full, const std::vector<std::string>& labels) {
    const Eigen::Index own = candidateTests.problem().ownCount();
    for (std::size_t i = 0; i < candidateTests.candidates().size(); ++i) {
      const ColumnGroup& group = candidateTests.problem().groups[i];
      candidates.push_back(range(own + group.first, group.count));
    }
    for (const Term& term : full.terms()) {
      const Columns columns = range(eigenIndex(term.first), eigenIndex(term.effect.unknowns.size()));
      const bool isChosen = std::find(labels.begin(), labels.end(), term.label()) != labels.end();
      isChosen ? chosen.push_back(columns) : void(given = joinColumns(given, columns));
    }
    model = given;
    groups = candidates;
    for (const Columns& effect : chosen) {
      model = joinColumns(model, effect);
      groups.push_back(effect);
    }
  }
};

constexpr std::size_t folds = 5;

/// Sums over every `each`-th pose from `first` on.
FoldSums computeSums(std::size_t first, std::size_t each, const NullModel& alone) {
  const std::vector<PoseRows>& poses = *alone.problem().poses;
  const double pixel = alone.noise().pixel;
  const Eigen::Index size = alone.problem().gram.cols();
  FoldSums result;
  result.gradient = result.plainGradient = Eigen::VectorXd::Zero(size);
  GramSum plain{size}, taken{size};
  for (std::size_t pose = first; pose < poses.size(); pose += each) {
    const PoseRows& rows = poses[pose];
    const NullModel::Whitener& whitener = alone.whitener(pose);
    plain.add(rows.unknowns, rows.byUnknowns);
    taken.add(rows.unknowns, whitener.unknowns);
    const Eigen::VectorXd gradient = rows.byUnknowns.transpose() * rows.residual;
    result.plainGradient(rows.unknowns) += gradient;
    result.gradient(rows.unknowns) +=
        gradient / (pixel * pixel) - whitener.unknowns.transpose() * (whitener.half * rows.residual) / pixel;
    result.squares += rows.squares;
    result.numbers += rows.numbers;
  }
  result.gram = plain.sum();
  result.hessian = result.gram / (pixel * pixel) - taken.sum();
  return result;
}

void add(const FoldSums& part, FoldSums& sums) {
  sums.hessian += part.hessian;
  sums.gram += part.gram;
  sums.gradient += part.gradient;
  sums.plainGradient += part.plainGradient;
  sums.squares += part.squares;
  sums.numbers += part.numbers;
}

void applyStep(const Eigen::VectorXd& step, FoldSums& sums) {
  const Eigen::VectorXd moved = sums.gram * step;
  sums.squares += 2 * sums.plainGradient.dot(step) + step.dot(moved);
  sums.plainGradient += moved;
  sums.gradient += sums.hessian * step;
}

Folds splitIntoFolds(const CandidateTests& candidateTests, const Eigen::VectorXd& step) {
  const NullModel alone{candidateTests.problem(), candidateTests.noise()};
  const std::size_t parts = std::min(folds, candidateTests.poses().size());
  Folds result;
  for (std::size_t part = 0; part < parts; ++part) {
    FoldSums& sums = result.parts.emplace_back(computeSums(part, parts, alone));
    applyStep(step, sums);
    part == 0 ? void(result.all = sums) : add(sums, result.all);
  }
  return result;
}

/// Adds the fold's squared errors [px^2] to `sums`.
void addSquares(const Fold& fold, const Choices& choices, const std::vector<std::vector<std::size_t>>& added,
                CrossValidation& sums) {
  sums.beforePx += fold.remainingSquares(choices.model);
  for (std::size_t i = 0; i < added.size(); ++i) {
    Columns larger = choices.model;
    for (const std::size_t candidate : added[i]) {
      larger = joinColumns(larger, choices.candidates[candidate]);
    }
    sums.afterPx[i] += fold.remainingSquares(larger);
  }
  Columns columns = choices.given;
  for (std::size_t i = 0; i < choices.chosen.size(); ++i) {
    fold.addBest(choices.groups, columns);
  }
  sums.chosenPx += fold.remainingSquares(columns);
  fold.addBest(choices.groups, columns);
  sums.nextPx += fold.remainingSquares(columns);
}

/// Turns sums of squared errors over so many image coordinates into rms distances.
void takeRms(double numbers, CrossValidation& sums) {
  const auto toRms = [&](double& squares) { squares = std::sqrt(2 * std::max(0.0, squares) / numbers); };
  toRms(sums.beforePx);
  toRms(sums.chosenPx);
  toRms(sums.nextPx);
  std::for_each(sums.afterPx.begin(), sums.afterPx.end(), toRms);
}

} // namespace

std::optional<CrossValidation> crossValidate(const CandidateTests& candidateTests, const Model& model,
                                             const std::vector<std::string>& chosen,
                                             const std::vector<std::vector<std::size_t>>& added) {
  const ScoreProblem& problem = candidateTests.problem();
  if (candidateTests.poses().size() < 2) {
    return std::nullopt;
  }
  const Choices choices{candidateTests, model, chosen};
  Eigen::VectorXd prior{problem.ownCount() + problem.candidates}, start{Eigen::VectorXd::Zero(prior.size())};
  prior << problem.sigmas.cwiseAbs2().cwiseInverse(),
      problem.plausible.head(problem.candidates).cwiseAbs2().cwiseInverse();
  start.head(problem.ownCount()) = problem.unknowns;
  Eigen::VectorXd toNone = Eigen::VectorXd::Zero(prior.size()); // step of the selected effects to zero
  for (const Columns& effect : choices.chosen) {
    toNone(effect) = -start(effect);
    start(effect).setZero();
  }
  const Folds sums = splitIntoFolds(candidateTests, toNone);
  CrossValidation result;
  result.afterPx.resize(added.size());
  for (const FoldSums& held : sums.parts) {
    const Fold fold{sums.all, held, prior, start, choices.given};
    addSquares(fold, choices, added, result);
  }
  takeRms(sums.all.numbers, result);
  return result;
}

} // namespace naocal

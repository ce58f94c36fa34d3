#include "diagnose/ScoreTests.hpp"
#include "geometry/Angles.hpp"
#include "geometry/Index.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace naocal {

namespace {

/// Less than this part of a direction's information left: the model's own unknowns absorb it.
constexpr double absorbed = 1e-4;

/// W with |W s|^2 = s^T block^-1 s over those directions that are not absorbed.
Eigen::MatrixXd whiteningOf(const Eigen::MatrixXd& block, const Eigen::MatrixXd& whole) {
  const Eigen::VectorXd scale = whole.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen{scale.asDiagonal() * block * scale.asDiagonal()};
  Eigen::Index lost = 0;
  while (lost < block.rows() && eigen.eigenvalues()[lost] < absorbed) {
    ++lost;
  }
  const Eigen::Index kept = block.rows() - lost;
  return eigen.eigenvalues().tail(kept).cwiseSqrt().cwiseInverse().asDiagonal() *
         eigen.eigenvectors().rightCols(kept).transpose() * scale.asDiagonal();
}

} // namespace

double scatterPenalty(double level) {
  constexpr double usual = radians(0.02);
  return 2 * std::log1p(std::pow(level / usual, 2));
}

ScoreTests::ScoreTests(const ScoreProblem& problem, const Noise& noise) : problem_{problem}, noise_{noise} {
  const Eigen::Index unknowns = problem.own() + problem.candidates;
  hessian_ = Eigen::MatrixXd::Zero(unknowns, unknowns);
  hessian_.topLeftCorner(problem.own(), problem.own()) = problem.sigmas.cwiseAbs2().cwiseInverse().asDiagonal();
  mapCross_ = Eigen::MatrixXd::Zero(problem.own(), problem.map->count);
  for (const DriverCell& cell : problem.map->cells) {
    cells_.push_back(Eigen::MatrixXd::Zero(cell.count, cell.count));
  }
  for (std::size_t pose = 0; pose < problem.linear->poses.size(); ++pose) {
    addPose(pose);
  }
  project();
}

void ScoreTests::addPose(std::size_t pose) {
  const PoseSystem& system = problem_.linear->poses[pose];
  const double information = 1 / (noise_.pixel * noise_.pixel);
  const Eigen::MatrixXd cross = information * system.cross, gram = information * system.deflectionGram;
  const DeflectionRoot root = deflectionRoot(system, noise_);
  Eigen::MatrixXd inner = root.transpose() * Eigen::MatrixXd{gram * root};
  inner.diagonal().array() += 1;
  const Eigen::LLT<Eigen::MatrixXd> factor{inner};
  logDeterminant_ += 2 * factor.matrixLLT().diagonal().array().log().sum();
  Whitener whitener;
  const Eigen::MatrixXd half = factor.matrixL().solve(Eigen::MatrixXd{root.transpose()});
  whitener.inner = half.transpose() * half;
  whitener.unknowns = cross * whitener.inner;
  whitener.deflections = gram * whitener.inner;
  const Eigen::MatrixXd unknownInformation = information * system.unknownGram - whitener.unknowns * cross.transpose();
  const Eigen::MatrixXd mixed = cross - whitener.unknowns * gram;
  const Eigen::MatrixXd deflectionInformation = gram - whitener.deflections * gram;
  for (std::size_t i = 0; i < system.unknowns.size(); ++i) {
    for (std::size_t j = 0; j < system.unknowns.size(); ++j) {
      hessian_(at(system.unknowns[i]), at(system.unknowns[j])) += unknownInformation(at(i), at(j));
    }
  }
  for (const DriverColumns::Block& block : problem_.map->blocks[pose]) {
    const Eigen::MatrixXd columns = mixed.middleCols(block.firstDeflection, block.values.rows()) * block.values;
    for (std::size_t i = 0; i < system.unknowns.size() && at(system.unknowns[i]) < problem_.own(); ++i) {
      mapCross_.row(at(system.unknowns[i])).segment(block.firstColumn, block.values.cols()) += columns.row(at(i));
    }
    const auto own = deflectionInformation.block(block.firstDeflection, block.firstDeflection, block.values.rows(),
                                                 block.values.rows());
    for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
      const Eigen::Index first = problem_.map->cells[cell].first - block.firstColumn;
      if (first >= 0 && first < block.values.cols()) {
        const auto values = block.values.middleCols(first, problem_.map->cells[cell].count);
        cells_[cell] += values.transpose() * own * values;
      }
    }
  }
  whiteners_.push_back(std::move(whitener));
}

void ScoreTests::project() {
  const Eigen::Index own = problem_.own(), candidates = problem_.candidates;
  own_.compute(hessian_.topLeftCorner(own, own));
  Eigen::MatrixXd cross(own, candidates + problem_.map->count);
  cross << hessian_.topRightCorner(own, candidates), mapCross_;
  explained_ = own_.matrixL().solve(cross);
  const auto byCandidates = explained_.leftCols(candidates);
  information_ = hessian_.bottomRightCorner(candidates, candidates) - byCandidates.transpose() * byCandidates;
  std::size_t cell = 0;
  for (const ColumnGroup& group : problem_.groups) {
    const bool effect = group.first < candidates;
    const Eigen::MatrixXd whole =
        effect ? hessian_.block(own + group.first, own + group.first, group.count, group.count) : cells_[cell++];
    const auto part = explained_.middleCols(group.first, group.count);
    blocks_.push_back(whole - part.transpose() * part);
    whitening_.push_back(whiteningOf(blocks_.back(), whole));
    kept_.push_back(whole.trace() > 0 ? blocks_.back().trace() / whole.trace() : 0);
  }
}

void ScoreTests::ownScores(const PoseScores& scores, const Eigen::VectorXd& priorScore, Outcome& outcome,
                           Eigen::MatrixXd& own) const {
  const Eigen::Index draws = scores.front().unknowns.cols();
  own = priorScore.replicate(1, draws);
  outcome.chi2.setZero(draws);
  for (std::size_t pose = 0; pose < scores.size(); ++pose) {
    const std::vector<std::size_t>& unknowns = problem_.linear->poses[pose].unknowns;
    const auto count =
        std::lower_bound(unknowns.begin(), unknowns.end(), static_cast<std::size_t>(problem_.own())) - unknowns.begin();
    const Eigen::MatrixXd& bent = scores[pose].deflections;
    outcome.chi2 -= bent.cwiseProduct(whiteners_[pose].inner * bent).colwise().sum();
    const Eigen::MatrixXd part = scores[pose].unknowns.topRows(count) - whiteners_[pose].unknowns.topRows(count) * bent;
    for (Eigen::Index i = 0; i < count; ++i) {
      own.row(at(unknowns[static_cast<std::size_t>(i)])) += part.row(i);
    }
  }
  own_.matrixL().solveInPlace(own);
  outcome.chi2 -= own.colwise().squaredNorm();
  outcome.deviance = outcome.chi2.array() + logDeterminant_ + 2 * own_.matrixLLT().diagonal().array().log().sum() +
                     scatterPenalty(noise_.pose);
}

ScoreTests::Outcome ScoreTests::modelAlone(const PoseScores& scores, const Eigen::VectorXd& priorScore) const {
  Outcome outcome;
  Eigen::MatrixXd own;
  ownScores(scores, priorScore, outcome, own);
  return outcome;
}

/// Scores of all columns, downhill; `own`: L^-1 times those of the own unknowns.
Eigen::MatrixXd ScoreTests::projectedScores(const PoseScores& scores, const Eigen::MatrixXd& own) const {
  Eigen::MatrixXd result = explained_.transpose() * own;
  for (std::size_t pose = 0; pose < scores.size(); ++pose) {
    const std::vector<std::size_t>& unknowns = problem_.linear->poses[pose].unknowns;
    const auto first =
        std::lower_bound(unknowns.begin(), unknowns.end(), static_cast<std::size_t>(problem_.own())) - unknowns.begin();
    const Eigen::MatrixXd& bent = scores[pose].deflections;
    const Eigen::Index count = at(unknowns.size()) - first;
    const Eigen::MatrixXd part =
        scores[pose].unknowns.bottomRows(count) - whiteners_[pose].unknowns.bottomRows(count) * bent;
    for (Eigen::Index i = 0; i < count; ++i) {
      result.row(at(unknowns[static_cast<std::size_t>(first + i)]) - problem_.own()) -= part.row(i);
    }
    if (problem_.map->blocks[pose].empty()) {
      continue;
    }
    const Eigen::MatrixXd deflections = bent - whiteners_[pose].deflections * bent;
    for (const DriverColumns::Block& block : problem_.map->blocks[pose]) {
      result.middleRows(problem_.candidates + block.firstColumn, block.values.cols()).noalias() -=
          block.values.transpose() * deflections.middleRows(block.firstDeflection, block.values.rows());
    }
  }
  return result;
}

ScoreTests::Outcome ScoreTests::operator()(const PoseScores& scores, const Eigen::VectorXd& priorScore) const {
  Outcome outcome;
  Eigen::MatrixXd own;
  ownScores(scores, priorScore, outcome, own);
  const Eigen::MatrixXd all = projectedScores(scores, own);
  outcome.falls.resize(at(problem_.groups.size()), all.cols());
  for (std::size_t i = 0; i < problem_.groups.size(); ++i) {
    outcome.falls.row(at(i)) =
        (whitening_[i] * all.middleRows(problem_.groups[i].first, problem_.groups[i].count)).colwise().squaredNorm();
  }
  return outcome;
}

std::vector<ScoreTests::GroupScore> ScoreTests::groups(const PoseScores& scores,
                                                       const Eigen::VectorXd& priorScore) const {
  Outcome outcome;
  Eigen::MatrixXd own;
  ownScores(scores, priorScore, outcome, own);
  const Eigen::VectorXd all = projectedScores(scores, own).col(0);
  std::vector<GroupScore> result;
  for (std::size_t i = 0; i < problem_.groups.size(); ++i) {
    result.push_back({all.segment(problem_.groups[i].first, problem_.groups[i].count), blocks_[i]});
  }
  return result;
}

} // namespace naocal

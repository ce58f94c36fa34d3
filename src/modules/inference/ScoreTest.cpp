#include "inference/ScoreTest.hpp"

#include "inference/ScoreProblem.hpp"
#include "math/LinearAlgebra.hpp"
#include "math/Parallel.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace naocal {

namespace {

/// A factor with the same product half^T half and at most as many rows as columns.
Eigen::MatrixXd compressRows(const Eigen::MatrixXd& half) {
  if (half.rows() <= half.cols()) {
    return half;
  }
  return Eigen::HouseholderQR<Eigen::MatrixXd>{half}.matrixQR().topRows(half.cols()).triangularView<Eigen::Upper>();
}

/// Remaining share of a direction's information below which the own unknowns absorb it.
constexpr double absorbed = 1e-4;

/// W with |W s|^2 = s^T block^-1 s over the directions that are not absorbed.
Eigen::MatrixXd computeWhitening(const Eigen::MatrixXd& block, const Eigen::MatrixXd& whole) {
  const Eigen::VectorXd scale = whole.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const SymmetricEigen eigen = symmetricEigen(scale.asDiagonal() * block * scale.asDiagonal());
  Eigen::Index lost = 0;
  while (lost < block.rows() && eigen.values[lost] < absorbed) {
    ++lost;
  }
  const Eigen::Index kept = block.rows() - lost;
  return eigen.values.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal() * eigen.vectors.rightCols(kept).transpose() *
         scale.asDiagonal();
}

} // namespace

NullModel::NullModel(const ScoreProblem& problem, const Noise& noise) : problem_{problem}, noise_{noise} {
  const double information = 1 / (noise.pixel * noise.pixel);
  const Eigen::Index own = problem.ownCount();
  whiteners_.resize(problem.poses->size());
  Eigen::MatrixXd hessian = information * problem.gram.topLeftCorner(own, own);
  hessian.diagonal() += problem.sigmas.cwiseAbs2().cwiseInverse();
  const auto none = [&] { return Taken{Eigen::MatrixXd::Zero(own, own)}; };
  const auto take = [&](std::size_t pose, Taken& taken) { takeDeflections(pose, taken); };
  for (const Taken& part : gatherInParts(whiteners_.size(), none, take)) {
    hessian -= part.information;
    logDeterminant_ += part.logDeterminant;
  }
  factor_.compute(hessian);
}

void NullModel::takeDeflections(std::size_t pose, Taken& taken) {
  const PoseRows& rows = (*problem_.poses)[pose];
  const Eigen::MatrixXd moved = rows.byDeflections * jointErrorRoot(rows, noise_) / noise_.pixel;
  Eigen::MatrixXd inner = moved.transpose() * moved;
  inner.diagonal().array() += 1;
  const Eigen::LLT<Eigen::MatrixXd> factor{inner};
  taken.logDeterminant += 2 * factor.matrixLLT().diagonal().array().log().sum();
  Whitener& whitener = whiteners_[pose];
  whitener.half = compressRows(factor.matrixL().solve(moved.transpose()));
  whitener.unknowns.noalias() = whitener.half * rows.byUnknowns / noise_.pixel;
  const std::vector<std::size_t> unknowns = problem_.ownUnknownsIn(rows);
  const auto answers = whitener.unknowns.leftCols(problem_.ownCountIn(rows));
  taken.information(unknowns, unknowns) += answers.transpose() * answers;
}

NullModel::Outcome NullModel::operator()(const PoseResiduals& residuals, const Eigen::VectorXd& priorScore) const {
  const double information = 1 / (noise_.pixel * noise_.pixel);
  const Eigen::Index draws = residuals.empty() ? 1 : residuals.front().cols();
  Outcome result;
  result.own = priorScore.replicate(1, draws);
  result.chi2.setZero(draws);
  const auto none = [&] {
    return Outcome{.deviance = {},
                   .chi2 = Eigen::RowVectorXd::Zero(draws),
                   .own = Eigen::MatrixXd::Zero(priorScore.size(), draws)};
  };
  const auto add = [&](std::size_t pose, Outcome& sum) {
    const PoseRows& rows = (*problem_.poses)[pose];
    const Eigen::Index own = problem_.ownCountIn(rows);
    const Eigen::MatrixXd bent = whiteners_[pose].half * residuals[pose] / noise_.pixel;
    sum.chi2 -= bent.colwise().squaredNorm();
    sum.own(problem_.ownUnknownsIn(rows), Eigen::all) +=
        information * (rows.byUnknowns.leftCols(own).transpose() * residuals[pose]) -
        whiteners_[pose].unknowns.leftCols(own).transpose() * bent;
  };
  for (const Outcome& part : gatherInParts(residuals.size(), none, add)) {
    result.chi2 += part.chi2;
    result.own += part.own;
  }
  factor_.matrixL().solveInPlace(result.own);
  result.chi2 -= result.own.colwise().squaredNorm();
  result.deviance = result.chi2.array() + logDeterminant_ + 2 * factor_.matrixLLT().diagonal().array().log().sum();
  return result;
}

ScoreTest::ScoreTest(const NullModel& alone) : alone_{alone} {
  const ScoreProblem& problem = alone.problem();
  const std::size_t poses = problem.poses->size();
  Eigen::MatrixXd whitened = problem.gram / (noise().pixel * noise().pixel);
  for (GramSum& part : gatherInParts(
           poses, [&] { return GramSum{problem.gram.cols()}; },
           [&](std::size_t pose, GramSum&sum) {
             sum.add((*problem.poses)[pose].unknowns, alone.whitener(pose).unknowns);
           })) {
    whitened -= part.sum();
  }
  deflections_.resize(poses);
  const std::vector<Columns> parts = gatherInParts(
      poses, [&] { return makeEmptyColumns(problem); },
      [&](std::size_t pose, Columns& columns) { addCurves(pose, columns); });
  Columns columns = makeEmptyColumns(problem);
  for (const Columns& part : parts) {
    columns += part;
  }
  columns.cross.leftCols(problem.candidates) = whitened.topRightCorner(problem.ownCount(), problem.candidates);
  columns.candidates = whitened.bottomRightCorner(problem.candidates, problem.candidates);
  project(columns);
}

ScoreTest::Columns ScoreTest::makeEmptyColumns(const ScoreProblem& problem) {
  Columns columns;
  columns.cross = Eigen::MatrixXd::Zero(problem.ownCount(), problem.candidates + problem.map->count);
  for (const DriverBasis& cell : problem.map->cells) {
    columns.cells.push_back(Eigen::MatrixXd::Zero(cell.count, cell.count));
  }
  return columns;
}

ScoreTest::Columns& ScoreTest::Columns::operator+=(const Columns& other) {
  cross += other.cross;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    cells[cell] += other.cells[cell];
  }
  return *this;
}

void ScoreTest::addCurves(std::size_t pose, Columns& columns) {
  const ScoreProblem& problem = alone_.problem();
  const PoseRows& rows = (*problem.poses)[pose];
  const NullModel::Whitener& whitener = alone_.whitener(pose);
  const double information = 1 / (noise().pixel * noise().pixel);
  const Eigen::MatrixXd& deflections = deflections_[pose] = whitener.half * rows.byDeflections / noise().pixel;
  if (problem.map->blocks[pose].empty()) {
    return;
  }
  const Eigen::Index own = problem.ownCountIn(rows);
  const Eigen::MatrixXd mixed = information * (rows.byUnknowns.leftCols(own).transpose() * rows.byDeflections) -
                                whitener.unknowns.leftCols(own).transpose() * deflections;
  const Eigen::MatrixXd deflectionInformation =
      information * (rows.byDeflections.transpose() * rows.byDeflections) - deflections.transpose() * deflections;
  for (const DriverColumns::Block& block : problem.map->blocks[pose]) {
    const Eigen::Index count = block.values.cols();
    const Eigen::MatrixXd byBlock = mixed.middleCols(block.firstDeflection, block.values.rows()) * block.values;
    for (Eigen::Index i = 0; i < own; ++i) {
      columns.cross.row(eigenIndex(rows.unknowns[static_cast<std::size_t>(i)]))
          .segment(problem.candidates + block.firstColumn, count) += byBlock.row(i);
    }
    const auto bent = deflectionInformation.block(block.firstDeflection, block.firstDeflection, block.values.rows(),
                                                  block.values.rows());
    for (std::size_t cell = 0; cell < columns.cells.size(); ++cell) {
      const Eigen::Index first = problem.map->cells[cell].first - block.firstColumn;
      if (first >= 0 && first < count) {
        const auto values = block.values.middleCols(first, problem.map->cells[cell].count);
        columns.cells[cell] += values.transpose() * bent * values;
      }
    }
  }
}

void ScoreTest::project(const Columns& columns) {
  const ScoreProblem& problem = alone_.problem();
  explained_ = alone_.factor().matrixL().solve(columns.cross);
  const auto byCandidates = explained_.leftCols(problem.candidates);
  information_ = columns.candidates - byCandidates.transpose() * byCandidates;
  std::size_t cell = 0;
  for (const ColumnGroup& group : problem.groups) {
    const bool effect = group.first < problem.candidates;
    const Eigen::MatrixXd whole =
        effect ? columns.candidates.block(group.first, group.first, group.count, group.count) : columns.cells[cell++];
    const auto part = explained_.middleCols(group.first, group.count);
    blocks_.push_back(whole - part.transpose() * part);
    whitening_.push_back(computeWhitening(blocks_.back(), whole));
    kept_.push_back(whole.trace() > 0 ? blocks_.back().trace() / whole.trace() : 0);
  }
}

Eigen::MatrixXd ScoreTest::projectedScores(const PoseResiduals& residuals, const Eigen::MatrixXd& own) const {
  const ScoreProblem& problem = alone_.problem();
  const double information = 1 / (noise().pixel * noise().pixel);
  Eigen::MatrixXd result = explained_.transpose() * own;
  const auto none = [&] { return Eigen::MatrixXd{Eigen::MatrixXd::Zero(result.rows(), result.cols())}; };
  const auto add = [&](std::size_t pose, Eigen::MatrixXd& sum) {
    const PoseRows& rows = (*problem.poses)[pose];
    const Eigen::Index first = problem.ownCountIn(rows), rest = eigenIndex(rows.unknowns.size()) - first;
    const NullModel::Whitener& whitener = alone_.whitener(pose);
    const Eigen::MatrixXd bent = whitener.half * residuals[pose] / noise().pixel;
    const Eigen::MatrixXd part = information * (rows.byUnknowns.rightCols(rest).transpose() * residuals[pose]) -
                                 whitener.unknowns.rightCols(rest).transpose() * bent;
    for (Eigen::Index i = 0; i < rest; ++i) {
      sum.row(eigenIndex(rows.unknowns[static_cast<std::size_t>(first + i)]) - problem.ownCount()) += part.row(i);
    }
    if (problem.map->blocks[pose].empty()) {
      return;
    }
    const Eigen::MatrixXd deflections =
        information * (rows.byDeflections.transpose() * residuals[pose]) - deflections_[pose].transpose() * bent;
    for (const DriverColumns::Block& block : problem.map->blocks[pose]) {
      sum.middleRows(problem.candidates + block.firstColumn, block.values.cols()).noalias() +=
          block.values.transpose() * deflections.middleRows(block.firstDeflection, block.values.rows());
    }
  };
  for (const Eigen::MatrixXd& part : gatherInParts(residuals.size(), none, add)) {
    result -= part;
  }
  return result;
}

/// The first `count` columns of a group in a pose's residuals.
Eigen::MatrixXd ScoreTest::columnsOfGroup(std::size_t group, Eigen::Index count, std::size_t pose) const {
  const ScoreProblem& problem = alone_.problem();
  const PoseRows& rows = (*problem.poses)[pose];
  const Eigen::Index first = problem.groups[group].first;
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(rows.residual.size(), count);
  if (first < problem.candidates) {
    const auto wanted = static_cast<std::size_t>(problem.ownCount() + first);
    auto unknown = std::lower_bound(rows.unknowns.begin(), rows.unknowns.end(), wanted);
    for (; unknown != rows.unknowns.end() && *unknown < wanted + static_cast<std::size_t>(count); ++unknown) {
      result.col(eigenIndex(*unknown - wanted)) = rows.byUnknowns.col(unknown - rows.unknowns.begin());
    }
    return result;
  }
  for (const DriverColumns::Block& block : problem.map->blocks[pose]) {
    const Eigen::Index column = first - problem.candidates - block.firstColumn;
    if (column >= 0 && column < block.values.cols()) {
      result = rows.byDeflections.middleCols(block.firstDeflection, block.values.rows()) *
               block.values.middleCols(column, count);
    }
  }
  return result;
}

Eigen::MatrixXd ScoreTest::informationWith(std::size_t group, Eigen::Index count) const {
  const ScoreProblem& problem = alone_.problem();
  PoseResiduals moved;
  for (std::size_t pose = 0; pose < problem.poses->size(); ++pose) {
    moved.push_back(columnsOfGroup(group, count, pose));
  }
  return -projectedScores(moved, explained_.middleCols(problem.groups[group].first, count));
}

double ScoreTest::movedPx(std::size_t group, const Eigen::VectorXd& coefficients) const {
  const ScoreProblem& problem = alone_.problem();
  const Eigen::Index count = coefficients.size(), first = problem.groups[group].first;
  const Eigen::VectorXd own = -alone_.factor().matrixU().solve(explained_.middleCols(first, count) * coefficients);
  double squares = 0, numbers = 0;
  for (const PoseRows& rows : *problem.poses) {
    numbers += rows.numbers;
  }
  if (first < problem.candidates) { // |J_o o + G c|^2 from sums over all poses
    const Eigen::Index column = problem.ownCount() + first;
    squares = own.dot(problem.gram.topLeftCorner(own.size(), own.size()) * own) +
              2 * own.dot(problem.gram.block(0, column, own.size(), count) * coefficients) +
              coefficients.dot(problem.gram.block(column, column, count, count) * coefficients);
  } else {
    for (std::size_t pose = 0; pose < problem.poses->size(); ++pose) {
      const PoseRows& rows = (*problem.poses)[pose];
      squares += (rows.byUnknowns.leftCols(problem.ownCountIn(rows)) * own(problem.ownUnknownsIn(rows)) +
                  columnsOfGroup(group, count, pose) * coefficients)
                     .squaredNorm();
    }
  }
  return std::sqrt(2 * std::max(0.0, squares) / std::max(1.0, numbers));
}

Eigen::MatrixXd ScoreTest::chi2Decreases(const PoseResiduals& residuals, const Eigen::MatrixXd& own) const {
  const std::vector<ColumnGroup>& groups = alone_.problem().groups;
  const Eigen::MatrixXd all = projectedScores(residuals, own);
  Eigen::MatrixXd result(eigenIndex(groups.size()), all.cols());
  for (std::size_t i = 0; i < groups.size(); ++i) {
    result.row(eigenIndex(i)) =
        (whitening_[i] * all.middleRows(groups[i].first, groups[i].count)).colwise().squaredNorm();
  }
  return result;
}

MeasuredTests::MeasuredTests(const ScoreProblem& problem, const Noise& noise)
    : residuals{measuredResiduals(*problem.poses)}, alone{problem, noise}, tests{alone},
      outcome{alone(residuals, problem.priorScore())}, scores{tests.projectedScores(residuals, outcome.own).col(0)} {}

} // namespace naocal

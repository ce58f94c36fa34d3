#include "evidence/ScoreTests.hpp"
#include "geometry/Index.hpp"
#include "geometry/SymmetricEigen.hpp"

#include <algorithm>
#include <cmath>

namespace naocal {

namespace {

/// Less than this part of a direction's information left: the model's own unknowns absorb it.
constexpr double absorbed = 1e-4;

/// W with |W s|^2 = s^T block^-1 s over those directions that are not absorbed.
Eigen::MatrixXd whiteningOf(const Eigen::MatrixXd& block, const Eigen::MatrixXd& whole) {
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

ScoreTests::ScoreTests(const ModelAlone& alone) : alone_{alone} {
  const ScoreProblem& problem = alone.problem();
  Columns columns;
  columns.cross = Eigen::MatrixXd::Zero(problem.own(), problem.candidates + problem.map->count);
  columns.candidates = Eigen::MatrixXd::Zero(problem.candidates, problem.candidates);
  for (const DriverCell& cell : problem.map->cells) {
    columns.cells.push_back(Eigen::MatrixXd::Zero(cell.count, cell.count));
  }
  for (std::size_t pose = 0; pose < problem.linear->poses.size(); ++pose) {
    addPose(pose, columns);
  }
  project(columns);
}

void ScoreTests::addPose(std::size_t pose, Columns& columns) {
  const ScoreProblem& problem = alone_.problem();
  const PoseSystem& system = problem.linear->poses[pose];
  const ModelAlone::Whitener& whitener = alone_.whitener(pose);
  const double information = 1 / (noise().pixel * noise().pixel);
  const Eigen::MatrixXd cross = information * system.cross, gram = information * system.deflectionGram;
  const Eigen::Index own = problem.ownOf(system), rest = at(system.unknowns.size()) - own;
  const Eigen::MatrixXd whitened = information * system.unknownGram.rightCols(rest) -
                                   whitener.unknowns.transpose() * whitener.unknowns.rightCols(rest);
  const auto unknown = [&](Eigen::Index i) { return at(system.unknowns[static_cast<std::size_t>(i)]); };
  for (Eigen::Index j = 0; j < rest; ++j) {
    const Eigen::Index column = unknown(own + j) - problem.own();
    for (Eigen::Index i = 0; i < own; ++i) {
      columns.cross(unknown(i), column) += whitened(i, j);
    }
    for (Eigen::Index i = 0; i < rest; ++i) {
      columns.candidates(unknown(own + i) - problem.own(), column) += whitened(own + i, j);
    }
  }
  const Eigen::MatrixXd& deflections = deflections_.emplace_back(whitener.half * gram);
  if (problem.map->blocks[pose].empty()) {
    return;
  }
  const Eigen::MatrixXd mixed = cross.topRows(own) - whitener.unknowns.leftCols(own).transpose() * deflections;
  const Eigen::MatrixXd deflectionInformation = gram - deflections.transpose() * deflections;
  for (const DriverColumns::Block& block : problem.map->blocks[pose]) {
    const Eigen::Index count = block.values.cols();
    const Eigen::MatrixXd byBlock = mixed.middleCols(block.firstDeflection, block.values.rows()) * block.values;
    for (Eigen::Index i = 0; i < own; ++i) {
      columns.cross.row(unknown(i)).segment(problem.candidates + block.firstColumn, count) += byBlock.row(i);
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

void ScoreTests::project(const Columns& columns) {
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
    whitening_.push_back(whiteningOf(blocks_.back(), whole));
    kept_.push_back(whole.trace() > 0 ? blocks_.back().trace() / whole.trace() : 0);
  }
}

/// Scores of all columns, downhill.
Eigen::MatrixXd ScoreTests::projectedScores(const PoseScores& scores, const Eigen::MatrixXd& own) const {
  const ScoreProblem& problem = alone_.problem();
  Eigen::MatrixXd result = explained_.transpose() * own;
  for (std::size_t pose = 0; pose < scores.size(); ++pose) {
    const PoseSystem& system = problem.linear->poses[pose];
    const Eigen::Index first = problem.ownOf(system), rest = at(system.unknowns.size()) - first;
    const ModelAlone::Whitener& whitener = alone_.whitener(pose);
    const Eigen::MatrixXd bent = whitener.half * scores[pose].deflections;
    const Eigen::MatrixXd part =
        scores[pose].unknowns.bottomRows(rest) - whitener.unknowns.rightCols(rest).transpose() * bent;
    for (Eigen::Index i = 0; i < rest; ++i) {
      result.row(at(system.unknowns[static_cast<std::size_t>(first + i)]) - problem.own()) -= part.row(i);
    }
    if (problem.map->blocks[pose].empty()) {
      continue;
    }
    const Eigen::MatrixXd deflections = scores[pose].deflections - deflections_[pose].transpose() * bent;
    for (const DriverColumns::Block& block : problem.map->blocks[pose]) {
      result.middleRows(problem.candidates + block.firstColumn, block.values.cols()).noalias() -=
          block.values.transpose() * deflections.middleRows(block.firstDeflection, block.values.rows());
    }
  }
  return result;
}

Eigen::MatrixXd ScoreTests::informationWith(std::size_t group, Eigen::Index count) const {
  const ScoreProblem& problem = alone_.problem();
  const Eigen::Index first = problem.groups[group].first;
  const bool curve = first >= problem.candidates; // of the map
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(problem.candidates + problem.map->count, count);
  const double information = 1 / (noise().pixel * noise().pixel);
  for (std::size_t pose = 0; pose < problem.linear->poses.size(); ++pose) {
    const PoseSystem& system = problem.linear->poses[pose];
    const ModelAlone::Whitener& whitener = alone_.whitener(pose);
    const Eigen::Index own = problem.ownOf(system), rest = at(system.unknowns.size()) - own;
    const auto place = [&](Eigen::Index i) {
      return at(system.unknowns[static_cast<std::size_t>(own + i)]) - problem.own();
    };
    // derivative of each deflection by the group's columns, and of each unknown beyond the own ones
    Eigen::MatrixXd bends = Eigen::MatrixXd::Zero(at(system.joints.size()), count);
    Eigen::MatrixXd moves = Eigen::MatrixXd::Zero(rest, count);
    if (curve) {
      for (const DriverColumns::Block& block : problem.map->blocks[pose]) {
        const Eigen::Index column = first - problem.candidates - block.firstColumn;
        if (column >= 0 && column < block.values.cols()) {
          bends.middleRows(block.firstDeflection, block.values.rows()) = block.values.middleCols(column, count);
        }
      }
    } else {
      for (Eigen::Index i = 0; i < rest; ++i) {
        if (const Eigen::Index column = place(i) - first; column >= 0 && column < count) {
          moves(i, column) = 1;
        }
      }
    }
    const Eigen::MatrixXd cross = information * system.cross.bottomRows(rest);
    const Eigen::MatrixXd gram = information * system.deflectionGram;
    // J_c^T Sigma^-1 and J_t^T Sigma^-1 times what the columns do
    const Eigen::MatrixXd pixels = cross.transpose() * moves + gram * bends; // J_t^T (...) / pixel^2
    const Eigen::MatrixXd bent = whitener.half * pixels;
    const Eigen::MatrixXd byUnknown = information * system.unknownGram.bottomRightCorner(rest, rest) * moves +
                                      cross * bends - whitener.unknowns.rightCols(rest).transpose() * bent;
    for (Eigen::Index i = 0; i < rest; ++i) {
      result.row(place(i)) += byUnknown.row(i);
    }
    if (problem.map->blocks[pose].empty()) {
      continue;
    }
    const Eigen::MatrixXd byDeflection = pixels - deflections_[pose].transpose() * bent;
    for (const DriverColumns::Block& block : problem.map->blocks[pose]) {
      result.middleRows(problem.candidates + block.firstColumn, block.values.cols()).noalias() +=
          block.values.transpose() * byDeflection.middleRows(block.firstDeflection, block.values.rows());
    }
  }
  result.noalias() -= explained_.transpose() * explained_.middleCols(first, count);
  return result;
}

double ScoreTests::movedPx(std::size_t group, const Eigen::VectorXd& coefficients) const {
  const ScoreProblem& problem = alone_.problem();
  const Eigen::Index first = problem.groups[group].first, count = coefficients.size();
  const bool curve = first >= problem.candidates;                                     // of the map
  Eigen::VectorXd change = Eigen::VectorXd::Zero(problem.own() + problem.candidates); // of all unknowns
  change.head(problem.own()) = -alone_.factor().matrixU().solve(explained_.middleCols(first, count) * coefficients);
  if (!curve) {
    change.segment(problem.own() + first, count) = coefficients;
  }
  double squares = 0, numbers = 0;
  for (std::size_t pose = 0; pose < problem.linear->poses.size(); ++pose) {
    const PoseSystem& system = problem.linear->poses[pose];
    const Eigen::VectorXd moves = change(system.unknowns);
    numbers += system.numbers;
    squares += moves.dot(system.unknownGram * moves);
    for (const DriverColumns::Block& block : problem.map->blocks[pose]) {
      const Eigen::Index column = first - problem.candidates - block.firstColumn;
      if (curve && column >= 0 && column < block.values.cols()) {
        const Eigen::VectorXd bend = block.values.middleCols(column, count) * coefficients;
        const auto rows = Eigen::seqN(block.firstDeflection, bend.size());
        squares +=
            2 * moves.dot(system.cross(Eigen::all, rows) * bend) + bend.dot(system.deflectionGram(rows, rows) * bend);
      }
    }
  }
  return std::sqrt(2 * std::max(0.0, squares) / std::max(1.0, numbers));
}

Eigen::MatrixXd ScoreTests::falls(const PoseScores& scores, const Eigen::MatrixXd& own) const {
  const std::vector<ColumnGroup>& groups = alone_.problem().groups;
  const Eigen::MatrixXd all = projectedScores(scores, own);
  Eigen::MatrixXd result(at(groups.size()), all.cols());
  for (std::size_t i = 0; i < groups.size(); ++i) {
    result.row(at(i)) = (whitening_[i] * all.middleRows(groups[i].first, groups[i].count)).colwise().squaredNorm();
  }
  return result;
}

std::vector<ScoreTests::GroupScore> ScoreTests::groups(const PoseScores& scores, const Eigen::MatrixXd& own) const {
  const Eigen::VectorXd all = projectedScores(scores, own).col(0);
  std::vector<GroupScore> result;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const ColumnGroup& group = alone_.problem().groups[i];
    result.push_back({all.segment(group.first, group.count), blocks_[i]});
  }
  return result;
}

} // namespace naocal

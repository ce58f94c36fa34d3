#include "inference/ScoreProblem.hpp"

#include "math/Parallel.hpp"

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <utility>

namespace naocal {

namespace {

constexpr Eigen::Index together = 128; // rows

Eigen::MatrixXd drawNormals(Eigen::Index rows, Eigen::Index columns, boost::random::mt19937_64& random) {
  boost::random::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

} // namespace

GramSum::GramSum(Eigen::Index columns)
    : sum_{Eigen::MatrixXd::Zero(columns, columns)}, waiting_{Eigen::MatrixXd::Zero(together, columns)} {}

void GramSum::add(const std::vector<std::size_t>& columns, const Eigen::MatrixXd& rows) {
  for (Eigen::Index first = 0; first < rows.rows(); first += together) {
    const Eigen::Index count = std::min(together, rows.rows() - first);
    if (count_ + count > together) {
      multiply();
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
      waiting_.col(static_cast<Eigen::Index>(columns[i])).segment(count_, count) =
          rows.col(static_cast<Eigen::Index>(i)).segment(first, count);
    }
    count_ += count;
  }
}

Eigen::MatrixXd GramSum::sum() {
  multiply();
  return sum_.selfadjointView<Eigen::Lower>();
}

void GramSum::multiply() {
  if (count_ == 0) { // Eigen divides by the number of rows
    return;
  }
  sum_.selfadjointView<Eigen::Lower>().rankUpdate(waiting_.topRows(count_).transpose());
  waiting_.topRows(count_).setZero();
  count_ = 0;
}

PoseResiduals measuredResiduals(const std::vector<PoseRows>& poses) {
  PoseResiduals result;
  for (const PoseRows& pose : poses) {
    result.emplace_back(pose.residual);
  }
  return result;
}

PoseResiduals drawResiduals(const std::vector<PoseRows>& poses, const Noise& noise, Eigen::Index draws,
                            std::uint64_t seed) {
  boost::random::mt19937_64 random{seed};
  PoseResiduals result;
  for (const PoseRows& pose : poses) {
    Eigen::MatrixXd& drawn = result.emplace_back(noise.pixel * drawNormals(pose.residual.size(), draws, random));
    const Eigen::MatrixXd deflections = drawNormals(pose.byDeflections.cols(), draws, random);
    drawn.noalias() += Eigen::MatrixXd{pose.byDeflections * jointErrorRoot(pose, noise)} * deflections;
  }
  return result;
}

ScoreProblem::ScoreProblem(const std::vector<PoseRows>& poses, const DriverColumns& map, Eigen::VectorXd unknowns,
                           Eigen::VectorXd sigmas, Eigen::Index candidates)
    : poses{&poses}, map{&map}, unknowns{std::move(unknowns)}, sigmas{std::move(sigmas)}, candidates{candidates} {
  const Eigen::Index columns = ownCount() + candidates;
  gram = Eigen::MatrixXd::Zero(columns, columns);
  for (GramSum& part : gatherInParts(
           poses.size(), [&] { return GramSum{columns}; },
           [&](std::size_t pose, GramSum&sum) { sum.add(poses[pose].unknowns, poses[pose].byUnknowns); })) {
    gram += part.sum();
  }
}

Eigen::Index ScoreProblem::ownCountIn(const PosePart& pose) const {
  return std::lower_bound(pose.unknowns.begin(), pose.unknowns.end(), static_cast<std::size_t>(ownCount())) -
         pose.unknowns.begin();
}

std::vector<std::size_t> ScoreProblem::ownUnknownsIn(const PosePart& pose) const {
  return {pose.unknowns.begin(), pose.unknowns.begin() + ownCountIn(pose)};
}

EffectsOnly::EffectsOnly(const ScoreProblem& wide)
    : none_{.blocks = std::vector<std::vector<DriverColumns::Block>>(wide.poses->size())}, problem_{wide} {
  problem_.groups.resize(problem_.named);
  problem_.map = &none_;
  for (Eigen::VectorXd* const columns : {&problem_.plausible, &problem_.sizes}) {
    columns->conservativeResize(std::min(columns->size(), problem_.candidates));
  }
}

EffectsOnly::EffectsOnly(const ScoreProblem& wide, const std::vector<bool>& marked) : EffectsOnly{wide} {
  for (std::size_t group = 0; group < problem_.named; ++group) {
    if (!marked[group]) {
      problem_.plausible.segment(problem_.groups[group].first, problem_.groups[group].count).setZero();
    }
  }
}

} // namespace naocal

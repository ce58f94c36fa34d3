#include "diagnose/LevelTests.hpp"

#include "geometry/Angles.hpp"
#include "geometry/Index.hpp"

#include <algorithm>

namespace naocal {

namespace {

PoseScores columns(const PoseScores& scores, const std::vector<Eigen::Index>& which) {
  PoseScores result;
  for (const PoseScore& pose : scores) {
    result.push_back({pose.unknowns(Eigen::all, which), pose.deflections(Eigen::all, which)});
  }
  return result;
}

} // namespace

const std::vector<double>& poseLevels() {
  static const std::vector<double> levels = [] {
    std::vector<double> result{0};
    for (double level = radians(0.004); level < radians(1.5); level *= 1.7) {
      result.push_back(level);
    }
    return result;
  }();
  return levels;
}

LevelTests::LevelTests(const ScoreProblem& problem, const Noise& noise, const std::vector<double>& levels)
    : tests_(levels.size()) {
  alone_.reserve(levels.size());
  for (double level : levels) {
    Noise there = noise;
    there.pose = level;
    alone_.emplace_back(problem, there);
  }
}

const ScoreTests& LevelTests::operator[](std::size_t level) {
  if (!tests_[level]) {
    tests_[level].emplace(alone_[level]);
  }
  return *tests_[level];
}

std::size_t LevelTests::placeOf(double level) const {
  const auto found =
      std::find_if(alone_.begin(), alone_.end(), [&](const ModelAlone& tried) { return tried.noise().pose >= level; });
  return static_cast<std::size_t>(found - alone_.begin());
}

NullFit LevelTests::nullOf(const PoseScores& scores, const Eigen::VectorXd& priorScore) const {
  NullFit result;
  for (std::size_t level = 0; level < alone_.size(); ++level) {
    const Eigen::RowVectorXd& here = result.outcomes.emplace_back(alone_[level](scores, priorScore)).deviance;
    if (level == 0) {
      result.deviance = here;
      result.level.assign(static_cast<std::size_t>(here.size()), 0);
    }
    for (Eigen::Index i = 0; i < here.size(); ++i) {
      if (here[i] < result.deviance[i]) {
        result.deviance[i] = here[i];
        result.level[static_cast<std::size_t>(i)] = level;
      }
    }
  }
  return result;
}

Eigen::MatrixXd LevelTests::ratios(const PoseScores& scores, const NullFit& null) {
  const std::size_t groups = alone_.front().problem().groups.size();
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(at(groups), null.deviance.size());
  const std::size_t highest = *std::max_element(null.level.begin(), null.level.end());
  for (std::size_t level = 0; level <= highest; ++level) {
    std::vector<Eigen::Index> which;
    for (Eigen::Index i = 0; i < null.deviance.size(); ++i) {
      if (null.level[static_cast<std::size_t>(i)] >= level) {
        which.push_back(i);
      }
    }
    const ModelAlone::Outcome& outcome = null.outcomes[level];
    const Eigen::MatrixXd falls = (*this)[level].falls(columns(scores, which), outcome.own(Eigen::all, which));
    for (std::size_t i = 0; i < which.size(); ++i) {
      const double worse = outcome.deviance[which[i]] - null.deviance[which[i]];
      result.col(which[i]) = result.col(which[i]).cwiseMax((falls.col(at(i)).array() - worse).matrix());
    }
  }
  return result;
}

} // namespace naocal

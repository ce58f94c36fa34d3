#include "diagnose/LevelTests.hpp"

#include "geometry/Angles.hpp"
#include "geometry/InParallel.hpp"
#include "geometry/Index.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>

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

std::vector<double> poseLevels(const ScoreProblem& problem, const Noise& noise, const PoseScores& measured) {
  constexpr double step = 1.7;
  std::vector<double> levels{0};
  for (double level = radians(0.004); level < radians(1.5); level *= step) {
    levels.push_back(level);
  }
  const Eigen::VectorXd priorScore = problem.priorScore();
  const double coarse = levels[LevelTests{problem, noise, levels}.nullOf(measured, priorScore).level.front()];
  const auto deviance = [&](double logarithm) {
    Noise there = noise;
    there.pose = coarse * std::exp(logarithm);
    return ModelAlone{problem, there}(measured, priorScore).deviance[0];
  };
  std::uintmax_t tries = 8;
  const double reach = std::log(step);
  const double shift = coarse > 0 ? boost::math::tools::brent_find_minima(deviance, -reach, reach, 6, tries).first : 0;
  for (double& level : levels) {
    level *= std::exp(shift);
  }
  return levels;
}

LevelTests::LevelTests(const ScoreProblem& problem, const Noise& noise, const std::vector<double>& levels)
    : alone_(levels.size()), tests_(levels.size()) {
  inParallel(levels.size(), [&](std::size_t level) {
    Noise there = noise;
    there.pose = levels[level];
    alone_[level].emplace(problem, there);
  });
}

const ScoreTests& LevelTests::operator[](std::size_t level) {
  if (!tests_[level]) {
    tests_[level].emplace(*alone_[level]);
  }
  return *tests_[level];
}

std::size_t LevelTests::placeOf(double level) const {
  const auto found =
      std::find_if(alone_.begin(), alone_.end(), [&](const auto& tried) { return tried->noise().pose >= level; });
  return static_cast<std::size_t>(found - alone_.begin());
}

NullFit LevelTests::nullOf(const PoseScores& scores, const Eigen::VectorXd& priorScore) const {
  NullFit result;
  result.outcomes.resize(alone_.size());
  inParallel(alone_.size(), [&](std::size_t level) { result.outcomes[level] = (*alone_[level])(scores, priorScore); });
  result.deviance = result.outcomes.front().deviance;
  result.level.assign(static_cast<std::size_t>(result.deviance.size()), 0);
  for (std::size_t level = 1; level < alone_.size(); ++level) {
    const Eigen::RowVectorXd& here = result.outcomes[level].deviance;
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
  const std::size_t levels = 1 + *std::max_element(null.level.begin(), null.level.end());
  std::vector<std::vector<Eigen::Index>> which(levels); // of the scores, whose null is at this level or above
  std::vector<Eigen::MatrixXd> falls(levels);
  inParallel(levels, [&](std::size_t level) {
    for (Eigen::Index i = 0; i < null.deviance.size(); ++i) {
      if (null.level[static_cast<std::size_t>(i)] >= level) {
        which[level].push_back(i);
      }
    }
    falls[level] =
        (*this)[level].falls(columns(scores, which[level]), null.outcomes[level].own(Eigen::all, which[level]));
  });
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(falls.front().rows(), null.deviance.size());
  for (std::size_t level = 0; level < levels; ++level) {
    for (std::size_t i = 0; i < which[level].size(); ++i) {
      const Eigen::Index score = which[level][i];
      const double worse = null.outcomes[level].deviance[score] - null.deviance[score];
      result.col(score) = result.col(score).cwiseMax((falls[level].col(at(i)).array() - worse).matrix());
    }
  }
  return result;
}

} // namespace naocal

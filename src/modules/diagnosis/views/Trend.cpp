#include "diagnosis/views/Trend.hpp"

#include "inference/DriverBasis.hpp"
#include "math/LinearAlgebra.hpp"
#include "math/Parallel.hpp"
#include "math/Statistics.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <boost/random/bernoulli_distribution.hpp>
#include <boost/random/mersenne_twister.hpp>
#include <cmath>
#include <map>
#include <numeric>

namespace naocal {

namespace {

constexpr std::size_t fewestBlocks = 6; // fewer allow too few sign combinations
constexpr Eigen::Index mostDegree = 3;
constexpr double decides = 0.5;  // a block's share of the information on any coefficient, above which it dominates
constexpr std::size_t steps = 5; // a driver with at most this many values has one step per value
constexpr double apart = 0.02;   // share of the driver's range; closer values count as equal

/// Constant and Legendre polynomials up to a degree.
Eigen::VectorXd basis(double r, Eigen::Index degree) {
  Eigen::VectorXd result(degree + 1);
  result[0] = 1;
  result.tail(degree) = legendre(r, degree).transpose();
  return result;
}

/// Step index of the driver per sample; empty if it has many values.
std::vector<double> findSteps(const std::vector<TrendSample>& samples, const std::vector<std::size_t>& order) {
  const double gap = apart * (samples[order.back()].x - samples[order.front()].x);
  std::vector<double> result(samples.size());
  std::size_t step = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    step += samples[order[i]].x - samples[order[i - 1]].x > gap;
    result[order[i]] = static_cast<double>(step);
  }
  return step > 0 && step < steps ? result : std::vector<double>{};
}

/// Weighted rank of each sample, -1..1; ties share theirs.
std::vector<double> ranksOf(const std::vector<TrendSample>& samples) {
  std::vector<std::size_t> order(samples.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return samples[a].x < samples[b].x; });
  std::vector<double> values = findSteps(samples, order);
  if (values.empty()) {
    for (const TrendSample& sample : samples) {
      values.push_back(sample.x);
    }
  }
  const double all = std::accumulate(samples.begin(), samples.end(), 0.0,
                                     [](double sum, const TrendSample& sample) { return sum + sample.weight; });
  std::vector<double> ranks(samples.size());
  double before = 0;
  for (std::size_t i = 0; i < order.size();) {
    std::size_t end = i;
    double here = 0;
    for (; end < order.size() && values[order[end]] == values[order[i]]; ++end) {
      here += samples[order[end]].weight;
    }
    for (; i < end; ++i) {
      ranks[order[i]] = 2 * (before + here / 2) / all - 1;
    }
    before += here;
  }
  return ranks;
}

} // namespace

Trend::Trend(const std::vector<TrendSample>& samples) {
  double weights = 0;
  for (const TrendSample& sample : samples) {
    weights += sample.weight;
    mean_ += sample.weight * sample.y;
  }
  if (!(weights > 0)) {
    return;
  }
  mean_ /= weights;
  ranks_ = ranksOf(samples);
  std::vector<double> distinct = ranks_;
  std::sort(distinct.begin(), distinct.end());
  values_ = static_cast<std::size_t>(std::unique(distinct.begin(), distinct.end()) - distinct.begin());
  for (Eigen::Index degree = std::min(mostDegree, eigenIndex(values_) - 1); degree > 0; --degree) {
    if (prepare(samples, degree)) {
      degree_ = degree;
      return;
    }
  }
}

/// False if a block dominates or there are too few.
bool Trend::prepare(const std::vector<TrendSample>& samples, Eigen::Index degree) {
  std::map<std::size_t, Block> byNumber;
  gram_ = Square::Zero(degree + 1, degree + 1);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    Block& block = byNumber[samples[i].block];
    if (block.gram.size() == 0) {
      block.gram = Square::Zero(degree + 1, degree + 1);
      block.moment = Few::Zero(degree + 1);
    }
    const Few b = basis(ranks_[i], degree);
    block.gram += samples[i].weight * b * b.transpose();
    block.moment += samples[i].weight * (samples[i].y - mean_) * b;
  }
  blocks_.clear();
  for (auto& [number, block] : byNumber) {
    block.number = number;
    gram_ += block.gram;
    blocks_.push_back(block);
  }
  const Eigen::LLT<Square> factor{gram_};
  if (blocks_.size() < std::max(fewestBlocks, static_cast<std::size_t>(degree) + 3) ||
      factor.info() != Eigen::Success) {
    return false;
  }
  inverse_ = factor.solve(Square::Identity(degree + 1, degree + 1));
  for (Block& block : blocks_) {
    const Square half = factor.matrixL().solve(block.gram);
    const Square share = factor.matrixL().solve(Square{half.transpose()});
    const Eigen::SelfAdjointEigenSolver<Square> eigen{share, Eigen::EigenvaluesOnly};
    if (!(eigen.eigenvalues().maxCoeff() < decides)) {
      return false;
    }
    block.inverseWithout = Square{gram_ - block.gram}.inverse();
  }
  return true;
}

Trend::Fitted Trend::fitSigned(const Eigen::VectorXd& signs) const {
  const Eigen::Index count = gram_.rows() - 1;
  Few moment = Few::Zero(count + 1);
  for (const Block& block : blocks_) {
    moment += signs[eigenIndex(block.number)] * block.moment;
  }
  Fitted result{(inverse_ * moment).tail(count), Square::Zero(count, count)};
  for (const Block& block : blocks_) {
    const Few without = block.inverseWithout * (moment - signs[eigenIndex(block.number)] * block.moment);
    const Few moved = without.tail(count) - result.coefficients;
    result.variance += moved * moved.transpose();
  }
  const auto n = static_cast<double>(blocks_.size());
  result.variance *= (n - 1) / n;
  return result;
}

double Trend::pValueOf(const Eigen::VectorXd& signs) const {
  if (!isTestable()) {
    return 1;
  }
  const Fitted here = fitSigned(signs);
  const double smallest = 1e-12 * here.coefficients.squaredNorm() + 1e-300; // for values without scatter
  const Square variance = here.variance + smallest * Square::Identity(degree_, degree_);
  const auto d = static_cast<double>(degree_), n = static_cast<double>(blocks_.size());
  const double f = here.coefficients.dot(Few{variance.ldlt().solve(here.coefficients)}) / d;
  return std::isfinite(f) ? fTail(std::max(0.0, f), d, n - 1 - d) : 1;
}

std::vector<double> Trend::curve() const {
  const Few coefficients = fitSigned(Eigen::VectorXd::Ones(eigenIndex(mostBlocks))).coefficients;
  std::vector<double> result;
  const Few middle = gram_.col(0).tail(degree_) / gram_(0, 0); // mean of the polynomials
  for (const double rank : ranks_) {
    const Few b = basis(rank, degree_).tail(degree_);
    result.push_back(coefficients.dot(b - middle));
  }
  return result;
}

double Trend::chanceShare() const {
  const Fitted here = fitSigned(Eigen::VectorXd::Ones(eigenIndex(mostBlocks)));
  const Few middle = gram_.col(0).tail(degree_);
  const Square spread = gram_.bottomRightCorner(degree_, degree_) - middle * middle.transpose() / gram_(0, 0);
  const double all = here.coefficients.dot(spread * here.coefficients);
  return all > 0 ? std::min(1.0, (spread * here.variance).trace() / all) : 1;
}

std::vector<double> computeFamilyWiseChances(const std::vector<Trend>& trends, Eigen::Index draws, std::uint64_t seed) {
  boost::random::mt19937_64 random{seed};
  boost::random::bernoulli_distribution<double> heads;
  const Eigen::MatrixXd signs =
      Eigen::MatrixXd::NullaryExpr(eigenIndex(Trend::mostBlocks), draws, [&] { return heads(random) ? 1.0 : -1.0; });
  Eigen::MatrixXd drawn(draws, eigenIndex(trends.size()));
  std::vector<double> found(trends.size());
  parallelFor(trends.size(), [&](std::size_t i) {
    found[i] = trends[i].pValue();
    for (Eigen::Index draw = 0; draw < draws; ++draw) {
      drawn(draw, eigenIndex(i)) = trends[i].pValueOf(signs.col(draw));
    }
  });
  const Eigen::VectorXd clearest = trends.empty() ? Eigen::VectorXd{} : Eigen::VectorXd{drawn.rowwise().minCoeff()};
  std::vector<double> result;
  for (std::size_t i = 0; i < trends.size(); ++i) {
    const auto asClear = (clearest.array() <= found[i]).count();
    result.push_back(trends[i].isTestable() ? static_cast<double>(1 + asClear) / static_cast<double>(1 + draws) : 1);
  }
  return result;
}

} // namespace naocal

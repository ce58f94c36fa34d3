#include "evaluate/ThesisTrial.hpp"

#include "evaluate/GlobalSearch.hpp"
#include "evaluate/NumericPixels.hpp"
#include "geometry/Index.hpp"
#include "solve/LevenbergMarquardt.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace naocal {

namespace {

const double mostError = radians(6.5), leastError = radians(1); // of offsets [rad]

/// Flat over the search: ten radians of freedom per offset.
constexpr double noPrior = 10;
constexpr Noise onePixel{.pixel = 1, .encoder = 0, .pose = 0};

double numbersOf(const Residuals::Linear& linear) {
  double sum = 0;
  for (const PoseSystem& pose : linear.poses) {
    sum += pose.numbers;
  }
  return sum;
}

} // namespace

/// Where a search ended.
struct ThesisTrial::Search {
  bool ended = false; // by itself, in a possible state
  Eigen::VectorXd offsets;
  double cost = std::numeric_limits<double>::infinity();
  double sigma = 0; // the largest of an offset, where costs are halves of chi2
  bool better(const Search& other) const { return ended && (!other.ended || cost < other.cost); }
};

ThesisStatus ThesisAnswer::status(double tolerance) const {
  return !solved                                    ? ThesisStatus::solverFailure
         : rms > rmsTolerance                       ? ThesisStatus::noConvergence
         : errors.cwiseAbs().maxCoeff() > tolerance ? ThesisStatus::localMinimum
                                                    : ThesisStatus::success;
}

ThesisTrial::ThesisTrial(const ThesisStage& stage, const ThesisSetting& setting, double pixel)
    : stage_{stage}, setting_{setting}, noise_{thesisNoise(setting, pixel)}, plainModel_{offsetModel(stage, noPrior)},
      ourModel_{offsetModel(stage, jointOffset().unknowns.front().sigma)}, taken_{stage.everything()} {}

void ThesisTrial::draw(std::uint64_t seed, std::size_t number) {
  const std::string set = fmt::format("thesis set {}", number);
  Randomness errors{seed, set}, measuring{seed, set + ", measured"};
  offsets_.resize(at(stage_.joints().size()));
  for (double& offset : offsets_) {
    do {
      offset = errors.within(mostError);
    } while (setting_.largeErrors && std::abs(offset) < leastError);
  }
  const double pixel = setting_.pixelNoise() ? noise_.pixel : 0;
  stage_.take(
      offsets_, [&](double angle) { return angleReading(angle, setting_, measuring); }, pixel, measuring, taken_);
  pixels_.emplace(taken_, plainModel_, onePixel);
  whitened_.emplace(taken_, ourModel_, noise_);
  const auto atTruth = pixels_->linearised(pixels_->start(offsets_)).value(); // what is seen lies before the camera
  numbers_ = numbersOf(atTruth);
  rmsAtTruth_ = std::sqrt(2 * atTruth.cost / numbers_);
  starts_.emplace(seed, set + ", starts");
  limits_.emplace(seed, set + ", limit");
}

Eigen::VectorXd ThesisTrial::randomStart() {
  Eigen::VectorXd start{offsets_.size()};
  for (double& offset : start) {
    offset = starts_->within(mostError);
  }
  return start;
}

template <typename Problem>
ThesisTrial::Search ThesisTrial::search(const Problem& problem, const Residuals::State& start) {
  constexpr double smallestFall = 1e-6; // a thousandth of the noise, or of a pixel
  auto minimum = levenbergMarquardt(problem, start, {.smallestFall = smallestFall});
  if (!minimum) {
    return {};
  }
  const auto count = minimum->linear.hessian.rows();
  const Eigen::MatrixXd covariance = minimum->linear.hessian.llt().solve(Eigen::MatrixXd::Identity(count, count));
  return {minimum->converged, std::move(minimum->state.unknowns), minimum->linear.cost,
          std::sqrt(covariance.diagonal().maxCoeff())};
}

/// The best of searches from zero and at random, until three have ended in it; at most fifty (the thesis's number).
ThesisTrial::Search ThesisTrial::fromRandomStarts() {
  constexpr int most = 50, enough = 3;
  Search best = search(*pixels_, pixels_->start(zero()));
  for (int tries = 1, same = best.ended ? 1 : 0; tries < most && same < enough; ++tries) {
    Search next = search(*pixels_, pixels_->start(randomStart()));
    if (next.ended && std::abs(next.cost - best.cost) <= 1e-6 * (1 + best.cost)) {
      ++same;
    } else if (next.better(best)) {
      best = std::move(next);
      same = 1;
    }
  }
  return best;
}

/// From zero; from random starts as well as long as what is left is more than the noise explains (five sigmas of chi2).
/// Where only pixels are noisy and the pictures alone tell every offset, the prior does not count in the end.
ThesisTrial::Search ThesisTrial::ours() {
  constexpr int most = 20;
  constexpr double needed = 0.01; // of an offset, whose prior has 0.1 [rad]
  Search best = search(*whitened_, whitened_->start(zero()));
  const double explained = 0.5 * (numbers_ + 5 * std::sqrt(2 * numbers_));
  for (int tries = 1; tries < most && !(best.ended && best.cost < explained); ++tries) {
    if (Search next = search(*whitened_, whitened_->start(randomStart())); next.better(best)) {
      best = std::move(next);
    }
  }
  if (!setting_.angleNoise() && best.ended && best.sigma < needed) {
    const Residuals flat{taken_, plainModel_, noise_};
    if (Search last = search(flat, flat.start(best.offsets)); last.ended) {
      return last;
    }
  }
  return best;
}

/// Costs of a swarm's or dlib's search: as many as these can do in about a second.
ThesisTrial::Search ThesisTrial::byCostsOnly(ThesisSolver solver) {
  constexpr std::size_t swarmCalls = 40'000, dlibCalls = 500;
  const Cost cost = [this](const Eigen::VectorXd& offsets) {
    const auto there = pixels_->linearised(pixels_->start(offsets));
    return there ? there->cost : std::numeric_limits<double>::infinity();
  };
  Search result{true, solver == ThesisSolver::dlib
                          ? dlibMinimum(cost, offsets_.size(), mostError, dlibCalls)
                          : swarmMinimum(cost, offsets_.size(), mostError, swarmCalls, starts_->below(1u << 31))};
  result.cost = cost(result.offsets);
  return result;
}

ThesisTrial::Search ThesisTrial::found(ThesisSolver solver) {
  switch (solver) {
  case ThesisSolver::plain:
    break;
  case ThesisSolver::randomStarts:
    return fromRandomStarts();
  case ThesisSolver::ours:
    return ours();
  case ThesisSolver::numeric:
    return search(NumericPixels{*pixels_}, pixels_->start(zero()));
  case ThesisSolver::dlib:
  case ThesisSolver::swarm:
    return byCostsOnly(solver);
  }
  return search(*pixels_, pixels_->start(zero()));
}

ThesisAnswer ThesisTrial::answer(ThesisSolver solver) {
  const Search found = this->found(solver);
  const auto there = found.ended ? pixels_->linearised(pixels_->start(found.offsets)) : std::nullopt;
  if (!there) {
    return {};
  }
  return {true, std::sqrt(2 * there->cost / numbers_), 2 * rmsAtTruth_ + 1, found.offsets - offsets_};
}

std::vector<double> ThesisTrial::limit(std::size_t draws) {
  std::vector<double> result(draws, 0);
  if (setting_.noise == ThesisNoise::none) {
    return result;
  }
  const Eigen::LLT<Eigen::MatrixXd> root{whitened_->linearised(whitened_->start(offsets_)).value().hessian};
  for (double& largest : result) {
    Eigen::VectorXd error{offsets_.size()};
    for (double& number : error) {
      number = limits_->normal(1);
    }
    largest = root.matrixU().solve(error).cwiseAbs().maxCoeff();
  }
  return result;
}

} // namespace naocal

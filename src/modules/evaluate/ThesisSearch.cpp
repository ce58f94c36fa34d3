#include "evaluate/ThesisSearch.hpp"

#include "evaluate/GlobalSearch.hpp"
#include "evaluate/NumericPixels.hpp"
#include "math/LevenbergMarquardt.hpp"

#include <algorithm>
#include <cmath>

namespace naocal {

Eigen::VectorXd ThesisSearch::randomStart() {
  Eigen::VectorXd start = zero();
  for (double& offset : start.head(offsets_)) {
    offset = starts_.within(largestOffset);
  }
  return start;
}

template <typename Problem>
ThesisFound ThesisSearch::search(const Problem& problem, const Residuals::State& start) const {
  constexpr double smallestFall = 1e-6; // a thousandth of the noise, or of a pixel
  auto minimum = levenbergMarquardt(problem, start, {.smallestFall = smallestFall});
  if (!minimum) {
    return {};
  }
  const auto count = minimum->linear.hessian.rows();
  const Eigen::MatrixXd covariance = minimum->linear.hessian.llt().solve(Eigen::MatrixXd::Identity(count, count));
  return {minimum->converged, std::move(minimum->state.unknowns), minimum->linear.cost,
          std::sqrt(covariance.diagonal().head(offsets_).maxCoeff())};
}

/// The best of searches from zero and at random, until three have ended in it; at most fifty (the thesis's number).
ThesisFound ThesisSearch::fromRandomStarts() {
  constexpr int most = 50, enough = 3;
  ThesisFound best = search(pixels_, pixels_.start(zero()));
  for (int tries = 1, same = best.ended ? 1 : 0; tries < most && same < enough; ++tries) {
    ThesisFound next = search(pixels_, pixels_.start(randomStart()));
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
ThesisFound ThesisSearch::ours() {
  constexpr int most = 20;
  constexpr double needed = 0.01; // of an offset, whose prior has 0.1 [rad]
  ThesisFound best = search(whitened_, whitened_.start(zero()));
  const double explained = 0.5 * (numbers_ + 5 * std::sqrt(2 * numbers_));
  for (int tries = 1; tries < most && !(best.ended && best.cost < explained); ++tries) {
    if (ThesisFound next = search(whitened_, whitened_.start(randomStart())); next.better(best)) {
      best = std::move(next);
    }
  }
  if (flat_ && best.ended && best.sigma < needed) {
    if (ThesisFound last = search(*flat_, flat_->start(best.unknowns)); last.ended) {
      return last;
    }
  }
  return best;
}

/// Costs of a swarm's or dlib's search: as many as these can do in about a second.
ThesisFound ThesisSearch::byCostsOnly(ThesisSolver solver) {
  constexpr std::size_t swarmCalls = 40'000, dlibCalls = 500;
  const Cost cost = [this](const Eigen::VectorXd& unknowns) {
    const auto there = pixels_.linearised(pixels_.start(unknowns));
    return there ? there->cost : std::numeric_limits<double>::infinity();
  };
  ThesisFound result{true, solver == ThesisSolver::dlib
                               ? dlibMinimum(cost, offsets_, largestOffset, dlibCalls)
                               : swarmMinimum(cost, offsets_, largestOffset, swarmCalls, starts_.below(1u << 31))};
  result.cost = cost(result.unknowns);
  return result;
}

ThesisFound ThesisSearch::found(ThesisSolver solver) {
  switch (solver) {
  case ThesisSolver::plain:
    break;
  case ThesisSolver::randomStarts:
    return fromRandomStarts();
  case ThesisSolver::ours:
    return ours();
  case ThesisSolver::numeric:
    return search(NumericPixels{pixels_}, pixels_.start(zero()));
  case ThesisSolver::dlib:
  case ThesisSolver::swarm:
    return byCostsOnly(solver);
  }
  return search(pixels_, pixels_.start(zero()));
}

} // namespace naocal

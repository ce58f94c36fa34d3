#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace naocal {

struct LevenbergMarquardtOptions {
  int maxIterations = 300;
  double initialDamping = 1e-3; // in units of 1 / scale^2
  double minCostDecrease =
      1e-9; // stop when the quadratic model predicts a smaller fall of the cost [1 = half a chi2 unit]
  double stalledDecrease =
      1e-3; // a fall over the last ten iterations below which a search that could not go on has arrived
};

/// Where the search ended.
template <typename State, typename Linear> struct Minimum {
  State state;
  Linear linear; // cost, gradient and Hessian there
  int iterations = 0;
  bool converged = false;
};

/// Levenberg-Marquardt with Nielsen's damping (Madsen, Nielsen, Tingleff: Methods for non-linear least squares
/// problems, 2nd ed. 2004, algorithm 3.16), damping scaled by the Hessian's diagonal.
///
/// A problem knows its state and offers
///   struct Linear                                      with .cost, .gradient, .hessian (J^T J)
///   bool linearise(const State&, Linear&)              false: that state is impossible
///   State moved(const State&, const Linear&, const Eigen::VectorXd& step)
///   const Eigen::VectorXd& scales()                    how far each number plausibly moves
/// `linearise` gets one of two `Linear`s, filled before by itself or empty, so that it may use their memory again.
/// Where the cost has a kink or a narrow bent valley (a gear's gap), steps never bring what is predicted: such a search
/// has converged when it hardly fell any more.
/// An impossible state is never rewarded: the step that led there is refused. Absent: already the start is impossible.
template <typename Problem, typename State>
auto levenbergMarquardt(const Problem& problem, State start, const LevenbergMarquardtOptions& options = {})
    -> std::optional<Minimum<State, typename Problem::Linear>> {
  Minimum<State, typename Problem::Linear> minimum{std::move(start), {}};
  if (!problem.linearise(minimum.state, minimum.linear)) {
    return std::nullopt;
  }
  typename Problem::Linear there;
  double damping = options.initialDamping, growth = 2;
  bool arrived = false; // by a step, not by the start
  std::vector<double> costs;
  while (minimum.iterations < options.maxIterations && !minimum.converged) {
    ++minimum.iterations;
    const auto& here = minimum.linear;
    Eigen::MatrixXd damped = here.hessian;
    damped.diagonal() += damping * problem.scales().cwiseAbs2().cwiseInverse();
    const Eigen::VectorXd step = damped.ldlt().solve(-here.gradient);
    const double predictedFall = -step.dot(here.gradient) - 0.5 * step.dot(here.hessian * step);
    if (!std::isfinite(predictedFall)) {
      return minimum;
    }
    costs.push_back(here.cost);
    // A step whose predicted fall is nothing, or drowns in the cost's rounding, ends the search, taken or not.
    minimum.converged = predictedFall < options.minCostDecrease + 1e-12 * here.cost && damping < 1e3;
    if (minimum.converged && arrived) {
      break;
    }
    State candidate = problem.applyStep(minimum.state, here, step);
    const double fall = problem.linearise(candidate, there) ? here.cost - there.cost : -1;
    arrived = fall > 0;
    if (arrived) {
      const double gain = fall / std::max(predictedFall, 1e-300);
      damping *= std::max(1.0 / 3, 1 - std::pow(2 * gain - 1, 3));
      damping = std::max(damping, 1e-12);
      growth = 2;
      minimum.state = std::move(candidate);
      std::swap(minimum.linear, there);
    } else {
      damping *= growth;
      growth *= 2;
      if (damping > 1e16) {
        break;
      }
    }
  }
  constexpr std::size_t some = 10;
  minimum.converged |=
      costs.size() > some && costs[costs.size() - 1 - some] - minimum.linear.cost < options.stalledDecrease;
  return minimum;
}

} // namespace naocal

#pragma once

#include "math/Checkpoints.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace naocal {

struct LevenbergMarquardtOptions {
  int maxIterations = 300;
  double initialDamping = 1e-3; // in units of 1 / scale^2
  double minCostDecrease =
      1e-9; // stops when the quadratic model predicts a smaller decrease of the cost [1 = half a chi2 unit]
  double stalledDecrease =
      1e-3; // a stalled search counts as converged if the last ten iterations decreased the cost by less
};

/// A problem at one of its states, without further sums: the usual `Linear`.
struct DenseLinear {
  double cost = 0; // half the sum of the squared residuals
  Eigen::VectorXd gradient;
  Eigen::MatrixXd hessian;
};

/// End of the search.
template <typename State, typename Linear> struct Minimum {
  State state;
  Linear linear; // cost, gradient and Hessian at `state`
  int iterations = 0;
  bool converged = false;
};

/// Levenberg-Marquardt with Nielsen's damping (Madsen, Nielsen, Tingleff: Methods for non-linear least squares
/// problems, 2nd ed. 2004, algorithm 3.16), damping scaled by the Hessian's diagonal.
///
/// A problem has a state type and provides
///   struct Linear                                      with .cost, .gradient, .hessian (J^T J): DenseLinear or more
///   bool linearize(State&, Linear&)                    false: the state is infeasible
///   State applyStep(const State&, const Linear&, const Eigen::VectorXd& step)
///   const Eigen::VectorXd& scales()                    plausible change of each unknown
/// `linearize` receives one of two `Linear`s, empty or filled by an earlier call, whose memory it may reuse.
/// If the cost has a kink or a narrow curved valley (a gear's gap), steps never achieve the predicted decrease; such a
/// search counts as converged once its cost hardly decreases.
/// Refuses steps to infeasible states. Absent if the start is infeasible. Every iteration is a checkpoint
/// (math/Checkpoints.hpp).
template <typename Problem, typename State>
auto levenbergMarquardt(const Problem& problem, State start, const LevenbergMarquardtOptions& options = {})
    -> std::optional<Minimum<State, typename Problem::Linear>> {
  Minimum<State, typename Problem::Linear> minimum{std::move(start), {}};
  if (!problem.linearize(minimum.state, minimum.linear)) {
    return std::nullopt;
  }
  typename Problem::Linear there;
  double damping = options.initialDamping, growth = 2;
  bool arrived = false; // by a step, not just at the start
  std::vector<double> costs;
  while (minimum.iterations < options.maxIterations && !minimum.converged) {
    Checkpoints::reach();
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
    // A predicted decrease below the tolerance or the rounding of the cost ends the search, whether the step is taken
    // or not.
    minimum.converged = predictedFall < options.minCostDecrease + 1e-12 * here.cost && damping < 1e3;
    if (minimum.converged && arrived) {
      break;
    }
    State candidate = problem.applyStep(minimum.state, here, step);
    const double fall = problem.linearize(candidate, there) ? here.cost - there.cost : -1;
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

#include "math/LevenbergMarquardt.hpp"

#include <catch2/catch.hpp>

namespace naocal {
namespace {

/// Rosenbrock's function as a sum of squares: r = (10 (y - x^2), 1 - x); infeasible for x < -1.5.
struct Valley {
  using Linear = DenseLinear;
  bool linearize(const Eigen::VectorXd& p, Linear& linear) const {
    if (p[0] < -1.5) {
      return false;
    }
    const Eigen::Vector2d r{10 * (p[1] - p[0] * p[0]), 1 - p[0]};
    const Eigen::Matrix2d j = (Eigen::Matrix2d{} << -20 * p[0], 10, -1, 0).finished();
    linear = {0.5 * r.squaredNorm(), j.transpose() * r, j.transpose() * j};
    return true;
  }
  Eigen::VectorXd applyStep(const Eigen::VectorXd& p, const Linear&, const Eigen::VectorXd& step) const {
    return p + step;
  }
  const Eigen::VectorXd& scales() const { return scale; }
  Eigen::VectorXd scale = Eigen::Vector2d{1, 1};
};

/// r = (sqrt |y - x^2| + 1, (x - 1) / 1000): a kink along y = x^2, where the gradient does not indicate the direction.
struct Fold : Valley {
  bool linearize(const Eigen::VectorXd& p, Linear& linear) const {
    const double side = p[1] < p[0] * p[0] ? -1 : 1;
    const Eigen::Vector2d r{std::sqrt(std::abs(p[1] - p[0] * p[0])) + 1, 1e-3 * (p[0] - 1)};
    const double slope = side / (2 * std::max(1e-9, r[0] - 1));
    const Eigen::Matrix2d j = (Eigen::Matrix2d{} << -2 * p[0] * slope, slope, 1e-3, 0).finished();
    linear = {0.5 * r.squaredNorm(), j.transpose() * r, j.transpose() * j};
    return true;
  }
};

} // namespace

TEST_CASE("the search finds the bottom of a curved valley") {
  // Proves convergence on Rosenbrock's function from its standard start.
  const auto minimum = levenbergMarquardt(Valley{}, Eigen::VectorXd{Eigen::Vector2d{-1.2, 1}});
  REQUIRE(minimum);
  CHECK(minimum->converged);
  CHECK((minimum->state - Eigen::Vector2d{1, 1}).norm() < 1e-4);
}

TEST_CASE("a search that is stuck at a kink has arrived") {
  // Proves that a minimum at a kink, without zero gradient, is reported as converged, and that it is on the kink.
  const auto minimum = levenbergMarquardt(Fold{}, Eigen::VectorXd{Eigen::Vector2d{0.5, 1}});
  REQUIRE(minimum);
  CHECK(minimum->converged);
  CHECK(std::abs(minimum->state[1] - minimum->state[0] * minimum->state[0]) < 1e-3);
}

TEST_CASE("an impossible start is absent and an impossible step is refused") {
  // Proves that an infeasible start gives no result, and that infeasible steps are rejected.
  CHECK_FALSE(levenbergMarquardt(Valley{}, Eigen::VectorXd{Eigen::Vector2d{-2, 1}}));
  const auto minimum = levenbergMarquardt(Valley{}, Eigen::VectorXd{Eigen::Vector2d{-1.4999, 30}});
  REQUIRE(minimum);
  CHECK(minimum->state[0] >= -1.5);
  CHECK(minimum->converged);
}

TEST_CASE("too few iterations are not called converged") {
  // Proves the flag that a result's usability depends on.
  const auto minimum = levenbergMarquardt(Valley{}, Eigen::VectorXd{Eigen::Vector2d{-1.2, 1}}, {.maxIterations = 3});
  REQUIRE(minimum);
  CHECK_FALSE(minimum->converged);
}

} // namespace naocal

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>

namespace naocal {

/// A cost to minimise; infinite for impossible arguments.
using CostFunction = std::function<double(const Eigen::VectorXd&)>;

/// dlib's find_min_global (Malherbe and Vayatis 2017, with a trust region): the best point after `calls` evaluations,
/// each unknown within +-`range`.
Eigen::VectorXd minimizeWithDlib(const CostFunction& cost, Eigen::Index unknowns, double range, std::size_t calls);

/// pagmo's particle swarm: 40 particles with default weights, initialised by `seed`; about `calls` evaluations, each
/// unknown within +-`range`.
Eigen::VectorXd minimizeWithSwarm(const CostFunction& cost, Eigen::Index unknowns, double range, std::size_t calls,
                                  std::uint64_t seed);

} // namespace naocal

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>

namespace naocal {

/// To be made small; infinite where it is impossible.
using CostFunction = std::function<double(const Eigen::VectorXd&)>;

/// dlib's find_min_global (Malherbe and Vayatis 2017, with a trust region): where it is after that many `calls`, each
/// unknown within +-`range`.
Eigen::VectorXd minimizeWithDlib(const CostFunction& cost, Eigen::Index unknowns, double range, std::size_t calls);

/// pagmo's particle swarm: 40 particles with its usual weights, from places drawn by the `seed`; about `calls` costs.
Eigen::VectorXd minimizeWithSwarm(const CostFunction& cost, Eigen::Index unknowns, double range, std::size_t calls,
                                  std::uint64_t seed);

} // namespace naocal

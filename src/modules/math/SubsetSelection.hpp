#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <vector>

namespace naocal {

/// Objective to minimise, as a function of the summed information.
using Objective = std::function<double(const Eigen::MatrixXd& sum)>;

/// Selects `count` (at most all) distinct candidates greedily: each step adds the one with the lowest objective
/// together with `known` and the earlier ones. Returns indices in order of selection.
std::vector<std::size_t> selectGreedily(const Objective& judge, Eigen::MatrixXd known,
                                        const std::vector<Eigen::MatrixXd>& candidates, std::size_t count);

/// Exchanges chosen candidates for others as long as the objective improves (Fedorov 1972).
void improveByExchange(const Objective& judge, const Eigen::MatrixXd& known,
                       const std::vector<Eigen::MatrixXd>& candidates, std::vector<std::size_t>& chosen);

/// Greedy selection for the largest determinant, the smallest confidence volume (D-optimal).
std::vector<std::size_t> selectDOptimal(const Eigen::MatrixXd& prior, const std::vector<Eigen::MatrixXd>& candidates,
                                        std::size_t count);

} // namespace naocal

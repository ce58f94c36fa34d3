#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <vector>

namespace naocal {

/// The value to make small, by a sum of pieces of information.
using Objective = std::function<double(const Eigen::MatrixXd& sum)>;

/// Picks `count` (at most all) of the candidates, each once: greedily, always the one that with `known` and those
/// before it is judged best. Indices in the order of picking.
std::vector<std::size_t> selectGreedily(const Objective& judge, Eigen::MatrixXd known,
                                        const std::vector<Eigen::MatrixXd>& candidates, std::size_t count);

/// Exchanges one of the chosen for another candidate as long as that helps (Fedorov 1972).
void improveByExchange(const Objective& judge, const Eigen::MatrixXd& known,
                       const std::vector<Eigen::MatrixXd>& candidates, std::vector<std::size_t>& chosen);

/// Greedily the largest determinant, that is, the smallest volume of uncertainty (D-optimal).
std::vector<std::size_t> selectDOptimal(const Eigen::MatrixXd& prior, const std::vector<Eigen::MatrixXd>& candidates,
                                        std::size_t count);

} // namespace naocal

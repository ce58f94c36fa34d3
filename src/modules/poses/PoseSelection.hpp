#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace naocal {

/// Picks `count` (at most all) pieces of information greedily: each the one that, added to the prior and those before
/// it, has the largest determinant, that is, leaves the smallest volume of uncertainty (D-optimal). Indices in the
/// order of picking.
std::vector<std::size_t> mostInformative(const Eigen::MatrixXd& prior, const std::vector<Eigen::MatrixXd>& candidates,
                                         std::size_t count);

} // namespace naocal

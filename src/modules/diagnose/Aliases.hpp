#pragma once

#include "diagnose/Inquiry.hpp"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace naocal {

/// How alike candidates are in these captures.
struct AliasMatrix {
  std::vector<std::string> labels;
  Eigen::MatrixXd correlations; // `correlation` of each with each
};

/// Of the first `most` of those labels that are the inquiry's candidates and that its model does not absorb.
AliasMatrix aliasMatrix(const Inquiry& inquiry, const std::vector<std::string>& labels, std::size_t most);

} // namespace naocal

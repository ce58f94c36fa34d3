#pragma once

#include "diagnosis/evidence/CandidateTests.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

namespace naocal {

/// How alike candidates are in these captures.
struct AliasMatrix {
  std::vector<std::string> labels;
  Eigen::MatrixXd correlations; // `canonicalCorrelation` of each with each
};

/// Of the first `most` of those labels that are the inquiry's candidates and that its model does not absorb.
AliasMatrix computeAliasMatrix(const CandidateTests& inquiry, const std::vector<std::string>& labels, std::size_t most);

/// Largest canonical correlation of what two candidates would do to the pictures, everything in the model projected
/// out. `information`: of all candidates' columns, projected (`Evidence::information`).
double canonicalCorrelation(const Eigen::MatrixXd& information, const ColumnGroup& one, const ColumnGroup& other);

/// How much evidence lambda (as a likelihood ratio) tells two candidates apart in 19 of 20 cases:
/// lambda (1 - correlation) = 5.4.
double evidenceToSeparate(double correlation);

/// Candidates that these captures cannot tell from `chosen`: almost as likely, or so correlated that chance may have
/// put them behind: the evidence does not suffice to tell (`evidenceToSeparate`). What sizes are plausible counts,
/// unless the chosen one's is not. One that is evident and does something else to the pictures is there as well, and is
/// no other explanation of the same.
std::vector<std::size_t> findEquivalents(const CandidateTests& inquiry, std::size_t chosen);

} // namespace naocal

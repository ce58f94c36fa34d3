#pragma once

#include "calibration/CandidateTests.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

namespace naocal {

/// Similarity of candidates in these captures.
struct AliasMatrix {
  std::vector<std::string> labels;
  Eigen::MatrixXd correlations; // `canonicalCorrelation` of each pair
};

/// For the first `most` labels among the tested candidates that the model does not absorb.
AliasMatrix computeAliasMatrix(const CandidateTests& candidateTests, const std::vector<std::string>& labels,
                               std::size_t most);

/// Largest canonical correlation between the image displacements of two candidates, with the model projected out.
/// `information`: projected, of all candidates' columns (`Evidence::information`).
double canonicalCorrelation(const Eigen::MatrixXd& information, const ColumnGroup& one, const ColumnGroup& other);

/// Evidence lambda (likelihood ratio) required to separate two candidates in 19 of 20 cases: lambda (1 - correlation) =
/// 5.4.
double evidenceToSeparate(double correlation);

/// Candidates that these captures cannot distinguish from `chosen`: almost as likely, or so correlated that chance may
/// account for the gap (`evidenceToSeparate`). Prior sizes count, unless the chosen effect's size is implausible, or
/// the other has more unknowns, among them what the chosen one does: an axis that is tilted is a part of a link's
/// geometry. A significant candidate with a different signature is present in its own right and not an alternative.
std::vector<std::size_t> findEquivalents(const CandidateTests& candidateTests, std::size_t chosen);

} // namespace naocal

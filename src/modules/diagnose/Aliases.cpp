#include "diagnose/Aliases.hpp"

#include "diagnose/Alternatives.hpp"

#include <algorithm>

namespace naocal {

AliasMatrix aliasMatrix(const Inquiry& inquiry, const std::vector<std::string>& labels, std::size_t most) {
  AliasMatrix result;
  std::vector<ColumnGroup> groups;
  for (const std::string& label : labels) {
    const auto candidate = inquiry.find(label);
    if (candidate && inquiry.ofCandidate(*candidate).freedom > 0 && groups.size() < most) {
      result.labels.push_back(label);
      groups.push_back(inquiry.problem().groups[*candidate]);
    }
  }
  const auto count = static_cast<Eigen::Index>(groups.size());
  result.correlations.setIdentity(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      result.correlations(i, j) = result.correlations(j, i) = correlation(
          inquiry.evidence().information, groups[static_cast<std::size_t>(i)], groups[static_cast<std::size_t>(j)]);
    }
  }
  return result;
}

} // namespace naocal

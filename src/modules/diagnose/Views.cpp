#include "diagnose/Views.hpp"

namespace naocal {

void addViews(const std::vector<CaptureSet>& sets, const Measurements& measurements, const Model& asked,
              const Inquiry& first, Diagnosis& diagnosis) {
  constexpr std::size_t compared = 12, shown = 10;
  diagnosis.taken = takenIn(sets, measurements);
  std::vector<std::string> labels;
  std::vector<std::size_t> candidates;
  std::vector<CandidateFinding*> findings;
  for (CandidateFinding& finding : diagnosis.ranking) {
    labels.push_back(finding.term.label());
    if (const auto candidate = first.find(labels.back()); candidate && candidates.size() < shown) {
      candidates.push_back(*candidate);
      findings.push_back(&finding);
    }
  }
  diagnosis.aliases = aliasMatrix(first, labels, compared);
  std::vector<Imprint> looks = imprints(measurements, asked, diagnosis.fit, first, candidates);
  for (std::size_t i = 0; i < looks.size(); ++i) {
    findings[i]->imprint = std::move(looks[i]);
  }
}

} // namespace naocal

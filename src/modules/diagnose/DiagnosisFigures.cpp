#include "diagnose/DiagnosisFigures.hpp"

#include "evidence/Drivers.hpp"

namespace naocal {

namespace {

Figures::Left left(const std::vector<CaptureSet>& sets, const Measurements& measurements, const AskedModel& asked) {
  return {whatIfs(measurements, asked.inquiry), leftover(sets, measurements, asked.model, asked.fit),
          boardShapes(measurements, asked.model, asked.fit)};
}

} // namespace

void addFigures(const std::vector<CaptureSet>& sets, const Measurements& measurements, const AskedModel& given,
                const AskedModel& last, Diagnosis& diagnosis) {
  constexpr std::size_t compared = 12, shown = 10;
  diagnosis.figures.taken = takenIn(sets, measurements);
  std::vector<std::string> labels;
  std::vector<std::size_t> candidates;
  std::vector<CandidateFinding*> findings;
  for (CandidateFinding& finding : diagnosis.ranking) {
    labels.push_back(finding.term.label());
    if (const auto candidate = given.inquiry.find(labels.back()); candidate && candidates.size() < shown) {
      candidates.push_back(*candidate);
      findings.push_back(&finding);
    }
  }
  diagnosis.figures.aliases = aliasMatrix(given.inquiry, labels, compared);
  std::vector<Imprint> looks = imprints(measurements, given.model, given.fit, given.inquiry, candidates);
  for (std::size_t i = 0; i < looks.size(); ++i) {
    findings[i]->imprint = std::move(looks[i]);
  }
  diagnosis.figures.recorded = driversOf(measurements, given.model, given.fit.unknowns);
  diagnosis.figures.given = left(sets, measurements, given);
  if (!diagnosis.suggested.empty()) {
    diagnosis.figures.last = left(sets, measurements, last);
  }
}

} // namespace naocal

#include "diagnosis/Questioned.hpp"
#include "diagnosis/evidence/Aliasing.hpp"
#include "estimation/Model.hpp"
#include "estimation/ModelBuilder.hpp"

#include <catch2/catch.hpp>

namespace naocal {

TEST_CASE("a candidate that is like another keeps little once that one is in the model") {
  // Cross-checks the correlations: adding one candidate to the model reduces the other's information by the factor 1 -
  // correlation^2. All tests use one noise level, since information depends on it.
  const CaptureSet set = simulatedSet(8, 3);
  Questioned asked{set, false};
  asked.fit.noise.pose = 4e-4;
  asked.fit.state = Residuals{asked.measurements, asked.model, asked.fit.noise}.startState(asked.fit.unknowns);
  const CandidateTestOptions options{.draws = 0, .map = false};
  const std::vector<std::string> labels{"encoderGain@LKneePitch", "elasticity@LKneePitch", "encoderGain@LAnklePitch",
                                        "linkLength@thigh"};
  std::vector<Term> candidates;
  for (const std::string& label : labels) {
    candidates.push_back(asked.candidateTests.candidates()[*asked.candidateTests.findCandidate(label)]);
  }
  const CandidateTests without{{asked.measurements, asked.model, asked.fit}, candidates, options};
  const AliasMatrix aliases = computeAliasMatrix(without, labels, labels.size());
  REQUIRE(aliases.labels == labels);
  CHECK(aliases.correlations.isApprox(aliases.correlations.transpose()));
  const double own = without.evidence().information(0, 0);
  const double measured = own / (own + std::pow(candidates[0].effect.unknowns[0].sigma, -2));
  for (std::size_t i = 1; i < labels.size(); ++i) {
    const Model larger = buildModel(asked.measurements, {labels[0]});
    CalibrationResult fit = asked.fit; // reused: the comparison does not depend on the linearisation point
    fit.state.unknowns = mapParameters(asked.model, asked.fit.unknowns, larger);
    const CandidateTests with{{asked.measurements, larger, fit}, {candidates[i]}, options};
    const Eigen::Index place = without.problem().groups[i].first;
    const double kept = with.evidence().information(0, 0) / without.evidence().information(place, place);
    INFO(labels[i]);
    const double alike = aliases.correlations(0, static_cast<Eigen::Index>(i));
    CHECK(kept == Approx(1 - measured * alike * alike).margin(0.002));
  }
  CHECK(computeAliasMatrix(without, labels, 2).labels.size() == 2);
}

} // namespace naocal

#include "diagnosis/Questioned.hpp"
#include "inference/Prequential.hpp"
#include "math/Angles.hpp"

#include <catch2/catch.hpp>
#include <functional>

namespace naocal {
namespace {

/// 24 poses; adds `error` to the left knee's readings, a function of the elapsed share of the time.
Questioned kneeReads(const std::function<double(double)>& error) {
  CaptureSet set = simulatedSet(24, 6);
  const auto knee = std::find(set.jointNames.begin(), set.jointNames.end(), "LKneePitch") - set.jointNames.begin();
  const double first = set.captures.front().time.count(), all = set.captures.back().time.count() - first;
  for (Capture& capture : set.captures) {
    capture.joints.measured[static_cast<std::size_t>(knee)] += error((capture.time.count() - first) / all);
  }
  return {set, true};
}

/// Prequential score of a drift of the left knee.
Prequential driftOf(const Questioned& asked) {
  return scorePrequentially(asked.candidateTests.problem(), asked.fit.noise, sortPosesByTime(asked.measurements),
                            asked.candidateTests.findCandidate("timeDrift@LKneePitch").value());
}

double stepOf(const Questioned& asked) {
  double best = 0;
  for (std::size_t cell = 0; cell < asked.candidateTests.map().cells.size(); ++cell) {
    if (asked.candidateTests.map().cells[cell].shape == DriverBasis::Shape::step) {
      best = std::max(best, asked.candidateTests.curveEvidence(asked.candidateTests.mounts().size() + cell).bayes);
    }
  }
  return best;
}

double evidenceOfDrift(const Questioned& asked) {
  return asked.candidateTests.candidateEvidence(asked.candidateTests.findCandidate("timeDrift@LKneePitch").value())
      .bayes;
}

} // namespace

TEST_CASE("a drift predicts the last poses, a slip does not pass for one, and nothing predicts nothing", "[slow]") {
  // Proves the rule for adding time-dependent effects: a knee that creeps by a degree predicts the last fifth of the
  // poses and has more evidence than any step; a slip at 70 % of the time has more evidence as a step; without an error
  // nothing is predicted.
  const Questioned creeps = kneeReads([](double share) { return radians(1) * share; });
  CHECK(driftOf(creeps).predicts());
  CHECK(driftOf(creeps).tail > 0.01);
  CHECK(evidenceOfDrift(creeps) > stepOf(creeps));
  const Questioned slips = kneeReads([](double share) { return share > 0.7 ? radians(1) : 0; });
  CHECK(stepOf(slips) > evidenceOfDrift(slips));
  CHECK_FALSE(driftOf(kneeReads([](double) { return 0; })).predicts());
}

TEST_CASE("one pose is predicted from none") {
  // Proves the limit of the rule, which leaves out a fifth of the poses.
  const Questioned asked = kneeReads([](double) { return 0; });
  CHECK_FALSE(scorePrequentially(asked.candidateTests.problem(), asked.fit.noise, {0},
                                 asked.candidateTests.findCandidate("timeDrift@LKneePitch").value())
                  .predicts());
}

} // namespace naocal

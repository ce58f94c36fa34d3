#include "diagnosis/Questioned.hpp"
#include "diagnosis/views/AddedVariable.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace naocal {

TEST_CASE("the slope over an added-variable plot's poses is the candidate's estimate") {
  // Proves the reduction to one point per pose for every candidate: slope and sigma equal those of the evidence. The
  // signature is orthogonal to the most similar unknown of the model, so poses lie on both sides of zero. The evidence
  // itself is tested elsewhere.
  const Questioned asked{simulatedSet(8, 3), false};
  int compared = 0;
  for (std::size_t i = 0; i < asked.candidateTests.candidates().size(); ++i) {
    const GroupEvidence& evidence = asked.candidateTests.candidateEvidence(i);
    const auto plot = computeAddedVariable(asked.candidateTests, asked.model, i);
    CHECK(plot.has_value() == (evidence.freedom > 0));
    const double plausible = asked.candidateTests.candidates()[i].effect.unknowns.front().sigma;
    if (!plot || std::sqrt(evidence.covariance(0, 0)) > 3 * plausible) {
      continue; // poorly determined: the evidence depends on the prior, the plot does not
    }
    INFO(asked.candidateTests.candidates()[i].label());
    const double size = evidence.estimate.size() == 1 ? evidence.estimate[0] : 1;
    CHECK(plot->slope == Approx(size).margin(0.01 * plot->sigma).epsilon(1e-3));
    if (evidence.estimate.size() == 1) {
      CHECK(plot->sigma == Approx(std::sqrt(evidence.covariance(0, 0))).epsilon(1e-3));
    }
    const auto left = std::count_if(plot->points.begin(), plot->points.end(),
                                    [](const AddedVariablePoint& point) { return point.signature < 0; });
    CHECK(left > 0);
    CHECK(static_cast<std::size_t>(left) < plot->points.size());
    ++compared;
  }
  CHECK(compared > 50);
}

TEST_CASE("a hidden flaw moves every pose along its added-variable line") {
  // Proves the plot's interpretation, nonlinear and with everything refitted: readings scaled by 1/1.004 raise each
  // pose's point by 0.004 times its signature. Visibility above the noise is not tested.
  constexpr double gain = 0.004;
  const CaptureSet plain = simulatedSet(8, 3);
  CaptureSet flawed = plain;
  const auto knee =
      std::find(plain.jointNames.begin(), plain.jointNames.end(), "LKneePitch") - plain.jointNames.begin();
  for (Capture& capture : flawed.captures) {
    capture.joints.measured[static_cast<std::size_t>(knee)] /= 1 + gain;
  }
  const auto plotOf = [](const CaptureSet& set) {
    const Questioned asked{set, false};
    return *computeAddedVariable(asked.candidateTests, asked.model,
                                 *asked.candidateTests.findCandidate("encoderGain@LKneePitch"));
  };
  const AddedVariable before = plotOf(plain), after = plotOf(flawed);
  CHECK(after.slope - before.slope == Approx(gain).epsilon(0.05));
  REQUIRE(after.points.size() == before.points.size());
  for (std::size_t i = 0; i < after.points.size(); ++i) {
    CHECK(after.points[i].residual - before.points[i].residual ==
          Approx(gain * after.points[i].signature).margin(0.1 * gain / after.sigma));
  }
}

} // namespace naocal

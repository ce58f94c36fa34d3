#include "diagnosis/PerfectBut.hpp"
#include "diagnosis/views/EffectSignature.hpp"

#include <catch2/catch.hpp>

namespace naocal {
TEST_CASE("an effect's imprint is what it leaves after a calibration without it", "[slow]") {
  // Compares the shifts before and after refitting with a full calibration of captures that are error-free except for
  // that effect: one that joint offsets absorb for the most part, one they absorb less, and one of the lens, large
  // enough to be nonlinear.
  const CaptureSet set = simulatedSet(8, 3);
  const Questioned asked{set, false};
  const std::string label = GENERATE("encoderGain@LKneePitch", "elasticity@LKneePitch", "radialDistortion@top");
  CAPTURE(label);
  const std::size_t candidate = *asked.candidateTests.findCandidate(label);
  const EffectSignature imprint =
      computeSignatures({asked.measurements, asked.model, asked.fit}, asked.candidateTests, {candidate}).front();
  const CaptureSet perfect = perfectButFor(asked.candidateTests.candidates()[candidate], imprint.size, asked, set);
  const Measurements measurements = buildMeasurements({perfect}, asked.measurements.robot);

  double squares = 0, corners = 0;
  const Residuals before{measurements, asked.model, asked.fit.noise};
  for (const BoardResidual& observation : before.boardResiduals(before.startState(asked.fit.unknowns))) {
    squares += observation.residual.squaredNorm();
    corners += static_cast<double>(observation.residual.cols());
  }
  CHECK(imprint.beforePx ==
        Approx(std::sqrt(squares / corners)).epsilon(0.03)); // computed from one picture per pose of three

  CHECK(imprint.afterPx ==
        Approx(calibratedAt(asked.candidateTests.noise(), measurements, asked.model).rmsPx).epsilon(0.1));
  CHECK(imprint.afterPx < imprint.beforePx);
}

TEST_CASE("an imprint shows the pictures that shift most, largest first") {
  // Proves the order and the maximum number of corners per camera, which the page relies on.
  const Questioned asked{simulatedSet(8, 3), false};
  const std::size_t candidate = *asked.candidateTests.findCandidate("elasticity@LKneePitch");
  const EffectSignature imprint =
      computeSignatures({asked.measurements, asked.model, asked.fit}, asked.candidateTests, {candidate}).front();
  CHECK(std::is_sorted(imprint.pictures.begin(), imprint.pictures.end(),
                       [](const auto& a, const auto& b) { return a.beforePx > b.beforePx; }));
  for (const std::size_t camera : {0, 1}) {
    Eigen::Index corners = 0;
    for (const EffectSignature::Seen& seen : imprint.pictures) {
      corners += asked.measurements.pictures[seen.picture].camera == camera ? seen.corners.cols() : 0;
    }
    CHECK(corners <= 180);
  }
  CHECK(imprint.pictures.size() >= 6);
}

} // namespace naocal

#include "diagnosis/PerfectBut.hpp"
#include "diagnosis/views/ResidualField.hpp"
#include "diagnosis/views/SingleJointCorrection.hpp"
#include "estimation/ModelBuilder.hpp"

#include <catch2/catch.hpp>

namespace naocal {
namespace {

/// RMS over boards and images, per axis [px].
double rmsOf(const ResidualField& leftover) {
  double squares = 0;
  for (const ResidualField::Seen& seen : leftover.boards) {
    squares += seen.rmsPx * seen.rmsPx;
  }
  return std::sqrt(squares / static_cast<double>(leftover.boards.size()));
}

} // namespace

TEST_CASE("what a lens does stays within the pictures, what a joint does leaves them as a whole", "[slow]") {
  // Proves that exactly the rigid motion of the scene is removed, on captures that are error-free except for one
  // effect: of a joint's errors at most 2 % remain; of a lens's errors at least 25 %, although the model absorbs part
  // of them.
  const CaptureSet set = simulatedSet(8, 3);
  const Questioned asked{set, false};
  const auto [label, least, most] = GENERATE(
      table<std::string, double, double>({{"elasticity@LKneePitch", 0, 0.02}, {"radialDistortion@top", 0.25, 1}}));
  CAPTURE(label);
  const Term& term = asked.candidateTests.candidates()[*asked.candidateTests.findCandidate(label)];
  const CaptureSet perfect =
      perfectButFor(term,
                    term.effect.unknowns.front().sigma *
                        Eigen::VectorXd::Ones(static_cast<Eigen::Index>(term.effect.unknowns.size())),
                    asked, set);
  const Measurements measurements = buildMeasurements({perfect}, asked.measurements.robot);
  const CalibrationResult fit = calibratedAt(asked.fit.noise, measurements, asked.model);
  const double share = rmsOf(computeResidualField({measurements, asked.model, fit})) * std::sqrt(2) / fit.rmsPx;
  CHECK(share >= least);
  CHECK(share <= most);
}

TEST_CASE("noise alone leaves within the pictures what corners' noise is", "[slow]") {
  // Proves that six degrees of freedom per image are accounted for: the rms residual equals the noise level. Fewer than
  // 10 % of the cells differ from zero by more than 3 sigma.
  const CaptureSet set = simulatedSet(12, 4);
  const Measurements measurements = buildMeasurements({set}, loadRobot(configurationDirectory(), set.model));
  const Model model = buildModel(measurements);
  const CalibrationResult fit = calibrate(measurements, model);
  const ResidualField left = computeResidualField({measurements, model, fit});
  CHECK(rmsOf(left) == Approx(fit.noise.pixel).epsilon(0.1));
  REQUIRE(left.cells.size() > 50);
  const auto beyond = std::count_if(left.cells.begin(), left.cells.end(), [](const ResidualField::Cell& cell) {
    return std::hypot(cell.du, cell.dv) > 3 * cell.sigma;
  });
  CHECK(static_cast<double>(beyond) < 0.1 * static_cast<double>(left.cells.size()));
  CHECK(std::all_of(left.boards.begin(), left.boards.end(),
                    [](const ResidualField::Seen& seen) { return seen.distance > 0.2 && seen.distance < 3; }));
}

TEST_CASE("a joint that was off in one pose stands out in what it would have to do", "[slow]") {
  // Proves sign, size and place of the joint corrections: the knee's reading is 0.6 degrees too small in one pose. The
  // joint's offset absorbs part of it.
  const CaptureSet plain = simulatedSet(12, 3);
  CaptureSet bent = plain;
  const std::string pose = plain.captures.front().pose;
  const auto knee = static_cast<std::size_t>(std::find(plain.jointNames.begin(), plain.jointNames.end(), "LKneePitch") -
                                             plain.jointNames.begin());
  for (Capture& capture : bent.captures) {
    capture.joints.measured[knee] -= capture.pose == pose ? 0.01 : 0;
  }
  const Questioned asked{bent, false}, before{plain, false};
  const auto pointsOf = [&](const Questioned& from) {
    const std::size_t motor = from.measurements.robot.jointIndex("LKneePitch").value();
    const auto all = computeJointCorrections(from.measurements, from.candidateTests);
    return std::find_if(all.begin(), all.end(), [&](const SingleJointCorrection& one) { return one.motor == motor; })
        ->points;
  };
  const std::vector<JointCorrection> points = pointsOf(asked), plainPoints = pointsOf(before);
  REQUIRE(points.size() == plainPoints.size());
  std::size_t inPose = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ImageObservation& picture = asked.measurements.pictures[points[i].pictures.front()];
    const bool wrong = bent.captures[picture.capture].pose == pose;
    inPose += wrong;
    const double shift = points[i].deflection - plainPoints[i].deflection;
    CHECK((wrong ? shift > 0.005 && shift < 0.011 : std::abs(shift) < 0.003));
  }
  CHECK(inPose >= 3);
}

} // namespace naocal

#include "diagnosis/views/PartialResidual.hpp"

#include "diagnosis/PerfectBut.hpp"
#include "diagnosis/Questioned.hpp"

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <catch2/catch.hpp>
#include <cmath>

using namespace naocal;

namespace {

/// Corners predicted by a fit plus an effect, with noise of 0.3 px.
CaptureSet flawed(const std::string& label, const Eigen::VectorXd& size, std::uint64_t seed) {
  const CaptureSet set = simulatedSet(20, seed);
  const Questioned asked{set, false};
  const std::vector<Term> all = candidateTerms(asked.measurements);
  const auto term = std::find_if(all.begin(), all.end(), [&](const Term& one) { return one.label() == label; });
  REQUIRE(term != all.end());
  CaptureSet made = perfectButFor(*term, size, asked, set);
  boost::random::mt19937_64 random{seed};
  boost::random::normal_distribution<double> noise{0, 0.3}; // [px]
  for (Capture& capture : made.captures) {
    for (BoardCorners& corners : *capture.corners) {
      for (Eigen::Vector2d& uv : corners.uv) {
        uv += Eigen::Vector2d{noise(random), noise(random)};
      }
    }
  }
  return made;
}

/// The model with the effect, and the effect's partial residuals.
struct Explained {
  Explained(const std::string& label, const Eigen::VectorXd& size)
      : asked{flawed(label, size, 7), false, {label}}, fitted{asked.measurements, asked.model, asked.fit},
        drivers{collectDrivers(asked.measurements, asked.model, asked.fit.unknowns)},
        left{computeJointCorrections(asked.measurements, asked.candidateTests)}, term{*asked.model.find(label)},
        cause{computePartialResidual({fitted, asked.candidateTests, left}, term, drivers)} {}

  double estimate() const { return asked.fit.unknowns[Eigen::Index(term.first)]; }

  /// Slope of what is left over the effect's own part where only half of the effect is in: 1, as the other half is
  /// left.
  double leftOfHalf() const {
    CalibrationResult half = asked.fit;
    half.unknowns[Eigen::Index(term.first)] /= 2;
    half.state.unknowns[Eigen::Index(term.first)] /= 2;
    const FittedModel halved{asked.measurements, asked.model, half};
    const CandidateTests tests{halved, {}, {.draws = 0, .map = false}};
    const auto corrections = computeJointCorrections(asked.measurements, tests);
    const auto there = computePartialResidual({halved, tests, corrections}, term, drivers);
    REQUIRE(there);
    double product = 0, square = 0;
    for (const PartialResidual::Point& point : there->points) {
      product += point.left * point.own / (point.sigma * point.sigma);
      square += point.own * point.own / (point.sigma * point.sigma);
    }
    return product / square;
  }

  Questioned asked;
  FittedModel fitted;
  std::vector<DriverSeries> drivers;
  std::vector<SingleJointCorrection> left;
  Term term;
  std::optional<PartialResidual> cause;
};

/// Mean square of what is left over its standard errors: about 1 under noise alone.
double leftOverNoise(const PartialResidual& cause) {
  double sum = 0;
  for (const PartialResidual::Point& point : cause.points) {
    sum += std::pow(point.left / point.sigma, 2) / static_cast<double>(cause.points.size());
  }
  return sum;
}

} // namespace

TEST_CASE("a soft joint's error is shown over its torque, and its own part is its stiffness times that", "[slow]") {
  // Proves the closed form c * tau of the effect's part to within 10 %, by which the torque grows with the deflection,
  // and that the rest is noise: its mean square over the standard
  // errors stays below 2 (the own unknowns of the fit absorb some of it), where the effect's part is far above.
  const Explained soft{"elasticity@LKneePitch", Eigen::VectorXd::Constant(1, 0.01)};
  REQUIRE(soft.cause);
  CHECK(soft.cause->label == "elasticity@LKneePitch");
  CHECK(soft.cause->error == "LKneePitch");
  CHECK(soft.cause->over == "the torque on LKneePitch");
  CHECK(soft.cause->unit == "rad");
  CHECK(soft.cause->overUnit == "Nm");
  double own = 0;
  for (const PartialResidual::Point& point : soft.cause->points) {
    CHECK(point.own == Approx(soft.estimate() * point.over).epsilon(0.1).margin(1e-4));
    own += std::pow(point.own / point.sigma, 2) / static_cast<double>(soft.cause->points.size());
  }
  CHECK(soft.estimate() == Approx(0.01).epsilon(0.2));
  CHECK(leftOverNoise(*soft.cause) < 2);
  CHECK(own > 20);
  CHECK(soft.leftOfHalf() == Approx(1).margin(0.15));
}

TEST_CASE("a gear's play is shown over how its joint was approached", "[slow]") {
  // Proves that the driver without a number of its own is found, and that the effect's part has one size and two signs.
  const Explained loose{"hysteresis@LHipPitch", Eigen::VectorXd::Constant(1, 0.02)};
  REQUIRE(loose.cause);
  CHECK_THAT(loose.cause->over, Catch::StartsWith("how LHipPitch was approached"));
  for (const PartialResidual::Point& point : loose.cause->points) {
    CHECK(std::abs(point.over) <= 1);
    CHECK(std::abs(point.own) == Approx(std::abs(point.over) * std::abs(loose.estimate()) / 2).margin(1e-5));
  }
  CHECK(leftOverNoise(*loose.cause) < 2);
}

TEST_CASE("an effect that turns no joint is shown as displacements, which its fit leaves balanced", "[slow]") {
  // Proves that displacements lie along their own size, and the normal equation of the fit: the weighted sum of what is
  // left vanishes but for the prior, v / sigma^2.
  const Explained longer{"linkLength@tibia", Eigen::VectorXd::Constant(1, 0.004)};
  REQUIRE(longer.cause);
  CHECK(longer.cause->error.empty());
  CHECK(longer.cause->unit == "px");
  CHECK(longer.cause->points.size() == longer.asked.measurements.poses.size());
  double balance = 0, information = 0;
  for (const PartialResidual::Point& point : longer.cause->points) {
    CHECK(point.own > 0);
    CHECK(point.over == point.own);
    balance += point.left * point.own / (point.sigma * point.sigma);
    information += std::pow(point.own / point.sigma, 2);
  }
  const double prior = std::pow(longer.estimate() / longer.term.effect.unknowns[0].sigma, 2);
  CHECK(balance == Approx(prior).margin(0.01 * information));
  CHECK(information > 100);
  CHECK(leftOverNoise(*longer.cause) < 2);
  CHECK(longer.leftOfHalf() == Approx(1).margin(0.05));
}

TEST_CASE("an unnamed curve's part is the curve less its mean, and mounts have none", "[slow]") {
  // Proves linear interpolation within the drawn points, that the part has no mean, and that it and what is left add up
  // to the joint's correction.
  const Explained sound{"elasticity@LKneePitch", Eigen::VectorXd::Constant(1, 0.0)};
  DriverCurve curve{.place = "LKneePitch", .driver = "q"};
  curve.curve = {{-10, -0.1, 0}, {10, 0.1, 0}};
  const ExplainedModel explained{sound.fitted, sound.asked.candidateTests, sound.left};
  const auto cause = computePartialResidual(explained, curve, sound.drivers);
  REQUIRE(cause);
  CHECK(cause->label == "LKneePitch over q");
  CHECK(cause->over == "the angle of LKneePitch");
  const std::size_t knee = *sound.asked.measurements.robot.jointIndex("LKneePitch");
  const auto joint =
      std::find_if(sound.left.begin(), sound.left.end(), [&](const auto& one) { return one.motor == knee; });
  REQUIRE(joint != sound.left.end());
  REQUIRE(joint->points.size() == cause->points.size());
  const PartialResidual::Point& first = cause->points.front();
  double mean = 0;
  for (std::size_t i = 0; i < cause->points.size(); ++i) {
    const PartialResidual::Point& point = cause->points[i];
    CHECK(point.own - first.own == Approx(0.01 * (point.over - first.over)).margin(1e-9));
    CHECK(point.own + point.left == Approx(joint->points[i].deflection).margin(1e-9));
    mean += point.own / (point.sigma * point.sigma);
  }
  CHECK(mean == Approx(0).margin(1e-6));
  curve.place = "top";
  CHECK_FALSE(computePartialResidual(explained, curve, sound.drivers));
}

#include "calibration/Outliers.hpp"

#include "estimation/ModelBuilder.hpp"
#include "simulation/HandMadePoses.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

namespace naocal {
namespace {

struct Seen {
  explicit Seen(CaptureSet set)
      : measurements{buildMeasurements({std::move(set)}, loadRobot(configurationDirectory(), "V6"))},
        model{buildModel(measurements)} {}
  Fit fit(const Noise& noise) const {
    return fitRobustly(measurements, model, noise, fitInitially(measurements, model, noise, {}));
  }
  Measurements measurements;
  Model model;
};

CaptureSet simulated(std::uint64_t seed) {
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  SimulationPlan plan = handMadePlan(robot, 10);
  plan.repeatKind = RepeatKind::reapproach;
  return simulate(robot, plan, seed).set;
}

Noise simulatedNoise() {
  return {.pixel = CornerNoise{}.pixel,
          .encoder = std::hypot(encoderStep / std::sqrt(12.0), RobotMechanics{}.encoderDither)};
}

} // namespace

TEST_CASE("where no board moved, the test for moves is chi2 with six degrees of freedom") {
  // Proves the distribution of the statistic with all other unknowns estimated: its mean over boards with at least six
  // corners, the share beyond the 95 % quantile (12.59), and that no displacement is found.
  double sum = 0, count = 0, beyond = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Seen seen{simulated(seed)};
    const Fit fit = seen.fit(simulatedNoise());
    for (const BoardDisplacement& move : testDisplacements(seen.measurements, seen.model, fit)) {
      if (seen.measurements.pictures[move.picture].observations[move.observation].ids.size() >= 6) {
        sum += move.chi2;
        ++count;
        beyond += move.chi2 > 12.59;
      }
    }
    CHECK_FALSE(findDisplacedBoard(seen.measurements, seen.model, fit));
  }
  CAPTURE(count);
  CHECK(sum / count == Approx(6).margin(0.4));
  CHECK(beyond / count == Approx(0.05).margin(0.02));
}

TEST_CASE("a board that moved in one picture is found, and counts nothing once it is set aside") {
  // Proves that a displacement of 2 px, small enough to be absorbed by joint deflections, is found, and that an
  // excluded observation has no influence on the fit. Displacements of many observations are covered by tests of whole
  // calibrations.
  CaptureSet set = simulated(7);
  Capture& capture = set.captures[4];
  REQUIRE_FALSE(capture.corners->empty());
  BoardCorners& corners = capture.corners->front();
  const auto shift = [&](double pixels) {
    for (Eigen::Vector2d& uv : corners.uv) {
      uv.x() += pixels;
    }
  };
  shift(2);
  Seen seen{set};
  const auto moved = findDisplacedBoard(seen.measurements, seen.model, seen.fit(simulatedNoise()));
  REQUIRE(moved);
  const ImageObservation& picture = seen.measurements.pictures[moved->picture];
  CHECK(set.captures[picture.capture].id == capture.id);
  CHECK(seen.measurements.targets[picture.observations[moved->observation].view.board()].name == corners.board);

  shift(1); // displaces the excluded sighting further
  Seen other{set};
  excludeObservation(seen.measurements, *moved);
  excludeObservation(other.measurements, *moved);
  const Fit a = seen.fit(simulatedNoise()), b = other.fit(simulatedNoise());
  const Eigen::VectorXd sigmas = a.minimum.linear.hessian.inverse().diagonal().cwiseSqrt();
  CHECK((a.minimum.state.unknowns - b.minimum.state.unknowns).cwiseQuotient(sigmas).cwiseAbs().maxCoeff() < 1e-3);
  CHECK_FALSE(findDisplacedBoard(seen.measurements, seen.model, a));
}

} // namespace naocal

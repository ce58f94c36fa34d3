#include "estimation/CandidateTerms.hpp"
#include "estimation/ModelBuilder.hpp"
#include "estimation/Residuals.hpp"
#include "math/LevenbergMarquardt.hpp"

#include "simulation/HandMadePoses.hpp"

#include <catch2/catch.hpp>
#include <set>

namespace naocal {
namespace {

constexpr Noise fine{.pixel = 1e-3, .encoder = 0, .pose = 0};

/// Captures with varied joint velocities, motor temperatures and approach directions.
Measurements generic(SupportFoot foot, const std::string& robotModel) {
  const Robot robot = loadRobot(configurationDirectory(), robotModel);
  SimulationPlan plan = handMadePlan(robot, 8, foot);
  plan.samples = 1;
  plan.surveyed = true;
  Measurements measurements = buildMeasurements({simulate(robot, plan, 5).set}, robot);
  RandomStream chance{7, "drivers"};
  for (ImageObservation& picture : measurements.pictures) {
    picture.instant.time = Seconds{300 + chance.uniformWithin(300)};
    for (Eigen::Index joint = 0; joint < picture.instant.q.size(); ++joint) {
      picture.instant.velocity[joint] = chance.uniformWithin(0.05);
      picture.instant.temperature[joint] = 45 + chance.uniformWithin(15);
      picture.instant.approach[joint] = chance.uniformWithin(1) > 0 ? 1 : -1;
    }
  }
  return measurements;
}

/// Moves every corner to its prediction. Iterates, as the row time depends on the corner's row.
void seeAs(const Model& model, const Eigen::VectorXd& truth, Measurements& measurements) {
  for (int round = 0; round < 4; ++round) {
    const Residuals residuals{measurements, model, fine};
    for (const BoardResidual& seen : residuals.boardResiduals(residuals.startState(truth))) {
      CornerBlocks& corners = measurements.pictures[seen.picture].observations[seen.observation].corners;
      for (Eigen::Index i = 0; i < seen.predicted.cols(); ++i) {
        corners[static_cast<std::size_t>(i / 4)].u[i % 4] = seen.predicted(0, i);
        corners[static_cast<std::size_t>(i / 4)].v[i % 4] = seen.predicted(1, i);
      }
    }
  }
}

} // namespace

TEST_CASE("every effect at every place moves pictures and is found again") {
  // Proves for the candidates that the search fits data of the model itself to 0.002 px, and that unknowns which the
  // captures determine are recovered to 1 %. Four effects are excluded (below). Signs and formulas are tested by
  // captures of other simulators.
  const auto [foot, robotModel] = GENERATE(std::pair{SupportFoot::left, "V6"}, std::pair{SupportFoot::right, "V5"},
                                           std::pair{SupportFoot::left, "V4"});
  const Measurements clean = generic(foot, robotModel);
  std::set<std::string> learned;
  for (const Term& candidate : candidateTerms(clean)) {
    if (candidate.effect.name == "imuTilt" || candidate.effect.name == "jointOffset" ||
        candidate.effect.name == "cameraRotation" || candidate.effect.name == "axisTilt") {
      continue; // not visible in images; two in every model; a tilt is nearly an offset of other joints
    }
    INFO(candidate.label() << " on a " << robotModel);
    const Model model = buildModel(clean, {candidate.label()});
    const Eigen::VectorXd sigmas = model.sigmas();
    Eigen::VectorXd truth = 0.1 * sigmas;
    const auto term = std::find_if(model.terms().begin(), model.terms().end(),
                                   [&](const Term& other) { return other.label() == candidate.label(); });
    REQUIRE(term != model.terms().end());
    const auto first = static_cast<Eigen::Index>(term->first),
               count = static_cast<Eigen::Index>(term->effect.unknowns.size());
    truth.segment(first, count) = 0.5 * sigmas.segment(first, count);
    Eigen::VectorXd without = truth;
    without.segment(first, count).setZero();
    Measurements measurements = clean;
    seeAs(model, without, measurements);
    const Residuals before{measurements, model, fine};
    const auto shown = before.linearize(before.startState(truth));
    REQUIRE(shown);
    CHECK(shown->cost > 1e3); // visible beyond the prior, at 0.001 px noise

    seeAs(model, truth, measurements);
    const Residuals residuals{measurements, model, fine};
    const auto found = levenbergMarquardt(residuals, residuals.startState(Eigen::VectorXd::Zero(truth.size())));
    REQUIRE(found);
    CHECK(found->converged);
    double misfit = 0;
    for (const BoardResidual& seen : residuals.boardResiduals(found->state)) {
      misfit = std::max(misfit, seen.residual.cwiseAbs().maxCoeff());
    }
    CHECK(misfit < 2e-3);
    const Eigen::MatrixXd covariance = found->linear.hessian.inverse();
    for (Eigen::Index i = first; i < first + count; ++i) {
      if (std::sqrt(covariance(i, i)) < 0.02 * sigmas[i]) {
        learned.insert(term->effect.name);
        CHECK(found->state.unknowns[i] == Approx(truth[i]).epsilon(0.01));
      }
    }
  }
  CHECK(learned.size() >= 15);
}

} // namespace naocal

#include "effects/UserEffect.hpp"
#include "estimation/EffectJacobian.hpp"
#include "estimation/ModelBuilder.hpp"
#include "io/JsonReader.hpp"

#include "estimation/DriverState.hpp"
#include "measurements/Measurements.hpp"
#include "simulation/HandMadePoses.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

Measurements standing(SupportFoot foot) {
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  SimulationPlan plan = handMadePlan(robot, 3, foot);
  plan.samples = 1;
  plan.surveyed = true;
  return buildMeasurements({simulate(robot, plan, 5).set}, robot);
}

/// Unknowns at generic values, without zeros or symmetries.
Eigen::VectorXd generic(const Model& model) {
  Eigen::VectorXd result = model.sigmas();
  for (Eigen::Index i = 0; i < result.size(); ++i) {
    result[i] *= 0.3 * std::sin(static_cast<double>(1 + i));
  }
  return result;
}

} // namespace

TEST_CASE(
    "what is believed follows every unknown as its slopes say, by way of angles, torques and centre of mass too") {
  // Compares the derivatives of all effects at all places with finite differences of the predicted state: the list of
  // derivatives, the chain rule through the offsets, and the closed form of torques over angles. The image's derivative
  // with respect to the state is tested in camera.
  const Measurements measurements = standing(GENERATE(SupportFoot::left, SupportFoot::right, SupportFoot::both));
  const Model model = buildModel(measurements, {"*@*"});
  REQUIRE(model.terms().size() > 100);
  const Eigen::VectorXd here = generic(model), sigmas = model.sigmas();
  const ImageObservation& picture = measurements.pictures.front();
  const StateLayout& quantities = measurements.quantities;
  Eigen::MatrixXd bySlopes = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(quantities.size()), here.size());
  for (const StateDerivative& slope : evaluateJacobian(measurements, model, picture, here)) {
    bySlopes(static_cast<Eigen::Index>(slope.quantity), static_cast<Eigen::Index>(slope.unknown)) += slope.value;
  }
  const auto between = observedJoints(measurements.robot, picture);
  std::size_t mixed = 0;
  for (Eigen::Index unknown = 0; unknown < here.size(); ++unknown) {
    INFO(model.names()[static_cast<std::size_t>(unknown)]);
    const auto central = [&](double step) {
      Eigen::VectorXd above = here, below = here;
      above[unknown] += step;
      below[unknown] -= step;
      return Eigen::VectorXd{(predictState(measurements, model, picture, above).values -
                              predictState(measurements, model, picture, below).values) /
                             (2 * step)};
    };
    const double step = 1e-3 * std::min(sigmas[unknown], 0.1);
    const Eigen::VectorXd numeric = (4 * central(step / 2) - central(step)) / 3;
    for (const std::size_t joint : between) {
      for (std::size_t quantity : {quantities.angle(joint), quantities.axis(joint), quantities.axis(joint) + 1}) {
        const auto i = static_cast<Eigen::Index>(quantity);
        CHECK(bySlopes(i, unknown) == Approx(numeric[i]).epsilon(0).margin(1e-7 * std::max(1.0, std::abs(numeric[i]))));
      }
      mixed += bySlopes(static_cast<Eigen::Index>(joint), unknown) != 0;
    }
    for (std::size_t k = 0; k < 6; ++k) {
      const auto i = static_cast<Eigen::Index>(quantities.worldFromSupport() + k);
      CHECK(bySlopes(i, unknown) == Approx(numeric[i]).epsilon(0).margin(1e-7 * std::max(1.0, std::abs(numeric[i]))));
    }
  }
  CHECK(mixed > 200);
}

TEST_CASE("a person's effect counts wherever it acts, be it nothing in a dead band") {
  // Proves that the quantities an effect acts on are not determined where its correction is zero.
  const Measurements measurements = standing(SupportFoot::left);
  const nlohmann::json definition = parseJson(R"json({"name": "slack", "at": "LKneePitch",
    "correction": "a*max(0, abs(tau) - 0.3)", "unknowns": {"a": {"unit": "rad/Nm", "sigma": 0.01}}})json",
                                              "model.json");
  std::vector<Effect> effects = allEffects();
  effects.push_back(parseUserEffect(JsonCursor{definition, "model.json"}, measurements.robot));
  const Model model = buildModel(measurements, {"slack@LKneePitch"}, {}, effects);
  const std::size_t knee = *measurements.robot.jointIndex("LKneePitch");
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model.unknownCount()));
  double most = 0;
  for (const ImageObservation& picture : measurements.pictures) {
    for (const StateDerivative& slope : evaluateJacobian(measurements, model, picture, none)) {
      const bool ofSlack = model.names()[slope.unknown].find("slack") != std::string::npos;
      most = ofSlack && slope.quantity == measurements.quantities.angle(knee) ? std::max(most, slope.value) : most;
    }
  }
  CHECK(most > 0.1); // [Nm]; torque beyond the dead band
}

} // namespace naocal

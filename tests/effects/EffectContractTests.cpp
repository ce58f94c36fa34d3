#include "effects/Catalogue.hpp"
#include "io/Units.hpp"

#include "robot/Kinematics.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <functional>
#include <set>

namespace naocal {
namespace {

struct Instance {
  explicit Instance(const std::string& model)
      : robot{loadRobot(configurationDirectory(), model)},
        drawn{nominalState(robot,
                           {robot.joints.size(), robot.lengths.size(), 1, {.trackers = 1, .hasLinkSteps = true}})} {
    drawn.lens() << 590, 600, 320, 240, 0.01, 0, 0, 0, 0;
    const auto joints = static_cast<Eigen::Index>(robot.joints.size());
    instant.time = Seconds{100};
    instant.supportFoot = SupportFoot::left;
    instant.q = Eigen::VectorXd::LinSpaced(joints, 0.2, 0.4);
    instant.velocity = instant.approach = instant.temperature = instant.current = instant.q;
    instant.torque = 0.1 * instant.q;
    instant.torqueGrowth = 2 * instant.q;
    instant.lateralTorque = Eigen::Matrix2Xd::Constant(2, joints, 0.2);
    instant.com = {0.02, 0.03};
    instant.imu = {0.01, -0.02};
    instant.leftLoad = 1;
  }
  Eigen::VectorXd corrected(const Effect& effect, const std::vector<double>& values) const {
    ModelState modelState = drawn;
    effect.correct(modelState, instant, 0, values);
    return modelState.values;
  }
  /// Whether an unknown changes the corrected state with the other unknowns at their sigmas.
  bool shapes(const Effect& effect, std::size_t unknown) const {
    std::vector<double> values;
    for (const Unknown& each : effect.unknowns) {
      values.push_back(each.sigma);
    }
    const Eigen::VectorXd with = corrected(effect, values);
    values[unknown] = 0;
    return with != corrected(effect, values);
  }
  Robot robot;
  ModelState drawn;
  RobotSample instant;
};

} // namespace

TEST_CASE("every effect keeps the contract of effects") {
  // Proves for all effects of the catalogue: no correction at zero; each unknown changes the state (a shape parameter:
  // with the others at sigma); linear if declared so; valid units, unique names. Formulas and signs are tested by
  // calibrations against independent simulators.
  const Instance instance{GENERATE("V4", "V5", "V6")};
  std::set<std::string> names;
  for (const Effect& effect : allEffects()) {
    INFO(effect.name);
    CHECK(names.insert(effect.name).second);
    CHECK((effect.alias.empty() || names.insert(effect.alias).second));
    CHECK_FALSE(effect.formula.empty());
    CHECK_FALSE(effect.description.empty());
    REQUIRE_FALSE(effect.unknowns.empty());
    std::vector<double> values(effect.unknowns.size(), 0);
    const Eigen::VectorXd atZero = instance.corrected(effect, values);
    CHECK(atZero == instance.drawn.values);
    std::set<std::string> unknowns;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Unknown& unknown = effect.unknowns[i];
      CHECK(unknowns.insert(unknown.name).second);
      CHECK(parseUnit(unknown.unit));
      CHECK(unknown.sigma > 0);
      values[i] = unknown.sigma;
      const Eigen::VectorXd once = instance.corrected(effect, values) - atZero;
      CHECK((once.cwiseAbs().maxCoeff() > 0 || (!effect.linear && instance.shapes(effect, i))));
      values[i] = 2 * unknown.sigma;
      const Eigen::VectorXd twice = instance.corrected(effect, values) - atZero;
      CHECK((!effect.linear || (twice - 2 * once).cwiseAbs().maxCoeff() < 1e-9 * (1 + once.cwiseAbs().maxCoeff())));
      values[i] = 0;
    }
  }
}

TEST_CASE("every effect is smooth in what drives it, or says that it is not") {
  // Proves that `kink` is correct: with the unknowns at sigma, the second difference of a smooth correction over 1/100
  // of a driver's range, zero included, is below 1/200 of the correction's range. For discrete drivers (approach), this
  // concerns the interpolation between their values.
  Instance instance{"V6"};
  const auto drivers = std::to_array<std::function<double&(RobotSample&)>>(
      {[](RobotSample& i) -> double& { return i.q[0]; }, [](RobotSample& i) -> double& { return i.torque[0]; },
       [](RobotSample& i) -> double& { return i.approach[0]; }, [](RobotSample& i) -> double& { return i.velocity[0]; },
       [](RobotSample& i) -> double& { return i.temperature[0]; }, [](RobotSample& i) -> double& { return i.com[0]; },
       [](RobotSample& i) -> double& { return i.com[1]; }});
  std::set<std::string> bent;
  for (const Effect& effect : allEffects()) {
    std::vector<double> values;
    for (const Unknown& unknown : effect.unknowns) {
      values.push_back(unknown.sigma);
    }
    for (const auto& driver : drivers) {
      const double before = driver(instance.instant);
      constexpr int steps = 100;
      Eigen::MatrixXd curve{instance.drawn.values.size(), 2 * steps + 1};
      for (int i = 0; i <= 2 * steps; ++i) {
        driver(instance.instant) = static_cast<double>(i - steps) / steps;
        curve.col(i) = instance.corrected(effect, values);
      }
      driver(instance.instant) = before;
      const Eigen::VectorXd range = curve.rowwise().maxCoeff() - curve.rowwise().minCoeff();
      const Eigen::MatrixXd bends =
          curve.rightCols(2 * steps - 1) - 2 * curve.middleCols(1, 2 * steps - 1) + curve.leftCols(2 * steps - 1);
      if ((bends.cwiseAbs().rowwise().maxCoeff().array() > 0.005 * range.array() + 1e-15).any()) {
        bent.insert(effect.name);
        INFO(effect.name);
        CHECK(effect.kink);
      }
    }
  }
  CHECK(bent == std::set<std::string>{"backlash", "gearPlay"});
}

} // namespace naocal

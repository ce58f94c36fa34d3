#include "calibration/EffectiveOffsets.hpp"

#include "estimation/ModelBuilder.hpp"
#include "math/Angles.hpp"
#include "poses/candidates/SupportLegs.hpp"
#include "simulation/HandMadePoses.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

namespace naocal {
namespace {

/// Captures of a V6 on its left foot, and a model with further effects at the left knee.
struct Knee {
  explicit Knee(const std::string& effect)
      : robot{loadRobot(configurationDirectory(), "V6")}, measurements{buildMeasurements(
                                                              {simulate(robot, handMadePlan(robot, 6), 4).set}, robot)},
        model{buildModel(measurements, {effect + "@LKneePitch"})}, unknowns{
                                                                       Eigen::VectorXd::Zero(static_cast<Eigen::Index>(
                                                                           model.unknownCount()))} {}

  void set(const std::string& unknown, double value) {
    const std::vector<std::string> names = model.names();
    const auto found = std::find(names.begin(), names.end(), unknown);
    REQUIRE(found != names.end());
    unknowns[found - names.begin()] = value;
  }

  JointCompensation at(const Eigen::VectorXd& posture, const std::string& joint = "LKneePitch") const {
    const auto all = jointCompensations(measurements, model, unknowns, posture);
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const JointCompensation& one) { return one.joint == joint; });
    REQUIRE(found != all.end());
    return *found;
  }

  Robot robot;
  Measurements measurements;
  Model model;
  Eigen::VectorXd unknowns;
};

} // namespace

TEST_CASE("the constant of a knee with a wrong gain is its offset less the gain's share at the stand") {
  // Proves delta = g * angle in closed form at two postures, its mean and range over the captures, and that joints
  // without a further effect have the constant o.
  Knee knee{"encoderGain"};
  knee.set("jointOffset@LKneePitch.o", radians(2.0));
  knee.set("jointOffset@HeadPitch.o", radians(-1.0));
  knee.set("encoderGain@LKneePitch.g", 0.02);
  Eigen::VectorXd posture = bentKneesStance(knee.robot);
  const JointCompensation stand = knee.at(posture);
  CHECK(stand.offset == radians(2.0));
  CHECK(degrees(stand.delta) == Approx(0.02 * 50)); // knees bent by 50 degrees
  CHECK(degrees(stand.constant()) == Approx(2.0 - 1.0));
  posture[static_cast<Eigen::Index>(*knee.robot.jointIndex("LKneePitch"))] = radians(10);
  CHECK(degrees(knee.at(posture).delta) == Approx(0.02 * 10));
  CHECK(knee.at(posture, "HeadPitch").constant() == radians(-1.0));

  double sum = 0, lowest = 1, highest = -1;
  int count = 0;
  for (const ImageObservation& picture : knee.measurements.pictures) {
    if (!picture.observations.empty()) {
      const double delta =
          0.02 * (picture.instant.q[static_cast<Eigen::Index>(*knee.robot.jointIndex("LKneePitch"))] - radians(2.0));
      sum += delta;
      lowest = std::min(lowest, delta);
      highest = std::max(highest, delta);
      ++count;
    }
  }
  CHECK(stand.mean == Approx(sum / count));
  CHECK(stand.lowest == Approx(lowest));
  CHECK(stand.highest == Approx(highest));
  CHECK(stand.spread > 0);
  CHECK(stand.spread <= highest - lowest);
}

TEST_CASE("a knee that gives way needs a constant that includes how far it does at the stand") {
  // Proves that load counts at the stand: a spring's delta has the sign of the load on the bent knee, vanishes with the
  // spring, grows with it, and does not depend on the offset. Its size is tested with gravity.
  Knee knee{"elasticity"};
  const Eigen::VectorXd posture = bentKneesStance(knee.robot);
  CHECK(knee.at(posture).delta == 0);
  knee.set("elasticity@LKneePitch.c", 0.01);
  const double soft = knee.at(posture).delta;
  CHECK(soft > radians(0.1)); // gravity bends the knee further
  knee.set("elasticity@LKneePitch.c", 0.005);
  const double stiff = knee.at(posture).delta;
  CHECK(stiff > 0.4 * soft);
  CHECK(stiff < 0.6 * soft);
  knee.set("jointOffset@LKneePitch.o", radians(4.0));
  CHECK(knee.at(posture).delta == Approx(stiff));
  CHECK(knee.at(posture).constant() == Approx(radians(4.0) - stiff));
}

} // namespace naocal

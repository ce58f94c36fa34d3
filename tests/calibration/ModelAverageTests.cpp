#include "MeasuredArm.hpp"
#include "TemporaryFolder.hpp"
#include "calibration/Calibration.hpp"
#include "data/CaptureSetFile.hpp"
#include "estimation/ModelBuilder.hpp"
#include "inference/Thresholds.hpp"
#include "io/Files.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

namespace naocal {
namespace {

/// An arm's measurements by a tracker at an unknown place, and their calibration.
struct SolvedArm {
  Measurements measurements;
  Model model;
  CalibrationResult result;

  explicit SolvedArm(const ArmReadings& holds, const CalibrationOptions& options = {}) {
    const TemporaryFolder folder;
    writeArmSet(folder.path(), holds);
    measurements = buildMeasurements({readCaptureSet(folder.path()).set},
                                     parseUrdf(readFile(folder.path() / "arm.urdf"), "arm.urdf"));
    model = buildModel(measurements);
    result = calibrate(measurements, model, options);
  }
  const Estimate& offsetOf(const std::string& joint) const {
    return result.estimates[model.find("jointOffset@" + joint)->first];
  }
};

constexpr ArmReadings byTracker{.contacts = false};

ArmReadings withGain(ArmReadings holds, double gain) {
  holds.gain = gain;
  return holds;
}

ArmReadings withJump(ArmReadings holds, double jump) {
  holds.jump = jump;
  return holds;
}

ArmReadings onColumn(ArmReadings holds) {
  holds.column = true;
  return holds;
}

} // namespace

TEST_CASE("a joint that the tracker's place imitates keeps its fitted zero and its prior's sigma") {
  // Proves that averages stay inside the priors where only these hold a joint: a first joint that turns, and a lift
  // column, with nothing missing, with an effect of the catalogue, and with a jump that no smooth effect explains. A
  // linear step from the fit of an eccentricity took such a joint to 26 degrees, and a misfit made it uncertain by many
  // times its prior.
  for (const ArmReadings& holds : {byTracker, withGain(byTracker, 0.05), withJump(byTracker, 0.2), onColumn(byTracker),
                                   withGain(onColumn(byTracker), 0.05), withJump(onColumn(byTracker), 0.05)}) {
    const SolvedArm arm{holds};
    const Estimate& turn = arm.offsetOf("turn");
    const double prior = arm.model.find("jointOffset@turn")->effect.unknowns.front().sigma;
    INFO("column " << holds.column << ", gain " << holds.gain << ", jump " << holds.jump << ": fitted " << turn.value
                   << ", averaged " << turn.best() << " +- " << turn.bestSigma() << ", prior " << prior);
    CHECK(std::abs(turn.best() - turn.value) < 0.1 * prior);
    CHECK(turn.bestSigma() == Approx(prior).epsilon(0.06));
    CHECK(turn.sigma < 1.06 * prior);
    CHECK(turn.learned < 0.1);
    CHECK(turn.interval()[0] < turn.value);
    CHECK(turn.interval()[1] > turn.value);
  }
}

TEST_CASE("what is learned of a number belongs to the uncertainty beside it, and a bound holds its interval") {
  // Proves `learned` = 1 - sigma / prior sigma for every number that is shown, whether something is missing or not,
  // that no sigma exceeds its prior's by more than models differ, and the order of sigma, interval and bound.
  for (const ArmReadings& holds : {byTracker, withGain(byTracker, 0.05), withJump(byTracker, 0.2)}) {
    const SolvedArm arm{holds};
    const Eigen::VectorXd sigmas = arm.model.sigmas();
    for (std::size_t i = 0; i < arm.result.estimates.size(); ++i) {
      const Estimate& estimate = arm.result.estimates[i];
      REQUIRE(estimate.averaged);
      CHECK(estimate.learned == Approx(std::max(0.0, 1 - estimate.bestSigma() / sigmas[eigenIndex(i)])).margin(1e-12));
      CHECK(std::abs(estimate.best()) < (threshold::farthest + 1) * sigmas[eigenIndex(i)]);
      CHECK(estimate.averaged->bound[0] <= estimate.averaged->interval[0]);
      CHECK(estimate.averaged->bound[1] >= estimate.averaged->interval[1]);
      CHECK(estimate.averaged->interval[0] <= estimate.best());
      CHECK(estimate.averaged->interval[1] >= estimate.best());
    }
  }
}

TEST_CASE("the tool's bound leaves out what the tracker's place imitates") {
  // Proves the task of an arm: the error of a tracked point, to which the first joint's unknown zero and the tracker's
  // unknown place contribute nothing, stays within few noise floors, though the zero is uncertain by a tenth of a
  // radian.
  const SolvedArm arm{byTracker};
  REQUIRE(arm.result.task);
  const Task& task = *arm.result.task;
  CHECK(task.what == "tool");
  CHECK(task.sigma > 0);
  CHECK(task.bound > 3 * task.sigma);
  CHECK(task.bound < task.tolerance);
  CHECK(task.tolerance == Approx(10 * std::sqrt(3.0) * 0.0003).epsilon(0.7)); // 0.3 mm per axis, and the joints' noise
  CHECK(arm.result.verdict == ResultVerdict::good);
  REQUIRE(arm.result.undetectable);
  CHECK(arm.result.undetectable->of == "task");
  CHECK(arm.result.undetectable->bias > 0);
}

TEST_CASE("a tolerance that the user gives and a bound that exceeds it make a result unusable") {
  CalibrationOptions options;
  options.tolerance = 1e-5;
  const SolvedArm arm{byTracker, options};
  CHECK(arm.result.verdict == ResultVerdict::doNotUse);
  CHECK(arm.result.sentence.find("beyond the tolerance of 0.01 mm") != std::string::npos);
}

} // namespace naocal

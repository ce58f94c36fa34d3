#include "RobotV6.hpp"
#include "estimation/Model.hpp"
#include "estimation/ModelBuilder.hpp"
#include "poses/NextPoses.hpp"
#include "poses/candidates/SingleSupportPlanner.hpp"
#include "poses/criteria/Discrimination.hpp"
#include "poses/criteria/PlannedInformation.hpp"
#include "simulation/Simulation.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

namespace naocal {
namespace {

/// Stable poses in random order, not selected for information.
std::vector<CommandedPose> randomPoses(std::size_t count, std::uint64_t seed) {
  PoseOptions options;
  options.count = count;
  options.seed = seed;
  options.choice = 1;
  SimulationPlan plan;
  for (Board& board : plan.boards) { // relative to the left sole
    board.placement->y -= halfFootDistance;
  }
  std::vector<CommandedPose> result;
  for (PlannedPose& pose : planInformativePoses(v6(), plan.boards, plan.cameras, options)) {
    result.push_back({"P" + std::to_string(result.size()), pose.supportFoot, std::move(pose.angles)});
  }
  return result;
}

/// Captures of the robot of seed 1 and its boards, with a new placement of the robot for every `stance`.
CaptureSet captures(std::vector<CommandedPose> poses, int stance) {
  SimulationPlan plan;
  plan.poses = std::move(poses);
  plan.robotSeed = plan.boardSeed = 1;
  plan.firstStance = stance;
  return simulate(v6(), plan, 1 + static_cast<std::uint64_t>(stance)).set;
}

ModelAmbiguity between(const std::string& one, double size, const std::string& other, double otherSize) {
  const auto suspect = [](const std::string& label, double each) {
    const Eigen::Index count = label.starts_with("encoderEccentricity") ? 2 : 1;
    const Eigen::VectorXd sizes = Eigen::VectorXd::Constant(count, each);
    return Hypothesis{label, sizes, sizes, 0.5};
  };
  return {{suspect(one, size), suspect(other, otherSize)}, true, {}, {}, allEffects(), "tells the two apart"};
}

/// Captures with the fitted base model.
struct Fitted {
  explicit Fitted(const std::vector<CaptureSet>& given)
      : measurements{buildMeasurements(given, v6(), true)}, model{buildModel(measurements)} {
    fit = calibrate(measurements, model);
  }
  FittedModel view() const { return {measurements, model, fit}; }

  Measurements measurements;
  Model model;
  CalibrationResult fit;
};

/// Misfits from the information of these captures; noise and fit as of `before`.
Eigen::VectorXd misfits(const Fitted& fitted, const Noise& noise, const ModelAmbiguity& question) {
  const Model model = addHypotheses(fitted.measurements, fitted.model, question);
  const Residuals residuals{fitted.measurements, model, noise};
  const auto linear =
      residuals.linearize(residuals.startState(mapParameters(fitted.model, fitted.fit.unknowns, model)));
  Eigen::MatrixXd hessian = model.sigmas().cwiseAbs2().cwiseInverse().asDiagonal();
  for (const PoseSystem& pose : linear.value().poses) {
    marginalInformation(pose, noise).addTo(hessian);
  }
  return Discrimination{question, static_cast<Eigen::Index>(fitted.model.unknownCount())}.misfits(hessian);
}

std::vector<CommandedPose> commanded(const std::vector<ProposedPose>& poses) {
  std::vector<CommandedPose> result;
  for (const ProposedPose& pose : poses) {
    result.push_back({"N" + std::to_string(result.size()), pose.pose.supportFoot, pose.pose.angles, pose.approach});
  }
  return result;
}

} // namespace

TEST_CASE("four proposed poses tell twins apart better than four random ones, by as much as they promise", "[slow]") {
  // Proves for pairs of effects that twelve random poses hardly separate: a simulated robot, independent of the model,
  // takes the proposed poses, and the information in its captures grows as predicted and by more than with random
  // stable poses (median of five draws). That effects are identified sooner is measured by `naocal evaluate next`.
  static const Fitted before{{captures(randomPoses(12, 7), 0)}};
  const auto [one, size, other, otherSize] = GENERATE(table<std::string, double, std::string, double>({
      {"elasticity@LKneePitch", 0.006, "elasticity@LAnklePitch", 0.006},
      {"encoderGain@LKneePitch", 0.01, "encoderEccentricity@LKneePitch", 0.01},
      {"backlash@LAnklePitch", 0.01, "elasticity@LAnklePitch", 0.006},
      {"hysteresis@LKneePitch", 0.01, "hysteresis@LAnklePitch", 0.01},
  }));
  CAPTURE(one, other);
  const ModelAmbiguity question = between(one, size, other, otherSize);
  const Discrimination discrimination{question, 0};
  const NextPoses next = proposeNextPoses(before.view(), question);
  REQUIRE(next.poses.size() == 4);
  const Eigen::VectorXd told = misfits(before, before.fit.noise, question);
  const auto growthWith = [&](std::vector<CommandedPose> poses, int stance) {
    const Fitted after{{before.measurements.sets->front(), captures(std::move(poses), stance)}};
    return discrimination.growthFactor(told, misfits(after, before.fit.noise, question));
  };
  const double proposed = growthWith(commanded(next.poses), 1);
  std::vector<double> random;
  for (int draw = 0; draw < 5; ++draw) {
    random.push_back(growthWith(randomPoses(4, static_cast<std::uint64_t>(100 + draw)), 2 + draw));
  }
  std::nth_element(random.begin(), random.begin() + 2, random.end());
  CAPTURE(next.growth, proposed, random[2]);
  CHECK(next.growth < 1.2 * proposed); // predicted for one picture per pose; repeated readings add a little
  CHECK(next.growth > 0.75 * proposed);
  CHECK(proposed - 1 > 1.5 * (random[2] - 1));
}

TEST_CASE("proposed poses that hardly strengthen the evidence are told as such") {
  // Proves that a person hears whether poses are worth taking, on both sides of the boundary.
  NextPoses next;
  next.growth = 2.06;
  CHECK(whatTheyTell(next) == "With them the evidence for or against becomes 2.1 times stronger.");
  next.growth = worthTaking;
  CHECK_THAT(whatTheyTell(next), Catch::Matchers::StartsWith("With them"));
  next.growth = std::nextafter(worthTaking, 0);
  CHECK_THAT(whatTheyTell(next), Catch::Matchers::StartsWith("They hardly help: with them the evidence"));
}

TEST_CASE("poses are proposed for captures that tell little or much of the joints, and only where boards lie",
          "[slow]") {
  // Proves that unknown joints (fingers) and missing readings are handled; that every proposed pose sees a board of the
  // captures and is reached safely from standing on its foot; that proposals are reproducible; and that a robot without
  // support foot gets none.
  CaptureSet set = captures(randomPoses(8, 3), 0);
  set.jointNames.push_back("LHand");
  for (Capture& capture : set.captures) {
    capture.joints = {.measured = capture.joints.measured};
    capture.joints.measured.push_back(0.3);
    capture.fsr.reset();
    capture.imu.reset();
  }
  const ModelAmbiguity question = between("elasticity@LKneePitch", 0.006, "elasticity@LAnklePitch", 0.006);
  const Fitted fitted{{set}};
  const NextPoses next = proposeNextPoses(fitted.view(), question);
  const NextPoses again = proposeNextPoses(fitted.view(), question);
  REQUIRE(next.poses.size() == 4);
  CHECK(next.growth > 1);
  CHECK(next.whyNone.empty());
  const SingleSupportPlanner ways{v6(), SupportFoot::left, bentKneesStance(v6()), next.jointError};
  const auto reached = [&](const Eigen::VectorXd& angles, const Eigen::VectorXd& approach) {
    std::mt19937_64 chance{1};
    return ways.planApproach(angles, approach, radians(1), chance).has_value();
  };
  for (std::size_t i = 0; i < next.poses.size(); ++i) {
    const PlannedPose& pose = next.poses[i].pose;
    CHECK(reached(pose.angles, next.poses[i].approach));
    CHECK(pose.angles == again.poses[i].pose.angles);
    REQUIRE_FALSE(pose.sights.empty());
    for (const VisibleBoard& sight : pose.sights) {
      CHECK(std::any_of(set.boards.begin(), set.boards.end(),
                        [&](const Board& board) { return board.id == sight.board; }));
    }
  }

  CaptureSet hanging = set;
  hanging.stances[0].supportFoot = SupportFoot::none;
  for (Capture& capture : hanging.captures) {
    capture.supportFoot = SupportFoot::none;
  }
  const Measurements measurements = buildMeasurements({hanging}, v6());
  CalibrationResult nowhere;
  nowhere.unknowns = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(fitted.model.unknownCount()));
  const NextPoses nothing = proposeNextPoses({measurements, fitted.model, nowhere}, question);
  CHECK(nothing.poses.empty());
  CHECK(nothing.whyNone == "no board lies on the floor before a standing robot");
}

TEST_CASE("planned captures tell what the captures tell") {
  // Proves that planned captures contain torso angles and foot loads if the existing captures do.
  CaptureSet set = captures(randomPoses(1, 3), 0);
  for (Capture& capture : set.captures) {
    capture.imu = Eigen::Vector2d{0.01, 0.02};
    capture.fsr = std::array<double, 8>{1, 1, 1, 1, 1, 1, 1, 1};
  }
  const std::size_t taken = set.captures.size();
  ProposedPose pose;
  pose.pose.supportFoot = SupportFoot::left;
  pose.pose.angles = pose.approach = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(v6().joints.size()));
  const CaptureSet extended = appendPlannedCaptures({set}, v6(), {pose}).front();
  REQUIRE(extended.captures.size() > taken);
  for (const Capture& capture : extended.captures) {
    CHECK(capture.imu.has_value());
    CHECK(capture.fsr.has_value());
  }
}

TEST_CASE("what a rival cannot imitate is told by hand") {
  // Proves the formula for one unknown and two suspects: V by elimination, I_jk with the rival and its prior.
  const ModelAmbiguity question = between("a", 2, "b", 0.5);
  Eigen::Matrix3d hessian;
  hessian << 4, 2, 0, 2, 10, 3, 0, 3, 5;
  const Eigen::VectorXd misfits = Discrimination{question, 1}.misfits(hessian);
  REQUIRE(misfits.size() == 2);
  CHECK(misfits[0] == Approx(4 * (10 - 1 - 9.0 / (5 + 4))));
  CHECK(misfits[1] == Approx(0.25 * (5 - 9.0 / (9 + 0.25))));
}

} // namespace naocal

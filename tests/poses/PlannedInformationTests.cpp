#include "poses/criteria/PlannedInformation.hpp"

#include "RobotV6.hpp"
#include "estimation/ModelBuilder.hpp"
#include "math/LinearAlgebra.hpp"
#include "simulation/Simulation.hpp"
#include "simulation/StandingPoses.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <optional>

namespace naocal {
namespace {

/// The set's captures and those of planned poses, all places surveyed: the new stances are at the origin.
CaptureSet surveyedCaptures(const CaptureSet& set, const Robot& robot, const std::vector<ProposedPose>& poses) {
  CaptureSet all = appendPlannedCaptures({set}, robot, poses).back();
  for (Stance& stance : all.stances) {
    stance.placement = Placement{};
  }
  return all;
}

/// An unknown of the base model among those of PlanningScene::information.
struct SceneUnknown {
  Eigen::Index index;
  double sign; // an offset lowers the scene's angle
};

/// Per unknown of the model; absent for those that the scene does not have.
std::vector<std::optional<SceneUnknown>> findInScene(const Robot& robot, const Model& model) {
  std::vector<std::optional<SceneUnknown>> result(model.unknownCount());
  for (const Term& term : model.terms()) {
    if (term.effect.name == "jointOffset") {
      result[term.first] = SceneUnknown{eigenIndex(term.placeIndex), -1};
    } else if (term.effect.name == "cameraRotation") {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        result[term.first + axis] = SceneUnknown{eigenIndex(robot.joints.size() + 3 * term.placeIndex + axis), 1};
      }
    }
  }
  return result;
}

} // namespace

TEST_CASE("a planning scene promises what captures of the pose would tell") {
  // Proves that the two ways to the information of a planned pose agree: PlanningScene::information, without captures,
  // for the search of a plan; and the measurement model linearised at planned captures, for further poses. Compared for
  // joint offsets and camera rotations, before encoder errors are marginalised.
  const Robot robot = v6();
  SimulationPlan plan;
  plan.surveyed = true;
  plan.poses = planStandingPoses(robot, plan, SupportFoot::left, 1, 1);
  const CaptureSet set = simulate(robot, plan, 1).set;
  PoseOptions options;
  options.count = 3;
  std::vector<ProposedPose> poses;
  for (PlannedPose& pose : planInformativePoses(robot, plan.boards, plan.cameras, options)) {
    poses.push_back({std::move(pose), Eigen::VectorXd::Zero(eigenIndex(robot.joints.size()))});
  }
  CaptureSet captures = surveyedCaptures(set, robot, poses);
  for (std::size_t board = 0; board < captures.boards.size(); ++board) {
    captures.boards[board].placement = plan.boards[board].placement;
  }
  const Measurements measurements = buildMeasurements({captures}, robot);
  const Model model = buildModel(measurements);
  const Residuals residuals{measurements, model, Noise{.pixel = 1}};
  const auto linear =
      residuals.linearize(residuals.startState(Eigen::VectorXd::Zero(eigenIndex(model.unknownCount()))));
  REQUIRE(linear);
  const auto inScene = findInScene(robot, model);
  const PlanningScene scene{robot, SupportFoot::left, plan.boards, plan.cameras, {}};
  for (std::size_t i = 0; i < poses.size(); ++i) {
    ModelState state = scene.nominalState();
    state.values.head(eigenIndex(robot.joints.size())) = poses[i].pose.angles;
    const Eigen::MatrixXd promised = scene.information(state, forwardKinematics(robot, state));
    const auto group = std::find_if(measurements.poses.begin(), measurements.poses.end(),
                                    [&](const PoseGroup& pose) { return pose.name == plannedPoseName(i); });
    REQUIRE(group != measurements.poses.end());
    const PoseSystem& system = linear->poses[static_cast<std::size_t>(group - measurements.poses.begin())];
    std::size_t compared = 0;
    for (std::size_t a = 0; a < system.unknowns.size(); ++a) {
      for (std::size_t b = 0; b < system.unknowns.size(); ++b) {
        const auto &row = inScene[system.unknowns[a]], &column = inScene[system.unknowns[b]];
        if (!row || !column) {
          continue;
        }
        const double scale = std::sqrt(promised(row->index, row->index) * promised(column->index, column->index));
        CHECK(system.unknownGram(eigenIndex(a), eigenIndex(b)) ==
              Approx(row->sign * column->sign * promised(row->index, column->index)).margin(1e-9 * scale));
        ++compared;
      }
    }
    CHECK(compared >= 64); // two head joints, the leg's six motors
  }
}

} // namespace naocal

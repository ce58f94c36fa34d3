#include "QuickPlan.hpp"
#include "io/InputError.hpp"
#include "poses/candidates/BoardPlacement.hpp"
#include "poses/candidates/Transitions.hpp"
#include "poses/criteria/PlanOptions.hpp"

#include <catch2/catch.hpp>

using namespace naocal;

TEST_CASE("a plan that is extended keeps its poses and boards and tells every offset better", "[slow]") {
  // Proves it for three more poses; also that planning the same total at once differs by less than 20 % in the worst
  // sigma, so the first poses' information is included.
  const PosePlan first = quickPlan(quickOptions(6));
  PlanOptions more = quickOptions(6);
  more.poses.count = 3;
  more.moveBoards = false;
  for (const ProposedPose& pose : first.poses) {
    more.kept.push_back(pose.pose.angles);
  }
  const SimulationPlan scene;
  const PosePlan second = planPoses(v6(), {first.boards, scene.cameras}, more);
  REQUIRE(second.poses.size() == 9);
  CHECK(second.kept == 6);
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(second.poses[i].pose.angles == first.poses[i].pose.angles);
  }
  for (const auto& [joint, sigma] : first.sigma) {
    CHECK(second.sigma.at(joint) < sigma);
  }
  PlanOptions atOnce = quickOptions(6);
  atOnce.poses.count = 9;
  CHECK(largest(second.sigma) == Approx(largest(quickPlan(atOnce).sigma)).epsilon(0.2));
}

TEST_CASE("the quickest plan reaches the sigma that is asked for, and a harder demand takes longer", "[slow]") {
  // Proves both for two demands, and that a demand that cannot be met with as many poses is refused.
  PlanOptions easy = quickOptions(6);
  easy.criterion = Criterion::time;
  easy.sigma = radians(0.5);
  PlanOptions hard = easy;
  hard.sigma = radians(0.28);
  const auto seconds = [](const PosePlan& plan) {
    double sum = static_cast<double>(plan.poses.size());
    for (const auto& way : plan.ways) {
      sum += way ? way->seconds : 0;
    }
    return sum;
  };
  const PosePlan quickest = quickPlan(easy), longer = quickPlan(hard);
  CHECK(largest(quickest.sigma) <= easy.sigma * (1 + 1e-9));
  CHECK(largest(longer.sigma) <= hard.sigma * (1 + 1e-9));
  CHECK(seconds(quickest) < seconds(longer));
  hard.sigma = radians(0.01);
  CHECK_THROWS_WITH(quickPlan(hard), Catch::Contains("at most 6 poses to tell every offset to 0.010 degrees"));
}

TEST_CASE("mirrored boards lie alike on both sides, and mirroring twice changes nothing") {
  // Proves it for a board's corners at any rotation, and for a robot's angles.
  const SimulationPlan scene;
  Board board = scene.boards.front();
  board.placement = Placement{0.5, 0.3, 0, 0, 0, 0.7};
  Board image = board;
  image.placement = mirrorPlacement(board, -0.05);
  for (const Eigen::Vector2d& corner : boardOutline(board)) {
    const ConvexPolygon others = boardOutline(image);
    CHECK(std::any_of(others.begin(), others.end(), [&](const Eigen::Vector2d& other) {
      return (other - Eigen::Vector2d{corner.x(), -0.1 - corner.y()}).norm() < 1e-12;
    }));
  }
  Eigen::VectorXd angles = Eigen::VectorXd::LinSpaced(static_cast<Eigen::Index>(v6().joints.size()), -0.5, 0.5);
  CHECK(mirrorAngles(v6(), mirrorAngles(v6(), angles)).isApprox(angles));
  CHECK(mirrorAngles(v6(), angles)[0] == -angles[0]); // HeadYaw
}

TEST_CASE("a board may be off as far as a plan says", "[slow]") {
  // Proves a plan's tolerances by displacing each board by them, along the axes and in rotation, and evaluating the
  // plan again.
  const PosePlan good = quickPlan(quickOptions(6));
  const SimulationPlan scene;
  std::vector<ValidPose> poses;
  const PlanEvaluator before{v6(), good.boards, scene.cameras, good.options};
  for (const ProposedPose& pose : good.poses) {
    poses.push_back({before.scene().nominalState(), {}, 1});
    poses.back().modelState.values.head(pose.pose.angles.size()) = pose.pose.angles;
  }
  const double allowed = 1.1 * before.worstSigma(before.totalInformation(poses));
  for (std::size_t i = 0; i < good.boards.size(); ++i) {
    for (const auto& [x, y, yaw] : {std::array{1.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}) {
      std::vector<Board> off = good.boards;
      off[i].placement->x += x * good.tolerances[i].shift;
      off[i].placement->y += y * good.tolerances[i].shift;
      off[i].placement->yaw += yaw * good.tolerances[i].turn;
      const PlanEvaluator score{v6(), off, scene.cameras, good.options};
      CHECK(score.worstSigma(score.totalInformation(poses)) <= allowed * (1 + 1e-9));
    }
  }
}

TEST_CASE("a plan on both feet leaves the feet where they are and looks at both legs", "[slow]") {
  // Proves that every path between its poses keeps the other sole within 5 mm, at a finer step than planned, that at
  // least six of seven neighbours have a path, and that offsets of both legs are estimated to less than half their
  // prior sigma.
  const PosePlan plan = quickPlan(quickOptions(8, SupportFoot::both));
  REQUIRE(plan.poses.size() == 8);
  const TransitionCheck checks{v6(), plan.options.poses, {.share = 0.95, .step = 0.02, .slip = 0.005}};
  int ways = 0;
  for (std::size_t i = 1; i < plan.poses.size(); ++i) {
    if (!plan.ways[i]) {
      continue;
    }
    ++ways;
    Eigen::VectorXd last = plan.poses[i - 1].pose.angles;
    std::vector<Eigen::VectorXd> stops = plan.ways[i]->via;
    stops.push_back(plan.poses[i].pose.angles);
    for (const Eigen::VectorXd& stop : stops) {
      CHECK(checks.duration(last, stop));
      last = stop;
    }
  }
  CHECK(ways >= 6);
  const double before = radians(6.5) / std::sqrt(3.0);
  for (const char* joint : {"HeadYaw", "LHipYawPitch", "LKneePitch", "LAnkleRoll", "RKneePitch", "RHipRoll"}) {
    CAPTURE(joint);
    CHECK(plan.sigma.at(joint) < before / 2);
  }
}

TEST_CASE("poses that are to tell two effects apart do so better than those of any other criterion", "[slow]") {
  // Proves it among the same candidates with fixed boards, for two effects at one joint; unknown names and single
  // effects are refused with advice.
  PlanOptions options = quickOptions(5);
  options.criterion = Criterion::discriminate;
  options.effects = {"elasticity@LKneePitch", "backlash@LKneePitch"};
  options.compare = true;
  const PosePlan plan = quickPlan(options);
  REQUIRE(plan.misfit);
  CHECK(*plan.misfit > 0);
  double own = 0, others = 0;
  for (const CriterionResult& each : plan.comparison) {
    REQUIRE(each.misfit);
    if (each.poses == 5) {
      (each.criterion == Criterion::discriminate ? own : others) =
          std::max(each.criterion == Criterion::discriminate ? own : others, *each.misfit);
    }
  }
  CHECK(own == Approx(*plan.misfit));
  CHECK(own > 1.2 * others);
  CHECK(plan.poses.front().approach.isZero()); // neither effect depends on the approach
  options.compare = false;
  options.effects = {"elasticity@LKneePitch", "hysteresis@LKneePitch"};
  CHECK(quickPlan(options).poses.front().approach.cwiseAbs().minCoeff() == 1);
  options.effects = {"elasticity@LKneePitch", "backlash@LKnee"};
  CHECK_THROWS_WITH(quickPlan(options), Catch::Contains("backlash@LKneePitch"));
  options.effects = {"elasticity@LKneePitch"};
  CHECK_THROWS_WITH(quickPlan(options), Catch::Contains("expected two effects"));
}

TEST_CASE("a plan that is refined for worn robots serves them better", "[slow]") {
  // Proves it by the worst joint's rms for perturbed robots, against a plan refined for the drawn robot only; the drawn
  // robot's worst sigma may grow by at most a sixth.
  PlanOptions options = quickOptions(6);
  options.rounds = 2;
  options.perturbedRobots = 12;
  const PosePlan worn = quickPlan(options);
  options.perturbedRobots = 0;
  const PosePlan drawn = quickPlan(options);
  CHECK(largest(worn.sigmaOfRobots) < largest(drawn.sigmaOfRobots));
  CHECK(largest(worn.sigma) < 7.0 / 6 * largest(drawn.sigma));
}

#include "RobotV6.hpp"
#include "poses/BoardPlaces.hpp"
#include "poses/Mirror.hpp"
#include "poses/PosePlan.hpp"
#include "synthetic/SimulationPlan.hpp"

#include <catch2/catch.hpp>

using namespace naocal;

namespace {

PlanOptions quick() {
  PlanOptions options;
  options.poses.count = 6;
  options.poses.tries = 40'000;
  options.poses.sampling = Sampling::even;
  options.starts = 1;
  options.rounds = 1;
  options.refinements = 100;
  return options;
}

PosePlan quickPlan(const PlanOptions& options) {
  const SimulationPlan scene;
  return posePlan(v6(), scene.boards, scene.cameras, options);
}

double largest(const std::map<std::string, double>& sigmas) {
  double result = 0;
  for (const auto& [joint, sigma] : sigmas) {
    result = std::max(result, sigma);
  }
  return result;
}

} // namespace

TEST_CASE("a plan that is extended keeps its poses and boards and tells every offset better") {
  // Proves it for three more poses; also that the same total planned at once is not worse by more than a fifth either
  // way, that is, that what the first poses told is counted.
  const PosePlan first = quickPlan(quick());
  PlanOptions more = quick();
  more.poses.count = 3;
  more.moveBoards = false;
  for (const ProposedPose& pose : first.poses) {
    more.kept.push_back(pose.pose.angles);
  }
  const SimulationPlan scene;
  const PosePlan second = posePlan(v6(), first.boards, scene.cameras, more);
  REQUIRE(second.poses.size() == 9);
  CHECK(second.kept == 6);
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(second.poses[i].pose.angles == first.poses[i].pose.angles);
  }
  for (const auto& [joint, sigma] : first.sigma) {
    CHECK(second.sigma.at(joint) < sigma);
  }
  PlanOptions atOnce = quick();
  atOnce.poses.count = 9;
  CHECK(largest(second.sigma) == Approx(largest(quickPlan(atOnce).sigma)).epsilon(0.2));
}

TEST_CASE("the quickest plan reaches the sigma that is asked for, and a harder demand takes longer") {
  // Proves both for two demands, and that one which as many poses cannot meet is refused with what they can.
  PlanOptions easy = quick();
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
  // Proves it for the sheets' corners, whatever way they are turned, and for a robot's angles.
  const SimulationPlan scene;
  Board board = scene.boards.front();
  board.placement = Placement{0.5, 0.3, 0, 0, 0, 0.7};
  Board image = board;
  image.placement = mirrored(board, -0.05);
  for (const Eigen::Vector2d& corner : sheet(board)) {
    const Outline others = sheet(image);
    CHECK(std::any_of(others.begin(), others.end(), [&](const Eigen::Vector2d& other) {
      return (other - Eigen::Vector2d{corner.x(), -0.1 - corner.y()}).norm() < 1e-12;
    }));
  }
  Eigen::VectorXd angles = Eigen::VectorXd::LinSpaced(static_cast<Eigen::Index>(v6().joints.size()), -0.5, 0.5);
  CHECK(mirrored(v6(), mirrored(v6(), angles)).isApprox(angles));
  CHECK(mirrored(v6(), angles)[0] == -angles[0]); // HeadYaw
}

TEST_CASE("a board may be off as far as a plan says") {
  // Proves the tolerances of a plan by laying each board off by them, along the axes and turned, and judging anew.
  const PosePlan good = quickPlan(quick());
  const SimulationPlan scene;
  std::vector<SievedPose> poses;
  const PlanScore before{v6(), good.boards, scene.cameras, good.options};
  for (const ProposedPose& pose : good.poses) {
    poses.push_back({before.scene().drawn(), {}, 1});
    poses.back().belief.values.head(pose.pose.angles.size()) = pose.pose.angles;
  }
  const double allowed = 1.1 * before.worstSigma(before.sum(poses));
  for (std::size_t i = 0; i < good.boards.size(); ++i) {
    for (const auto& [x, y, yaw] : {std::array{1.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}) {
      std::vector<Board> off = good.boards;
      off[i].placement->x += x * good.tolerances[i].shift;
      off[i].placement->y += y * good.tolerances[i].shift;
      off[i].placement->yaw += yaw * good.tolerances[i].turn;
      const PlanScore score{v6(), off, scene.cameras, good.options};
      CHECK(score.worstSigma(score.sum(poses)) <= allowed * (1 + 1e-9));
    }
  }
}

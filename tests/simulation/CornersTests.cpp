#include "RobotV6.hpp"
#include "simulation/HandMadePoses.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

using namespace naocal;

namespace {

/// Corner errors of a simulation relative to the same one without noise, for all corners [px].
std::vector<Eigen::Vector2d> cornerErrors(SimulationPlan plan) {
  const Simulation noisy = simulate(v6(), plan, 1);
  plan.corners = {0, false, 0, 0, plan.corners.displacedBoard};
  const Simulation exact = simulate(v6(), plan, 1);
  std::vector<Eigen::Vector2d> errors;
  for (std::size_t capture = 0; capture < exact.set.captures.size(); ++capture) {
    const auto& noisyBoards = *noisy.set.captures[capture].corners;
    const auto& exactBoards = *exact.set.captures[capture].corners;
    REQUIRE(noisyBoards.size() == exactBoards.size());
    for (std::size_t board = 0; board < exactBoards.size(); ++board) {
      REQUIRE(noisyBoards[board].ids == exactBoards[board].ids);
      for (std::size_t i = 0; i < exactBoards[board].uv.size(); ++i) {
        errors.push_back(noisyBoards[board].uv[i] - exactBoards[board].uv[i]);
      }
    }
  }
  return errors;
}

/// Standard deviation per axis [px].
double deviation(const std::vector<Eigen::Vector2d>& errors) {
  double sum = 0;
  for (const Eigen::Vector2d& error : errors) {
    sum += error.squaredNorm();
  }
  return std::sqrt(sum / (2 * static_cast<double>(errors.size())));
}

double shareBeyond(const std::vector<Eigen::Vector2d>& errors, double limit) {
  const auto beyond = [&](const Eigen::Vector2d& error) { return error.cwiseAbs().maxCoeff() > limit; };
  return static_cast<double>(std::count_if(errors.begin(), errors.end(), beyond)) / static_cast<double>(errors.size());
}

} // namespace

TEST_CASE("a robot without errors sees corners where the contract's formula puts them") {
  // Proves frames and signs from board to pixel against formulas written out here: a V6 standing straight on its left
  // foot with its head turned, nominal bottom camera with distortion, four surveyed boards.
  using Eigen::AngleAxisd, Eigen::Translation3d, Eigen::Vector3d;
  SimulationPlan plan = handMadePlan(v6(), 1);
  plan.surveyed = true;
  plan.samples = 1;
  plan.offsetRange = plan.mountRange = plan.corners.pixel = 0;
  plan.mechanics.servoDroop = plan.mechanics.servoDeadZone = plan.mechanics.residualSpeed = 0;
  plan.poses[0].angles.setZero();
  plan.poses[0].angles[static_cast<Eigen::Index>(*v6().jointIndex("HeadYaw"))] = 0.2;
  plan.poses[0].angles[static_cast<Eigen::Index>(*v6().jointIndex("HeadPitch"))] = -0.1;
  plan.cameras.at("bottom").distortion = {0.05, -0.02, 0.001, -0.002, 0.01};
  const Simulation simulation = simulate(v6(), plan, 1);
  const std::vector<Capture>& captures = simulation.set.captures;
  const Capture& capture = captures[captures[0].camera == "bottom" ? 0 : 1];
  REQUIRE(capture.camera == "bottom");
  REQUIRE_FALSE(capture.corners->empty());

  const Placement& sole = *simulation.set.stances[0].placement;
  const Eigen::Isometry3d worldFromCamera = Translation3d{sole.x, sole.y, 0} * AngleAxisd{sole.yaw, Vector3d::UnitZ()} *
                                            Translation3d{0, -0.05, 0.33309 + 0.1265} *
                                            AngleAxisd{0.2, Vector3d::UnitZ()} * AngleAxisd{-0.1, Vector3d::UnitY()} *
                                            Translation3d{0.05071, 0, 0.01774} *
                                            AngleAxisd{radians(39.7), Vector3d::UnitY()};
  for (const BoardCorners& seen : *capture.corners) {
    const auto isIt = [&](const Board& candidate) { return candidate.id == seen.board; };
    const Board& board = *std::find_if(simulation.set.boards.begin(), simulation.set.boards.end(), isIt);
    for (std::size_t i = 0; i < seen.ids.size(); ++i) {
      const Vector3d inBoard{(seen.ids[i] % 6 + 1) * 0.08, -(seen.ids[i] / 6 + 1) * 0.08, 0};
      const Vector3d inWorld = Vector3d{board.placement->x, board.placement->y, 0} +
                               AngleAxisd{board.placement->yaw, Vector3d::UnitZ()} * inBoard;
      const Vector3d inCamera = worldFromCamera.inverse() * inWorld;
      const double x = -inCamera.y() / inCamera.x(), y = -inCamera.z() / inCamera.x(), r2 = x * x + y * y;
      const double radial = 1 + 0.05 * r2 - 0.02 * r2 * r2 + 0.01 * r2 * r2 * r2;
      const double u = 598 * (x * radial + 2 * 0.001 * x * y - 0.002 * (r2 + 2 * x * x)) + 320;
      const double v = 598 * (y * radial + 0.001 * (r2 + 2 * y * y) - 2 * 0.002 * x * y) + 240;
      CHECK((seen.uv[i] - Eigen::Vector2d{u, v}).norm() < 1e-8);
    }
  }
}

TEST_CASE("corners are as noisy as asked, and noise leaves robot and motions as they were") {
  // Proves the standard deviation to 3 %, and that corner noise has its own random stream (the exact simulation sees
  // the same corners). Normal distribution: 6e-5 beyond 4 sigma.
  SimulationPlan plan = handMadePlan(v6(), 24);
  plan.corners.pixel = 0.25;
  const std::vector<Eigen::Vector2d> errors = cornerErrors(plan);
  REQUIRE(errors.size() > 1500);
  CHECK(deviation(errors) == Approx(0.25).epsilon(0.03));
  CHECK(shareBeyond(errors, 1.0) < 0.002);
}

TEST_CASE("heavy tails keep the standard deviation and throw further") {
  // Roughly proves the scale of Student's t (4 degrees of freedom: 0.5 % beyond 4 sigma per axis): its fourth moment is
  // infinite, so a sample's standard deviation is inaccurate.
  SimulationPlan plan = handMadePlan(v6(), 24);
  plan.corners.heavyTails = true;
  const std::vector<Eigen::Vector2d> errors = cornerErrors(plan);
  CHECK(deviation(errors) == Approx(0.3).epsilon(0.1));
  CHECK(shareBeyond(errors, 1.2) > 0.004);
}

TEST_CASE("gross errors have the asked share and size and are named in the truth") {
  // Proves that as many corners are off by 8 px as the truth names; their identity is not compared. The share is within
  // three standard deviations of 5 %.
  SimulationPlan plan = handMadePlan(v6(), 24);
  plan.corners.grossShare = 0.05;
  const std::vector<Eigen::Vector2d> errors = cornerErrors(plan);
  const Simulation simulation = simulate(v6(), plan, 1);
  CHECK(simulation.truth.grossCorners.size() ==
        static_cast<std::size_t>(std::count_if(errors.begin(), errors.end(), [](const Eigen::Vector2d& error) {
          return std::abs(error.norm() - 8) < 2;
        })));
  const double share = static_cast<double>(simulation.truth.grossCorners.size()) / static_cast<double>(errors.size());
  CHECK(share == Approx(0.05).margin(3 * std::sqrt(0.05 * 0.95 / static_cast<double>(errors.size()))));
}

TEST_CASE("a displaced board changes one picture, the one that the truth names") {
  // Proves that all corners of that board in that picture change and no others, if the board remains visible. The
  // displacement is that of the truth.
  SimulationPlan plan = handMadePlan(v6(), 8);
  plan.corners.pixel = 0;
  const Simulation still = simulate(v6(), plan, 1);
  plan.corners.displacedBoard = 0.03;
  const Simulation moved = simulate(v6(), plan, 1);
  REQUIRE(moved.truth.displacedBoards.size() == 1);
  const DisplacedBoard& displaced = moved.truth.displacedBoards.front();
  CHECK(std::hypot(displaced.x, displaced.y) == Approx(0.03));
  const auto differs = [](const Capture& a, const Capture& b, const std::string& board) {
    for (const BoardCorners& one : *a.corners) {
      for (const BoardCorners& other : *b.corners) {
        if (one.board == board && other.board == board) {
          return one.ids != other.ids || one.uv != other.uv;
        }
      }
    }
    return false;
  };
  for (std::size_t i = 0; i < still.set.captures.size(); ++i) {
    for (const Board& board : still.set.boards) {
      const bool isIt = still.set.captures[i].id == displaced.capture && board.id == displaced.board;
      CHECK(differs(still.set.captures[i], moved.set.captures[i], board.id) == isIt);
    }
  }
}

TEST_CASE("no corner is given outside the picture, behind the camera or on squares too flat to be found") {
  // Proves the limits of the simulated detector with the robot's true geometry; six corners at least.
  SimulationPlan plan = handMadePlan(v6(), 24);
  plan.corners.pixel = 0;
  for (const Capture& capture : simulate(v6(), plan, 1).set.captures) {
    for (const BoardCorners& board : *capture.corners) {
      REQUIRE(board.ids.size() >= 6);
      for (const Eigen::Vector2d& uv : board.uv) {
        REQUIRE((uv.x() >= 0 && uv.x() <= 639 && uv.y() >= 0 && uv.y() <= 479));
      }
    }
  }
  CameraIntrinsics camera = plan.cameras.at("top");
  Board board = plan.boards[0];
  const auto ahead = [&](double distance, double down) {
    Placement placement{distance, 0.28, -down, 0, 0, -std::numbers::pi / 2};
    return visibleCorners(camera, board, isometryFromPlacement(placement)).ids.size();
  };
  CHECK(ahead(1.0, 0.35) > 0);
  CHECK(ahead(3.0, 0.35) == 0);  // squares 2 px high
  CHECK(ahead(-1.0, 0.35) == 0); // behind
  CHECK(ahead(1.0, -0.35) == 0); // seen from below
}

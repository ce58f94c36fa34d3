#include "camera/ObservationChain.hpp"

#include <catch2/catch.hpp>
#include <random>

namespace naocal {
namespace {

/// A robot in a random posture with all other quantities perturbed, and a board in front of its camera.
struct Scenery {
  Scenery(const std::string& link, unsigned seed)
      : robot{loadRobot(configurationDirectory(), "V6")}, quantities{robot.joints.size(), robot.lengths.size(), 2},
        modelState{nominalState(robot, quantities)} {
    std::mt19937 random{seed};
    std::uniform_real_distribution<double> unit{-1, 1};
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
      modelState.angle(joint) = 0.4 * unit(random);
      modelState.axis(joint) += 0.02 * Eigen::Vector3d{unit(random), unit(random), unit(random)};
    }
    modelState.mountTranslation() << 0.002, -0.003, 0.001;
    modelState.mountRotation() << 0.03, -0.02, 0.04;
    modelState.lens() << 590, 610, 321, 243, 0.05, -0.03, 0.002, -0.001, 0.01;
    modelState.worldFromSupport() << 0.1, -0.05, 0.01, 0.02, -0.03, 0.2;
    board.pattern = CharucoPattern{};
    board.points = innerCorners(*board.pattern);
    board.link = link;
    BoardCorners seen{"A", {0, 3, 5, 9, 14, 18, 23}, std::vector<Eigen::Vector2d>(7, Eigen::Vector2d::Zero())};
    corners = packCorners(board, seen);
    const bool inWorld = link == "floor";
    view.emplace(robot, quantities, 0, ChainTarget{*robot.linkIndex(inWorld ? "LSole" : link), inWorld, 1});
    modelState.boardScale(1) = 0.01;
    modelState.boardBow(1) = 0.004;
    placeBefore(1.1);
  }

  /// Places the board before the camera, at a distance.
  void placeBefore(double distance) {
    modelState.boardPlacement(1).setZero();
    const LinkPoses torsoFromLink = forwardKinematics(robot, modelState);
    const CameraFrames attitude = view->cameraFrames({robot, modelState, torsoFromLink});
    const RigidTransform opticalFromParent =
        attitude.opticalFromBoard; // at zero placement, the board's frame equals its parent's
    const RigidTransform wanted{rotationX(2.4) * rotationZ(0.5), {-0.2, 0.1, distance}};
    const RigidTransform parentFromBoard = opticalFromParent.inverse() * wanted;
    const Eigen::Matrix3d& r = parentFromBoard.rotation;
    modelState.boardPlacement(1) << parentFromBoard.translation, std::atan2(r(2, 1), r(2, 2)), -std::asin(r(2, 0)),
        std::atan2(r(1, 0), r(0, 0));
  }

  /// u and v of all seven corners.
  Eigen::VectorXd predicted(const ModelState& at) const {
    ProjectedBlocks projected;
    const CameraFrames attitude = view->cameraFrames({robot, at, forwardKinematics(robot, at)});
    REQUIRE(view->project(attitude, at, corners, projected));
    Eigen::VectorXd uv(14);
    for (Eigen::Index i = 0; i < 7; ++i) {
      uv[2 * i] = projected[static_cast<std::size_t>(i / 4)].u[i % 4];
      uv[2 * i + 1] = projected[static_cast<std::size_t>(i / 4)].v[i % 4];
    }
    return uv;
  }

  /// Analytic derivative with respect to one quantity.
  Eigen::VectorXd derivative(std::size_t quantity) const {
    const LinkPoses torsoFromLink = forwardKinematics(robot, modelState);
    const CameraFrames attitude = view->cameraFrames({robot, modelState, torsoFromLink});
    ProjectedBlocks projected;
    view->project(attitude, modelState, corners, projected);
    std::vector<std::size_t> extras;
    if (const auto extra = view->extraIndex(quantity)) {
      extras.push_back(*extra);
    }
    Eigen::MatrixXd motion(static_cast<Eigen::Index>(6 + extras.size()), 1);
    view->fillMotionColumns({robot, modelState, torsoFromLink}, attitude, {quantity}, extras, motion);
    Eigen::VectorXd result(14);
    for (Eigen::Index i = 0; i < 7; ++i) {
      const ProjectedBlock& seen = projected[static_cast<std::size_t>(i / 4)];
      double du = 0, dv = 0;
      for (Eigen::Index k = 0; k < 6; ++k) {
        du += seen.rowsU[k][i % 4] * motion(k, 0);
        dv += seen.rowsV[k][i % 4] * motion(k, 0);
      }
      if (!extras.empty()) {
        const CornerShift shift = ObservationChain::shiftByExtra(extras[0], attitude, modelState,
                                                                 corners[static_cast<std::size_t>(i / 4)], seen);
        du += shift.u[i % 4] * motion(6, 0);
        dv += shift.v[i % 4] * motion(6, 0);
      }
      result[2 * i] = du;
      result[2 * i + 1] = dv;
    }
    return result;
  }

  /// Central differences with Richardson extrapolation.
  Eigen::VectorXd differences(std::size_t quantity, double step) const {
    const auto central = [&](double h) {
      ModelState above = modelState, below = modelState;
      above.values[static_cast<Eigen::Index>(quantity)] += h;
      below.values[static_cast<Eigen::Index>(quantity)] -= h;
      return Eigen::VectorXd{(predicted(above) - predicted(below)) / (2 * h)};
    };
    return (4 * central(step / 2) - central(step)) / 3;
  }

  Robot robot;
  StateLayout quantities;
  ModelState modelState;
  Board board;
  CornerBlocks corners;
  std::optional<ObservationChain> view;
};

} // namespace

TEST_CASE("a corner's derivative by every quantity agrees with fine differences") {
  // Compares the analytic derivative with the projection, for floor boards and targets on the robot, at states where no
  // derivative vanishes by symmetry. The projection itself is not tested.
  const std::string link = GENERATE("floor", "LWrist", "RSole");
  const unsigned seed = GENERATE(1u, 2u, 3u);
  const Scenery scenery{link, seed};
  std::size_t moving = 0;
  for (std::size_t quantity = 0; quantity < scenery.quantities.size(); ++quantity) {
    const bool focal = quantity == scenery.quantities.lens() || quantity == scenery.quantities.lens() + 1;
    const Eigen::VectorXd numeric = scenery.differences(quantity, focal ? 1 : 2e-3);
    const Eigen::VectorXd analytic = scenery.derivative(quantity);
    const double largest = std::max(numeric.cwiseAbs().maxCoeff(), 1e-3);
    INFO("quantity " << quantity << " seen from " << link);
    CHECK((numeric - analytic).cwiseAbs().maxCoeff() <= 1e-7 * largest);
    moving += numeric.cwiseAbs().maxCoeff() > 1e-6;
  }
  CHECK(moving > 40);
}

TEST_CASE("a corner behind the camera is nowhere in the picture") {
  // Proves that an impossible projection is reported, not clipped.
  Scenery scenery{"floor", 4};
  scenery.placeBefore(-0.5);
  ProjectedBlocks projected;
  const CameraFrames attitude = scenery.view->cameraFrames(
      {scenery.robot, scenery.modelState, forwardKinematics(scenery.robot, scenery.modelState)});
  CHECK_FALSE(scenery.view->project(attitude, scenery.modelState, scenery.corners, projected));
}

TEST_CASE("a row that is exposed later sees the joints where they are by then") {
  // Compares value and derivative of the row time with projections of the moved robot, corner by corner, for joints
  // that move ten times as fast as at rest. How real cameras expose is not tested.
  Scenery scenery{"floor", 2};
  constexpr double rowTime = 6e-5, cy = 243;
  Eigen::VectorXd velocity(static_cast<Eigen::Index>(scenery.robot.joints.size()));
  for (Eigen::Index joint = 0; joint < velocity.size(); ++joint) {
    velocity[joint] = 3e-3 * std::sin(static_cast<double>(joint + 1));
  }
  for (CornerBlock& block : scenery.corners) {
    block.v += 40; // measured rows differ from predicted ones
  }
  const LinkPoses torsoFromLink = forwardKinematics(scenery.robot, scenery.modelState);
  CameraFrames attitude = scenery.view->cameraFrames({scenery.robot, scenery.modelState, torsoFromLink});
  scenery.view->setDrift({scenery.robot, scenery.modelState, torsoFromLink}, velocity, attitude);
  ModelState rolling = scenery.modelState;
  rolling.rowTime() = rowTime;
  ProjectedBlocks late, still;
  REQUIRE(scenery.view->project(attitude, rolling, scenery.corners, late));
  REQUIRE(scenery.view->project(attitude, scenery.modelState, scenery.corners, still));
  for (Eigen::Index i = 0; i < 7; ++i) {
    const auto block = static_cast<std::size_t>(i / 4);
    ModelState moved = scenery.modelState;
    moved.values.head(velocity.size()) += velocity * rowTime * (scenery.corners[block].v[i % 4] - cy);
    const Eigen::VectorXd expected = scenery.predicted(moved);
    CHECK(late[block].u[i % 4] == Approx(expected[2 * i]).epsilon(0).margin(1e-5));
    CHECK(late[block].v[i % 4] == Approx(expected[2 * i + 1]).epsilon(0).margin(1e-5));
    CHECK(std::abs(late[block].u[i % 4] - still[block].u[i % 4]) > 1e-3);
    const CornerShift shift = ObservationChain::shiftByExtra(rowTimeExtra, attitude, scenery.modelState,
                                                             scenery.corners[block], still[block]);
    CHECK(still[block].u[i % 4] + rowTime * shift.u[i % 4] == Approx(expected[2 * i]).epsilon(0).margin(1e-4));
  }
}

} // namespace naocal

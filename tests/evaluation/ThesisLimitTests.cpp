#include "evaluation/ThesisStageFor.hpp"
#include "evaluation/thesis/ThesisTrial.hpp"
#include "math/LinearAlgebra.hpp"
#include "simulation/RobotErrors.hpp"
#include "simulation/SimulationPlan.hpp"
#include "simulation/SyntheticRobot.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <catch2/catch.hpp>

namespace naocal {

namespace {

/// Derivatives of an image's corners with respect to the stage's joints, by central differences through the synthetic
/// robot's kinematics and lens: u0, v0, u1, ... per joint [px/rad].
Eigen::MatrixXd cornerSlopes(const ThesisTrial& trial, const ThesisExperiment& stage, const ImageObservation& picture) {
  const Robot& robot = v6();
  static const SyntheticRobot drawn{
      robot,
      {Eigen::VectorXd::Zero(eigenIndex(robot.joints.size())), std::vector<RobotErrors::Mount>(robot.cameras.size())},
      {}};
  const CameraIntrinsics lens = nominalCameras(640, 480).at(robot.cameras[picture.camera].name);
  Eigen::VectorXd angles = picture.nominal.values.head(eigenIndex(robot.joints.size()));
  for (std::size_t i = 0; i < stage.joints().size(); ++i) {
    angles[eigenIndex(stage.joints()[i])] -= trial.offsets()[eigenIndex(i)];
  }
  const auto corners = [&](const Eigen::VectorXd& joints) {
    std::vector<double> seen;
    const Eigen::Isometry3d cameraFromSole =
        (drawn.soleFromTorso(joints, SupportFoot::left) * drawn.torsoFromCamera(picture.camera, joints)).inverse();
    for (const BoardObservation& observation : picture.observations) {
      const Board& board = stage.allObservations().targets[observation.view.board()].board;
      for (const int id : observation.ids) {
        const Eigen::Vector3d point = board.points[static_cast<std::size_t>(id)];
        const auto uv = projectPoint(lens, cameraFromSole * (isometryFromPlacement(*board.placement) * point));
        seen.push_back(uv.value().x());
        seen.push_back(uv.value().y());
      }
    }
    return Eigen::VectorXd{Eigen::Map<Eigen::VectorXd>(seen.data(), eigenIndex(seen.size()))};
  };
  constexpr double step = 1e-6;
  Eigen::MatrixXd slopes(corners(angles).size(), eigenIndex(stage.joints().size()));
  for (std::size_t i = 0; i < stage.joints().size(); ++i) {
    Eigen::VectorXd above = angles, below = angles;
    above[eigenIndex(stage.joints()[i])] += step;
    below[eigenIndex(stage.joints()[i])] -= step;
    slopes.col(eigenIndex(i)) = (corners(above) - corners(below)) / (2 * step);
  }
  return slopes;
}

/// Dense J^T Sigma^-1 J over all readings, plus the offsets' prior.
Eigen::MatrixXd denseInformation(const ThesisTrial& trial, const ThesisExperiment& stage) {
  const auto joints = eigenIndex(stage.joints().size());
  constexpr double prior = 0.1; // as in naocal solve [rad]
  Eigen::MatrixXd information = Eigen::MatrixXd::Identity(joints, joints) / (prior * prior);
  for (const PoseGroup& pose : trial.measurements().poses) {
    for (const EncoderSample& reading : pose.readings) {
      Eigen::MatrixXd slopes(0, joints);
      for (const std::size_t picture : reading.pictures) {
        const Eigen::MatrixXd more = cornerSlopes(trial, stage, trial.measurements().pictures[picture]);
        slopes.conservativeResize(slopes.rows() + more.rows(), joints);
        slopes.bottomRows(more.rows()) = more;
      }
      Eigen::MatrixXd covariance = std::pow(trial.noise().encoder, 2) * slopes * slopes.transpose();
      covariance.diagonal().array() += std::pow(trial.noise().pixel, 2);
      information += slopes.transpose() * covariance.ldlt().solve(slopes);
    }
  }
  return information;
}

} // namespace

TEST_CASE("the tables' limit is that of the whole measurement's covariance", "[slow]") {
  // Proves information and draws against dense matrices of derivatives by differences through the synthetic robot's
  // kinematics, which share no code with the solver. That errors are normally distributed is assumed.
  const ThesisSetting setting{.poses = 3, .noise = ThesisNoise::both, .jointNoise = AngleNoise::encoder, .samples = 3};
  const ThesisExperiment stage = thesisStageFor(setting);
  ThesisTrial trial{stage, setting, 0.3};
  trial.draw(1, 5);
  constexpr std::size_t draws = 20'000;
  const std::vector<double> limit = trial.drawLimitErrors(draws);

  const Eigen::MatrixXd covariance = denseInformation(trial, stage).inverse();
  const Eigen::MatrixXd root = covariance.llt().matrixL();
  RandomStream chance{1, "the tables' limit"};
  std::vector<double> expected;
  for (std::size_t i = 0; i < draws; ++i) {
    Eigen::VectorXd normal{root.cols()};
    std::generate(normal.begin(), normal.end(), [&] { return chance.normal(1); });
    expected.push_back((root * normal).cwiseAbs().maxCoeff());
  }
  for (const double tolerance : {0.1, 0.15, 0.2, 0.3}) {
    const auto share = [&](const std::vector<double>& errors) {
      const auto within = [&](double error) { return error <= radians(tolerance); };
      return static_cast<double>(std::count_if(errors.begin(), errors.end(), within)) / draws;
    };
    CHECK(share(limit) == Approx(share(expected)).margin(0.02)); // 4 sigma of the difference
  }
}

} // namespace naocal

#include "RobotV6.hpp"
#include "evaluation/ThesisStageFor.hpp"
#include "evaluation/thesis/ThesisTrial.hpp"
#include "math/LinearAlgebra.hpp"

#include <catch2/catch.hpp>

namespace naocal {

namespace {

const ThesisSetting fourPosesOfProgram{.feature = ThesisFeature::programGrid,
                                       .poses = 4,
                                       .jointNoise = AngleNoise::unrounded,
                                       .choice = PoseChoice::program,
                                       .errorSets = ErrorSets::program};

/// Largest distance between the measured corners of an error set and the projections by a camera in this precision, and
/// the number of corners.
template <typename Scalar>
std::pair<double, std::size_t> largestDistance(const ThesisTrial& trial, const ThesisExperiment& stage) {
  const SoleCamera<Scalar> camera = stage.bottomCamera<Scalar>();
  double largest = 0;
  std::size_t count = 0;
  for (const ImageObservation& picture : trial.measurements().pictures) {
    Eigen::VectorXd angles = -trial.offsets();
    for (std::size_t i = 0; i < stage.joints().size(); ++i) {
      angles[eigenIndex(i)] += picture.nominal.angle(stage.joints()[i]);
    }
    const auto cameraFromSole = camera.cameraFromSole(angles.cast<Scalar>());
    for (const BoardObservation& seen : picture.observations) {
      for (std::size_t i = 0; i < seen.ids.size(); ++i, ++count) {
        typename SoleCamera<Scalar>::Points pixel;
        camera.project(cameraFromSole,
                       stage.floorPoint(seen, static_cast<std::size_t>(seen.ids[i])).template cast<Scalar>(), pixel);
        const Eigen::Vector2d measured{seen.corners[i / 4].u[i % 4], seen.corners[i / 4].v[i % 4]};
        largest = std::max(largest, (pixel.template cast<double>() - measured).norm());
      }
    }
  }
  return {largest, count};
}

} // namespace

TEST_CASE("the camera above the sole projects as the estimator does, in single precision but for its rounding") {
  // Proves it for the floor grid in four poses of a robot with offsets: to 1e-7 px in double precision; in single
  // precision rounding shows, but moves no point by more than 0.05 px.
  const ThesisExperiment stage = thesisStageFor(fourPosesOfProgram);
  ThesisTrial trial{stage, fourPosesOfProgram, 0.3};
  trial.draw(1, 0);
  const Model model = makeExperimentModel(stage, 10, 10);
  const Residuals estimator{trial.measurements(), model, Noise{}};
  double exact = 0;
  for (const BoardResidual& seen : estimator.boardResiduals(estimator.startState(trial.offsets()))) {
    exact = std::max(exact, seen.residual.cwiseAbs().maxCoeff());
  }
  CHECK(exact < 1e-7);
  const auto [rounded, count] = largestDistance<float>(trial, stage);
  CHECK(count > 500);
  CHECK(rounded > 1e-6);
  CHECK(rounded < 0.05);
}

TEST_CASE("the field of view ends where the camera or its reach does") {
  // Proves that near corners project into the image's lower corners, that far corners lie within reach on the image's
  // borders, and that a camera above the horizon sees no floor.
  const ThesisExperiment stage = thesisStageFor(fourPosesOfProgram);
  const SoleCamera<double> camera = stage.bottomCamera<double>();
  for (const Eigen::VectorXd& angles : programPoses(stage.jointNames())) {
    const auto cameraFromSole = camera.cameraFromSole(angles);
    const auto view = fieldOfView(camera, cameraFromSole, programReach);
    REQUIRE(view);
    Eigen::Matrix2Xd pixels;
    Eigen::Matrix2Xd corners(2, 4);
    corners << (*view)[0], (*view)[1], (*view)[2], (*view)[3];
    camera.project(cameraFromSole, corners, pixels);
    CHECK((pixels.col(0) - Eigen::Vector2d{0, 479}).norm() < 1e-6);
    CHECK((pixels.col(3) - Eigen::Vector2d{639, 479}).norm() < 1e-6);
    CHECK(std::abs(pixels(0, 1)) < 1e-6);
    CHECK(std::abs(pixels(0, 2) - 639) < 1e-6);
    CHECK(corners.colwise().norm().maxCoeff() <= programReach);
  }
  Eigen::VectorXd up = Eigen::VectorXd::Zero(8);
  up[1] = radians(-80);
  CHECK(!fieldOfView(camera, camera.cameraFromSole(up), programReach));
}

} // namespace naocal

#include "Questioned.hpp"
#include "diagnosis/views/BoardShape.hpp"
#include "diagnosis/views/ImageField.hpp"
#include "estimation/ModelBuilder.hpp"

#include <catch2/catch.hpp>

namespace naocal {

TEST_CASE("the shape of a board is seen, whatever it is and wherever the board lies", "[slow]") {
  // Proves size, sign and place of what corners are off: one board's middle stands 5 mm over its rim
  // and it is 1 % wider but not higher than its file says; in fact the file is wrong and the board is flat. A board's
  // size, tilt and place are no shape: they are taken out of both before they are compared.
  CaptureSet set = simulatedSet(16, 3);
  constexpr double height = 0.005, wider = 0.01, rim = 0.3;
  Board& board = set.boards.front();
  const std::vector<Eigen::Vector3d> flat = board.points;
  const Eigen::Vector3d middle = 0.5 * (flat.front() + flat.back());
  for (Eigen::Vector3d& point : board.points) {
    const Eigen::Vector3d arm = point - middle;
    point -= Eigen::Vector3d{wider * arm.x(), 0, height * (1 - arm.squaredNorm() / (rim * rim))};
  }
  const Measurements measurements = buildMeasurements({set}, loadRobot(configurationDirectory(), set.model));
  const Model model = buildModel(measurements);
  const CalibrationResult fit = calibrate(measurements, model);
  const MotionFreeResiduals errors{{measurements, model, fit}};
  const BoardShape bent = boardShapeFromField(fitSheetField(errors, measurements, 0), measurements);
  CHECK(bent.pValue < 1e-6);
  const auto count = static_cast<Eigen::Index>(bent.corners.size());
  Eigen::MatrixXd none = Eigen::MatrixXd::Zero(3 * count, 7); // no shape: a small rigid motion (6) and a scale (1)
  Eigen::VectorXd truth = Eigen::VectorXd::Zero(3 * count), found = truth;
  for (Eigen::Index i = 0; i < count; ++i) {
    const BoardShape::Corner& corner = bent.corners[static_cast<std::size_t>(i)];
    const Eigen::Vector3d real = flat[static_cast<std::size_t>(corner.id)], arm = real - middle;
    truth.segment<3>(3 * i) = real - corner.place;
    found.segment<3>(3 * i) = corner.off;
    none.block<3, 3>(3 * i, 0).setIdentity();
    none.block<3, 3>(3 * i, 3) << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(), 0;
    none.block<3, 1>(3 * i, 6) = arm;
  }
  const auto shapeOf = [&](const Eigen::VectorXd& off) -> Eigen::VectorXd {
    return off - none * none.completeOrthogonalDecomposition().solve(off);
  };
  CHECK(shapeOf(truth).cwiseAbs().maxCoeff() > 1e-3);
  CHECK(shapeOf(found).dot(shapeOf(truth)) > 0.85 * shapeOf(found).norm() * shapeOf(truth).norm());
  CHECK(shapeOf(truth - found).norm() < 4e-4 * std::sqrt(3.0 * static_cast<double>(count))); // 0.4 mm
}

TEST_CASE("noise alone is no field", "[slow]") {
  // Proves the F distribution: over simulated robots without an effect, p-values of all boards' shapes and of both
  // lenses are small about as often as chance has it (0.13 fall below 0.1), and none is striking. Poses of three
  // pictures at rest.
  std::size_t all = 0, below = 0;
  double least = 1;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const CaptureSet set = simulatedSet(12, seed);
    const Measurements measurements = buildMeasurements({set}, loadRobot(configurationDirectory(), set.model));
    const Model model = buildModel(measurements);
    const CalibrationResult fit = calibrate(measurements, model);
    const MotionFreeResiduals errors{{measurements, model, fit}};
    std::vector<ImageField> fields;
    for (std::size_t board = 0; board < measurements.targets.size(); ++board) {
      fields.push_back(fitCornerField(errors, measurements, board));
      fields.push_back(fitSheetField(errors, measurements, board));
    }
    for (std::size_t camera = 0; camera < measurements.robot.cameras.size(); ++camera) {
      fields.push_back(fitCameraField(errors, measurements, camera));
    }
    for (const ImageField& field : fields) {
      all += field.fit.freedom > 0;
      below += field.fit.pValue < 0.1;
      least = std::min(least, field.fit.pValue);
    }
    CHECK_FALSE(findStrikingField({measurements, model, fit}));
  }
  REQUIRE(all > 150);
  CHECK(static_cast<double>(below) < 0.17 * static_cast<double>(all));
  CHECK(least > 1e-5);
}

TEST_CASE("a board that does not lie as its file has it is named as what it is", "[slow]") {
  // Proves that a shape which no effect of the catalogue has is said to sit on its board, instead of being explained by
  // what moves boards as a whole. The sheet's corner stands up by 6 mm; here the file has it so, and the sheet is flat.
  CaptureSet set = simulatedSet(16, 5);
  Board& board = set.boards.front();
  const Eigen::Vector3d middle = 0.5 * (board.points.front() + board.points.back());
  for (Eigen::Vector3d& point : board.points) {
    const Eigen::Vector3d arm = point - middle;
    point.z() += 0.006 * std::pow(std::max(0.0, arm.x() / 0.2 + arm.y() / 0.12 - 0.5) / 1.5, 2);
  }
  const Diagnosis diagnosis = diagnose(buildMeasurements({set}, loadRobot(configurationDirectory(), set.model)));
  CHECK(diagnosis.verdict == Verdict::unknownEffect);
  REQUIRE_FALSE(diagnosis.driverCurves.empty());
  CHECK(diagnosis.driverCurves.front().place == board.id);
  CHECK(diagnosis.driverCurves.front().unit == "m");
  CHECK(diagnosis.sentence.find("board " + board.id) != std::string::npos);
}

TEST_CASE("a lens that no effect describes is named as what it is", "[slow]") {
  // Proves the same of a camera: its errors wave over the picture, by 2 px.
  CaptureSet set = simulatedSet(16, 5);
  for (Capture& capture : set.captures) {
    for (BoardCorners& seen : *capture.corners) {
      for (Eigen::Vector2d& corner : seen.uv) {
        corner.x() += capture.camera == "bottom" ? 2 * std::sin(corner.x() / 80) * std::cos(corner.y() / 100) : 0;
      }
    }
  }
  const Diagnosis diagnosis = diagnose(buildMeasurements({set}, loadRobot(configurationDirectory(), set.model)));
  CHECK(diagnosis.verdict == Verdict::unknownEffect);
  REQUIRE_FALSE(diagnosis.driverCurves.empty());
  CHECK(diagnosis.driverCurves.front().place == "bottom");
  CHECK(diagnosis.driverCurves.front().unit == "px");
}

} // namespace naocal

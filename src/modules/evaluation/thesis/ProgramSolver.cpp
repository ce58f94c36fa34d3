#include "evaluation/thesis/ProgramSolver.hpp"

#include "evaluation/thesis/ThesisProgram.hpp"
#include "math/Angles.hpp"
#include "math/LinearAlgebra.hpp"

#include <cmath>
#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

namespace naocal {

namespace {

/// Joints of the head and both legs; those of the other leg have no influence, but count as evaluations.
constexpr int programParameters = 14;

/// The residuals in the form that Eigen's solvers expect.
class PixelErrors {
public:
  using Scalar = float;
  using InputType = Eigen::VectorXf;
  using ValueType = Eigen::VectorXf;
  using JacobianType = Eigen::MatrixXf;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

  PixelErrors(const SoleCamera<float>& camera, const ProgramMeasurements& measurements)
      : camera_{camera}, measurements_{measurements} {
    for (const ProgramPicture& picture : measurements.pictures) {
      values_ += static_cast<int>(picture.points.size());
    }
  }

  int inputs() const { return programParameters; }
  int values() const { return values_ + 1; } // the last one is the scatter of coinciding points

  /// Residuals at errors of the joints [rad]; those beyond the camera's chain have no influence.
  int operator()(const InputType& errors, ValueType& residuals) const {
    const auto weight = static_cast<float>(std::sqrt(measurements_.copies));
    Eigen::Index row = 0;
    Eigen::Matrix2Xf predicted;
    for (const ProgramPicture& picture : measurements_.pictures) {
      camera_.project(camera_.cameraFromSole(picture.readings + errors.head(picture.readings.size())), picture.points,
                      predicted);
      const Eigen::Index count = picture.points.size();
      residuals.segment(row, count) = weight * (picture.pixels - predicted).reshaped();
      row += count;
    }
    residuals[row] = static_cast<float>(std::sqrt(measurements_.scatter));
    return 0;
  }

private:
  const SoleCamera<float>& camera_;
  const ProgramMeasurements& measurements_;
  int values_ = 0;
};

} // namespace

ProgramSolver::Minimum ProgramSolver::minimum(Eigen::VectorXf start) const {
  using Problem = Eigen::NumericalDiff<PixelErrors, Eigen::Central>;
  Problem problem{PixelErrors{camera_, measurements_}};
  const auto end = Eigen::LevenbergMarquardt<Problem, float>{problem}.minimize(start);
  const PixelErrors& exact = problem;
  Eigen::VectorXf residuals(exact.values());
  exact(start, residuals);
  return {std::move(start), residuals.squaredNorm(), end == Eigen::LevenbergMarquardtSpace::TooManyFunctionEvaluation};
}

/// Keeps the later one of equal costs, and whatever has no comparable cost, as the program does.
ProgramSolver::Minimum ProgramSolver::bestOfRandomStarts(Minimum best, RandomStream& starts) const {
  constexpr int restarts = 100;
  for (int i = 0; i < restarts; ++i) {
    Eigen::VectorXf start = best.errors; // keeps what has no influence
    start.head(eigenIndex(names_.size())) = -drawProgramStart(names_, starts).cast<float>();
    if (Minimum next = minimum(std::move(start)); !(best.cost < next.cost)) {
      best = std::move(next);
    }
  }
  return best;
}

ProgramEstimate ProgramSolver::estimate(const Minimum& best) const {
  return {best.errors.head(eigenIndex(names_.size())).cast<double>(), best.ranOut};
}

ProgramEstimate ProgramSolver::solve(RandomStream& starts) const {
  const auto widest = static_cast<float>(radians(6.5));
  Minimum best = minimum(Eigen::VectorXf::Zero(programParameters));
  if (best.errors.minCoeff() < -widest || best.errors.maxCoeff() > widest) {
    best = bestOfRandomStarts(std::move(best), starts);
  }
  return estimate(best);
}

ProgramEstimate ProgramSolver::solveFromRandomStarts(RandomStream& starts) const {
  return estimate(bestOfRandomStarts(minimum(Eigen::VectorXf::Zero(programParameters)), starts));
}

} // namespace naocal

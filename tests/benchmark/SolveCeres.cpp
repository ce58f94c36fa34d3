#include "PlainModel.hpp"

#include <ceres/ceres.h>

namespace naocal {

namespace {

constexpr int corners = 80, offsetCount = 8; // per pose; sizes fixed at compile time

struct PoseCost {
  const PlainProblem& problem;
  const PlainProblem::Pose& pose;

  template <typename T> bool operator()(const T* offsets, T* residuals) const {
    plainResiduals(problem, pose, offsets, residuals);
    return true;
  }
};

struct PriorCost {
  double sigma;

  template <typename T> bool operator()(const T* offsets, T* residuals) const {
    for (int i = 0; i < offsetCount; ++i) {
      residuals[i] = offsets[i] / sigma;
    }
    return true;
  }
};

} // namespace

Eigen::VectorXd solvedByCeres(const PlainProblem& plain, CeresSolver solver) {
  Eigen::VectorXd offsets = Eigen::VectorXd::Zero(offsetCount);
  ceres::Problem problem;
  for (const PlainProblem::Pose& pose : plain.poses) {
    problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<PoseCost, 2 * corners, offsetCount>(new PoseCost{plain, pose}), nullptr,
        offsets.data());
  }
  problem.AddResidualBlock(
      new ceres::AutoDiffCostFunction<PriorCost, offsetCount, offsetCount>(new PriorCost{plain.offsetSigma}), nullptr,
      offsets.data());
  ceres::Solver::Options options;
  options.linear_solver_type = solver == CeresSolver::qr ? ceres::DENSE_QR : ceres::DENSE_NORMAL_CHOLESKY;
  options.num_threads = 1;
  options.function_tolerance = 1e-10; // largest power of ten that ends within 1e-6 rad of the minimum
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return offsets;
}

} // namespace naocal

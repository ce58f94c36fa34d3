#include "PlainModel.hpp"

#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

namespace naocal {

namespace {

/// All residuals and priors, in the interface of Eigen's solver.
struct Functor {
  using Scalar = double;
  using InputType = Eigen::VectorXd;
  using ValueType = Eigen::VectorXd;
  using JacobianType = Eigen::MatrixXd;
  static constexpr int InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic;

  const PlainProblem& problem;

  int inputs() const { return static_cast<int>(problem.offsetCount()); }
  int values() const {
    Eigen::Index count = problem.offsetCount();
    for (const PlainProblem::Pose& pose : problem.poses) {
      count += 2 * pose.seen.cols();
    }
    return static_cast<int>(count);
  }
  int operator()(const Eigen::VectorXd& offsets, Eigen::VectorXd& residuals) const {
    Eigen::Index row = 0;
    for (const PlainProblem::Pose& pose : problem.poses) {
      plainResiduals(problem, pose, offsets.data(), &residuals[row]);
      row += 2 * pose.seen.cols();
    }
    residuals.tail(offsets.size()) = offsets / problem.offsetSigma;
    return 0;
  }
};

} // namespace

Eigen::VectorXd solvedByDifferences(const PlainProblem& problem) {
  Eigen::NumericalDiff<Functor, Eigen::Central> functor{Functor{problem}};
  Eigen::LevenbergMarquardt solver{functor};
  Eigen::VectorXd offsets = Eigen::VectorXd::Zero(problem.offsetCount());
  solver.minimize(offsets);
  return offsets;
}

} // namespace naocal

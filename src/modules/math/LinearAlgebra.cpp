#include "math/LinearAlgebra.hpp"

#include <Eigen/Eigenvalues>

namespace naocal {

SymmetricEigen symmetricEigen(const Eigen::MatrixXd& matrix) {
  if (matrix.size() == 0) { // Eigen's solver writes before its memory
    return {Eigen::VectorXd{0}, Eigen::MatrixXd{0, 0}};
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver{matrix};
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXd symmetricEigenvalues(const Eigen::MatrixXd& matrix) {
  if (matrix.size() == 0) {
    return Eigen::VectorXd{0};
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>{matrix, Eigen::EigenvaluesOnly}.eigenvalues();
}

} // namespace naocal

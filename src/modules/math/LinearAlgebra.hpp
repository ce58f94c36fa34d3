#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cstddef>

/// Eigen's solver for symmetric matrices, compiled once; in every user it would add seconds to the build.

namespace naocal {

/// Converts a container index to Eigen's index type.
inline Eigen::Index eigenIndex(std::size_t i) {
  return static_cast<Eigen::Index>(i);
}

/// ln |A| of A = L L^T.
inline double logDeterminant(const Eigen::LLT<Eigen::MatrixXd>& factor) {
  return 2 * factor.matrixLLT().diagonal().array().log().sum();
}

/// A^-1 of A = L L^T.
inline Eigen::MatrixXd inverse(const Eigen::LLT<Eigen::MatrixXd>& factor) {
  return factor.solve(Eigen::MatrixXd::Identity(factor.rows(), factor.cols()));
}

/// A = vectors diag(values) vectors^T.
struct SymmetricEigen {
  Eigen::VectorXd values;  // ascending
  Eigen::MatrixXd vectors; // orthonormal columns
};

/// Uses only the lower triangle of `matrix`.
SymmetricEigen symmetricEigen(const Eigen::MatrixXd& matrix);
Eigen::VectorXd symmetricEigenvalues(const Eigen::MatrixXd& matrix);

} // namespace naocal

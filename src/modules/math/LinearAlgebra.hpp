#pragma once

#include <Eigen/Core>
#include <cstddef>

/// What Eigen's solver for symmetric matrices finds, compiled once: everywhere else it would take seconds of each
/// build.

namespace naocal {

/// A place in a standard container as Eigen counts places.
inline Eigen::Index eigenIndex(std::size_t i) {
  return static_cast<Eigen::Index>(i);
}

/// A = vectors diag(values) vectors^T.
struct SymmetricEigen {
  Eigen::VectorXd values;  // ascending
  Eigen::MatrixXd vectors; // in columns, orthonormal
};

/// Reads the lower triangle of `matrix` alone.
SymmetricEigen symmetricEigen(const Eigen::MatrixXd& matrix);
Eigen::VectorXd symmetricEigenvalues(const Eigen::MatrixXd& matrix);

} // namespace naocal

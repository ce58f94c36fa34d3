#include "math/LinearAlgebra.hpp"

#include <catch2/catch.hpp>

using namespace naocal;

TEST_CASE("an empty matrix has no eigenvalues") {
  // Proves that a model without unknowns, whose matrices are empty, reaches no solver of Eigen. Its own checks are off
  // in release builds.
  const SymmetricEigen eigen = symmetricEigen(Eigen::MatrixXd(0, 0));
  CHECK(eigen.values.size() == 0);
  CHECK(eigen.vectors.rows() == 0);
  CHECK(eigen.vectors.cols() == 0);
  CHECK(symmetricEigenvalues(Eigen::MatrixXd(0, 0)).size() == 0);
  CHECK(symmetricEigenvalues(Eigen::MatrixXd::Constant(1, 1, 3))[0] == Approx(3));
}

#include "math/HandEye.hpp"

#include "math/LinearAlgebra.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <cmath>

namespace naocal {

namespace {

/// Least-squares solution of smallest norm of rows added one equation at a time.
class LinearSystem {
public:
  LinearSystem(std::size_t rows, Eigen::Index unknowns)
      : matrix_{Eigen::MatrixXd::Zero(3 * eigenIndex(rows), unknowns)}, side_{3 * eigenIndex(rows)} {}

  auto block(std::size_t row, Eigen::Index column) { return matrix_.block<3, 3>(3 * eigenIndex(row), column); }
  auto side(std::size_t row) { return side_.segment<3>(3 * eigenIndex(row)); }
  Eigen::VectorXd solve() const {
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors{matrix_.rows(), matrix_.cols()};
    factors.setThreshold(1e-6);
    factors.compute(matrix_);
    return factors.solve(side_);
  }

private:
  Eigen::MatrixXd matrix_;
  Eigen::VectorXd side_;
};

} // namespace

Eigen::Matrix3d nearestRotation(const Eigen::Matrix3d& matrix) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd{matrix, Eigen::ComputeFullU | Eigen::ComputeFullV};
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  return svd.matrixU() * Eigen::Vector3d{1, 1, sign}.asDiagonal() * svd.matrixV().transpose();
}

HandEye solveHandEye(const std::vector<RigidTransform>& worldFromHand,
                     const std::vector<RigidTransform>& eyeFromTarget) {
  // vec(A X B^T) = (B (x) A) vec(X) = vec(Z), summed over all pairs
  Eigen::Matrix<double, 9, 9> sum = Eigen::Matrix<double, 9, 9>::Zero();
  for (std::size_t i = 0; i < worldFromHand.size(); ++i) {
    for (Eigen::Index row = 0; row < 3; ++row) {
      for (Eigen::Index column = 0; column < 3; ++column) {
        sum.block<3, 3>(3 * row, 3 * column) += eyeFromTarget[i].rotation(row, column) * worldFromHand[i].rotation;
      }
    }
  }
  const Eigen::JacobiSVD<Eigen::Matrix<double, 9, 9>> svd{sum, Eigen::ComputeFullU | Eigen::ComputeFullV};
  const Eigen::Matrix<double, 9, 1> z = svd.matrixU().col(0), x = svd.matrixV().col(0);
  const Eigen::Map<const Eigen::Matrix3d> handFromTarget{x.data()}, worldFromEye{z.data()};
  const double sign = handFromTarget.determinant() < 0 ? -1 : 1;
  HandEye result;
  result.handFromTarget.rotation = nearestRotation(sign * handFromTarget);
  result.worldFromEye.rotation = nearestRotation(sign * worldFromEye);
  LinearSystem system{worldFromHand.size(), 6};
  for (std::size_t i = 0; i < worldFromHand.size(); ++i) {
    system.block(i, 0) = worldFromHand[i].rotation;
    system.block(i, 3) = -Eigen::Matrix3d::Identity();
    system.side(i) = result.worldFromEye.rotation * eyeFromTarget[i].translation - worldFromHand[i].translation;
  }
  const Eigen::VectorXd both = system.solve();
  result.handFromTarget.translation = both.head<3>();
  result.worldFromEye.translation = both.tail<3>();
  return result;
}

PointRegistration registerPoints(const std::vector<SeenPoint>& seen, std::size_t points) {
  PointRegistration result;
  LinearSystem all{seen.size(), 12 + 3 * eigenIndex(points)};
  for (std::size_t i = 0; i < seen.size(); ++i) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) { // column by column of the rotation
      all.block(i, 3 * axis) = seen[i].inEye[axis] * Eigen::Matrix3d::Identity();
    }
    all.block(i, 9) = Eigen::Matrix3d::Identity();
    all.block(i, 12 + 3 * eigenIndex(seen[i].point)) = -seen[i].worldFromHand.rotation;
    all.side(i) = seen[i].worldFromHand.translation;
  }
  const Eigen::VectorXd first = all.solve();
  result.worldFromEye.rotation = nearestRotation(Eigen::Map<const Eigen::Matrix3d>{first.data()});
  LinearSystem rest{seen.size(), 3 + 3 * eigenIndex(points)};
  for (std::size_t i = 0; i < seen.size(); ++i) {
    rest.block(i, 0) = Eigen::Matrix3d::Identity();
    rest.block(i, 3 + 3 * eigenIndex(seen[i].point)) = -seen[i].worldFromHand.rotation;
    rest.side(i) = seen[i].worldFromHand.translation - result.worldFromEye.rotation * seen[i].inEye;
  }
  const Eigen::VectorXd second = rest.solve();
  result.worldFromEye.translation = second.head<3>();
  for (std::size_t point = 0; point < points; ++point) {
    result.inHand.emplace_back(second.segment<3>(3 + 3 * eigenIndex(point)));
  }
  return result;
}

} // namespace naocal

#include "math/HandEye.hpp"

#include "math/LinearAlgebra.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <utility>

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

namespace {

/// Linear least squares in the nine numbers of the rotation, which is then made orthonormal, and again for the rest.
PointRegistration registerLinearly(const std::vector<SeenPoint>& seen, std::size_t points) {
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

/// Sum of squared distances.
double misfitOf(const PointRegistration& found, const std::vector<SeenPoint>& seen) {
  double sum = 0;
  for (const SeenPoint& one : seen) {
    sum += (found.worldFromEye * one.inEye - one.worldFromHand * found.inHand[one.point]).squaredNorm();
  }
  return sum;
}

/// Alternates the best eye for these points (Umeyama, IEEE PAMI 13 (1991) 376) and the best points for this eye.
PointRegistration alternateFrom(std::vector<Eigen::Vector3d> inHand, const std::vector<SeenPoint>& seen, int steps) {
  PointRegistration found{{}, std::move(inHand)};
  Eigen::Matrix3Xd inEye(3, eigenIndex(seen.size())), inWorld = inEye;
  std::vector<double> counts(found.inHand.size(), 0);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    inEye.col(eigenIndex(i)) = seen[i].inEye;
    counts[seen[i].point] += 1;
  }
  for (int step = 0; step < steps; ++step) {
    for (std::size_t i = 0; i < seen.size(); ++i) {
      inWorld.col(eigenIndex(i)) = seen[i].worldFromHand * found.inHand[seen[i].point];
    }
    const Eigen::Matrix4d eye = Eigen::umeyama(inEye, inWorld, false);
    found.worldFromEye = {eye.topLeftCorner<3, 3>(), eye.topRightCorner<3, 1>()};
    std::vector<Eigen::Vector3d> sums(counts.size(), Eigen::Vector3d::Zero());
    for (const SeenPoint& one : seen) {
      sums[one.point] += one.worldFromHand.inverse() * (found.worldFromEye * one.inEye);
    }
    for (std::size_t point = 0; point < sums.size(); ++point) {
      found.inHand[point] = counts[point] > 0 ? Eigen::Vector3d{sums[point] / counts[point]} : found.inHand[point];
    }
  }
  return found;
}

/// At most `most` of the points, evenly spread.
std::vector<SeenPoint> thinOut(const std::vector<SeenPoint>& seen, std::size_t most) {
  std::vector<SeenPoint> result;
  const std::size_t step = (seen.size() + most - 1) / most;
  for (std::size_t i = 0; i < seen.size(); i += std::max<std::size_t>(step, 1)) {
    result.push_back(seen[i]);
  }
  return result;
}

} // namespace

PointRegistration registerPoints(const std::vector<SeenPoint>& seen, std::size_t points) {
  constexpr int tries = 40, steps = 200;
  constexpr std::size_t most = 200;
  const std::vector<SeenPoint> some = thinOut(seen, most);
  const PointRegistration linear = registerLinearly(seen, points);
  std::vector<PointRegistration> starts{linear, alternateFrom(linear.inHand, some, tries)};
  for (const double distance : {0.1, 0.4}) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      for (const double sign : {-1.0, 1.0}) {
        const Eigen::Vector3d there = sign * distance * Eigen::Vector3d::Unit(axis);
        starts.push_back(alternateFrom(std::vector<Eigen::Vector3d>(points, there), some, tries));
      }
    }
  }
  std::vector<double> misfits;
  for (const PointRegistration& start : starts) {
    misfits.push_back(misfitOf(start, some));
  }
  const auto best = static_cast<std::size_t>(std::min_element(misfits.begin(), misfits.end()) - misfits.begin());
  return best == 0 ? linear : alternateFrom(starts[best].inHand, some, steps);
}

} // namespace naocal

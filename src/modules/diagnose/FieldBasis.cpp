#include "diagnose/FieldBasis.hpp"

#include <algorithm>
#include <cmath>

namespace naocal {

Eigen::RowVectorXd monomials(const Eigen::Vector2d& at, int most) {
  Eigen::RowVectorXd result((most + 1) * (most + 2) / 2);
  Eigen::Index k = 0;
  for (int degree = 0; degree <= most; ++degree) {
    for (int ofY = 0; ofY <= degree; ++ofY) {
      result[k++] = std::pow(at.x(), degree - ofY) * std::pow(at.y(), ofY);
    }
  }
  return result;
}

Sheet::Sheet(const std::vector<Eigen::Vector3d>& points) : points_{points} {
  for (const Eigen::Vector3d& point : points) {
    box_.extend(point.head<2>());
  }
}

Eigen::RowVectorXd Sheet::basis(std::size_t corner) const {
  constexpr int degree = 3;
  const Eigen::Vector2d at = points_[corner].head<2>() - box_.center();
  return monomials(at / std::max(1e-6, box_.sizes().maxCoeff() / 2), degree);
}

} // namespace naocal

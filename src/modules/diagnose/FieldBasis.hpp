#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

namespace naocal {

constexpr int lensDegree = 4;

/// 1, x, y, x^2, x y, ... up to a degree.
Eigen::RowVectorXd monomials(const Eigen::Vector2d& at, int most);

/// A board's polynomials of degree 3: of its corners' places, about -1 to 1 across.
class Sheet {
public:
  explicit Sheet(const std::vector<Eigen::Vector3d>& points);

  Eigen::RowVectorXd basis(std::size_t corner) const;

private:
  const std::vector<Eigen::Vector3d>& points_;
  Eigen::AlignedBox2d box_;
};

} // namespace naocal

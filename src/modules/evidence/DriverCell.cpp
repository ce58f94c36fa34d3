#include "evidence/DriverCell.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cmath>

namespace naocal {

Eigen::RowVectorXd legendre(double x, Eigen::Index count) {
  Eigen::RowVectorXd result(count);
  double before = 1, here = x; // P_0, P_1
  for (Eigen::Index n = 1; n <= count; ++n) {
    result[n - 1] = here;
    const auto degree = static_cast<double>(n);
    const double next = ((2 * degree + 1) * x * here - degree * before) / (degree + 1);
    before = here;
    here = next;
  }
  return result;
}

Eigen::RowVectorXd DriverCell::basis(double x) const {
  switch (shape) {
  case Shape::smooth:
    return legendre((x - middle) / half, count);
  case Shape::wave:
    return Eigen::RowVector2d{std::sin(waves * x), std::cos(waves * x)};
  case Shape::step:
    return Eigen::RowVectorXd::Constant(1, x > middle ? 1 : -1);
  case Shape::root:
    return Eigen::RowVectorXd::Constant(1, std::copysign(std::sqrt(std::abs(x) / half), x));
  }
  return {};
}

std::set<double> distinctValues(const std::vector<double>& values) {
  const std::set<double> sorted(values.begin(), values.end());
  std::set<double> result;
  for (const double value : sorted) {
    if (result.empty() || value - *result.rbegin() > leastChange) {
      result.insert(result.end(), value);
    }
  }
  return result;
}

DriverCell smoothCell(const std::set<double>& distinct, Eigen::Index degree) {
  DriverCell cell;
  cell.least = *distinct.begin();
  cell.most = *distinct.rbegin();
  cell.middle = (cell.least + cell.most) / 2;
  cell.half = cell.most - cell.middle;
  cell.count = std::min(degree, at(distinct.size()) - 1);
  return cell;
}

std::vector<DriverCell> rippleCells() {
  constexpr int fewest = 2, most = 8;
  std::vector<DriverCell> result;
  for (int waves = fewest; waves <= most; ++waves) {
    DriverCell& cell = result.emplace_back();
    cell.shape = DriverCell::Shape::wave;
    cell.waves = waves;
    cell.count = 2;
    cell.choices = most - fewest + 1;
  }
  return result;
}

std::vector<DriverCell> stepCells(const std::set<double>& times) {
  const std::vector<double> moments = momentsBetween(times, 24);
  std::vector<DriverCell> result;
  for (double moment : moments) {
    DriverCell& cell = result.emplace_back();
    cell.shape = DriverCell::Shape::step;
    cell.middle = moment;
    cell.count = 1;
    cell.choices = moments.size();
  }
  return result;
}

DriverCell rootCell(const std::set<double>& distinct) {
  DriverCell cell;
  cell.shape = DriverCell::Shape::root;
  cell.half = std::max(std::abs(*distinct.begin()), std::abs(*distinct.rbegin()));
  cell.count = 1;
  return cell;
}

std::vector<double> momentsBetween(const std::set<double>& times, std::size_t most) {
  const std::vector<double> all{times.begin(), times.end()};
  const std::size_t gaps = all.size() - 1, parts = std::min(gaps, most);
  std::vector<double> result;
  for (std::size_t part = 0; part < parts; ++part) {
    std::size_t widest = part * gaps / parts;
    for (std::size_t gap = widest; gap < (part + 1) * gaps / parts; ++gap) {
      widest = all[gap + 1] - all[gap] > all[widest + 1] - all[widest] ? gap : widest;
    }
    result.push_back((all[widest] + all[widest + 1]) / 2);
  }
  return result;
}

} // namespace naocal

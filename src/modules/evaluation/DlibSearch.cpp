#include "evaluation/GlobalSearch.hpp"

#include <dlib/global_optimization.h>

namespace naocal {

namespace {

using Column = dlib::matrix<double, 0, 1>;

Eigen::VectorXd asEigen(const Column& numbers) {
  return Eigen::Map<const Eigen::VectorXd>{numbers.begin(), numbers.size()};
}

} // namespace

Eigen::VectorXd minimizeWithDlib(const CostFunction& cost, Eigen::Index unknowns, double range, std::size_t calls) {
  constexpr double impossible = 1e12; // replaces infinity, which dlib cannot handle
  Column lower(unknowns), upper(unknowns);
  lower = -range;
  upper = range;
  const auto value = [&](const Column& numbers) { return std::min(impossible, cost(asEigen(numbers))); };
  return asEigen(dlib::find_min_global(value, lower, upper, dlib::max_function_calls(calls)).x);
}

} // namespace naocal

#include "writer/NoncentralityScaling.hpp"

#include <algorithm>
#include <cmath>

namespace blind {

std::vector<double> scaled(std::vector<double> values, double size) {
  for (double& value : values) {
    value *= size;
  }
  return values;
}

SizedFlaw weighFlaw(const MeasuredChange& change, const ProjectedProduct& visibility, std::vector<double> values) {
  const Eigen::VectorXd difference = change(values);
  const double noncentrality = visibility.product(difference, difference);
  // to first order: a calibration absorbs what is curved as well
  const Eigen::VectorXd slope = change(scaled(values, 0.1));
  const double known = visibility.knownProduct(slope, slope);
  return {std::move(values), noncentrality, known > 0 ? visibility.product(slope, slope) / known : 0};
}

std::optional<SizedFlaw> scaleFlaw(const MeasuredChange& change, const ProjectedProduct& visibility,
                                   const std::vector<double>& shape, double wanted, double most) {
  constexpr double closeEnough = 0.02;
  double size = 0.3;
  for (int round = 0; round < 12; ++round) {
    SizedFlaw flaw = weighFlaw(change, visibility, scaled(shape, size));
    if (std::abs(flaw.noncentrality - wanted) < closeEnough * wanted) {
      return flaw;
    }
    if (!(flaw.noncentrality > 0)) {
      return std::nullopt;
    }
    size *= std::clamp(std::sqrt(wanted / flaw.noncentrality), 0.01, 100.0);
    if (size > most) {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

std::vector<double> drawShape(const std::vector<double>& ofUnknowns, bool positive, RandomStream& chance) {
  std::vector<double> shape;
  double square = 0;
  for (std::size_t i = 0; i < ofUnknowns.size(); ++i) {
    shape.push_back(chance.normal(1));
    square += shape.back() * shape.back();
  }
  for (std::size_t i = 0; i < shape.size(); ++i) {
    shape[i] *= ofUnknowns[i] / std::sqrt(square);
    shape[i] = positive ? std::abs(shape[i]) : shape[i];
  }
  return shape;
}

} // namespace blind

#pragma once

#include "world/RandomStream.hpp"
#include "writer/ProjectedProduct.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace blind {

/// Change of all measurements by a flaw of these values.
using MeasuredChange = std::function<Eigen::VectorXd(const std::vector<double>&)>;

/// A flaw's size and visibility.
struct SizedFlaw {
  std::vector<double> values;
  double noncentrality = 0;
  double kept = 0; // fraction of the evidence left without knowing the rest of the robot
};

std::vector<double> scaled(std::vector<double> values, double size);

/// Visibility of a flaw of these values.
SizedFlaw weighFlaw(const MeasuredChange& change, const ProjectedProduct& visibility, std::vector<double> values);

/// Scales `shape` until its noncentrality is `wanted` (iterating its square law); absent if the factor exceeds `most`.
std::optional<SizedFlaw> scaleFlaw(const MeasuredChange& change, const ProjectedProduct& visibility,
                                   const std::vector<double>& shape, double wanted, double most);

/// A random direction in the space of unknowns, scaled by the size of each. `positive`: none is negative.
std::vector<double> drawShape(const std::vector<double>& ofUnknowns, bool positive, RandomStream& chance);

} // namespace blind

#include "math/LinearAlgebra.hpp"
#include "residuals/Slopes.hpp"

#include <algorithm>

namespace naocal {

namespace {

double& driverIn(Instant& instant, const Elsewhere& which) {
  switch (which.driver) {
  case Driver::torque:
    return instant.torque[at(which.joint)];
  case Driver::torqueGrowth:
    return instant.torqueGrowth[at(which.joint)];
  case Driver::com:
    return instant.com[at(which.joint)];
  default:
    return instant.q[at(which.joint)];
  }
}

double byOffset(const Driven& driven, const Elsewhere& which, std::size_t offset) {
  switch (which.driver) {
  case Driver::torque:
    return driven.torqueByOffset(at(which.joint), at(offset));
  case Driver::torqueGrowth:
    return driven.growthByOffset(at(which.joint), at(offset));
  case Driver::com:
    return driven.comByOffset(at(which.joint), at(offset));
  default:
    return driven.angleByOffset(at(which.joint), at(offset));
  }
}

/// Steps of central differences; the third derivative of tanh(tau / 0.03 Nm) asks for small ones.
double stepOf(Driver driver) {
  return driver == Driver::torque ? 3e-6 : driver == Driver::com ? 1e-5 : 1e-4; // [Nm], [m], [rad]
}

/// One correction by itself: at given values and drivers, how far it moves each of its quantities.
class Correction {
public:
  Correction(const Effect& effect, std::size_t place, const std::vector<std::size_t>& quantities, const Belief& drawn,
             Belief& scratch)
      : effect_{effect}, place_{place}, quantities_{quantities}, drawn_{drawn}, scratch_{scratch} {}

  /// Calls `take(i, change)` for the i-th quantity.
  template <typename Take> void operator()(const Instant& instant, std::span<const double> values, Take take) const {
    effect_.correct(scratch_, instant, place_, values);
    for (std::size_t i = 0; i < quantities_.size(); ++i) {
      double& value = scratch_.values[at(quantities_[i])];
      const double before = drawn_.values[at(quantities_[i])];
      take(i, value - before);
      value = before;
    }
  }

private:
  const Effect& effect_;
  std::size_t place_;
  const std::vector<std::size_t>& quantities_;
  const Belief& drawn_;
  Belief& scratch_;
};

} // namespace

void PictureSlopes::addVarying(const Model& model, const Picture& picture, const Eigen::VectorXd& unknowns,
                               Driven& driven, Scratch& scratch, Belief& belief, double* values) const {
  scratch.belief = picture.drawn;
  for (const Varying& varying : varying_) {
    const Term& term = model.terms()[varying.term];
    const std::vector<Unknown>& own = term.effect.unknowns;
    const std::size_t width = own.size() + varying.offsets.size();
    std::fill_n(values, width * varying.quantities.size(), 0);
    const Correction correction{term.effect, varying.at, varying.quantities, picture.drawn, scratch.belief};
    const std::span<const double> here = term.values(unknowns);
    correction(driven.instant, here,
               [&](std::size_t i, double change) { belief.values[at(varying.quantities[i])] += change; });
    scratch.values.assign(here.begin(), here.end());
    for (std::size_t k = 0; k < own.size(); ++k) {
      const double step = term.effect.linear ? own[k].sigma : 1e-4 * own[k].sigma;
      for (const double sign : {1.0, -1.0}) {
        scratch.values[k] = here[k] + sign * step;
        correction(driven.instant, scratch.values,
                   [&](std::size_t i, double change) { values[i * width + k] += sign * change / (2 * step); });
      }
      scratch.values[k] = here[k];
    }
    for (const Elsewhere& which : varying.drivers) {
      double& driver = driverIn(driven.instant, which);
      const double centre = driver, step = stepOf(which.driver);
      for (const double sign : {1.0, -1.0}) {
        driver = centre + sign * step;
        correction(driven.instant, here, [&](std::size_t i, double change) {
          const double slope = sign * change / (2 * step);
          for (std::size_t j = 0; j < varying.offsets.size(); ++j) {
            values[i * width + own.size() + j] += slope * byOffset(driven, which, varying.offsets[j]);
          }
        });
      }
      driver = centre;
    }
    values += width * varying.quantities.size();
  }
}

} // namespace naocal

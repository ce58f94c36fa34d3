#include "diagnose/EventFits.hpp"

#include "calibrate/Fit.hpp"
#include "io/InputError.hpp"
#include "math/Parallel.hpp"
#include "residuals/Carried.hpp"

#include <utility>

namespace naocal {

namespace {

/// First with all corners in full: what has moved has lost its weight.
FitMinimum fittedFrom(const Eigen::VectorXd& start, const Measurements& measurements, const Model& model,
                      const CalibrationResult& fit) {
  Fit full = nearlyFitted(measurements, model, fit.noise, Loss{}, start);
  return refit(measurements, model, fit.noise, fit.loss, std::move(full), nearly).minimum;
}

} // namespace

std::vector<std::optional<EventFit>> fitted(const std::vector<Event>& events, const Measurements& measurements,
                                            const Model& model, const CalibrationResult& fit) {
  const double without = fittedFrom(fit.unknowns, measurements, model, fit).linear.cost;
  std::vector<std::optional<EventFit>> result(events.size());
  inParallel(events.size(), [&](std::size_t i) {
    Model larger = model;
    larger.add(events[i].term);
    try {
      const FitMinimum minimum = fittedFrom(carried(model, fit.unknowns, larger), measurements, larger, fit);
      const Term& term = larger.terms().back();
      result[i] = {2 * (without - minimum.linear.cost),
                   minimum.state.unknowns.segment(static_cast<Eigen::Index>(term.first), term.sigmas().size())};
    } catch (const InputError&) { // nothing explains corners behind the camera
    }
  });
  return result;
}

} // namespace naocal

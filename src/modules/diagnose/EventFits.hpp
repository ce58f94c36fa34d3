#pragma once

#include "diagnose/Events.hpp"

#include <optional>
#include <vector>

namespace naocal {

/// What a fit with an event in the model says of it. Far from zero the linearised evidence takes one thing that moved
/// for another, or the moment for another.
struct EventFit {
  double fall = 0;        // of -2 ln likelihood, against the model without it
  Eigen::VectorXd values; // of the event's unknowns
};

/// Each event fitted at the noise levels and the loss of `fit`, from there. Absent where no search ends.
std::vector<std::optional<EventFit>> fitted(const std::vector<Event>& events, const Measurements& measurements,
                                            const Model& model, const CalibrationResult& fit);

} // namespace naocal

#pragma once

#include "calibration/Calibration.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// When something happened in one of the sets, since its first capture.
struct Moment {
  std::size_t set = 0;
  double time = 0;             // likeliest [s]
  double since = 0, until = 0; // surely between these times [s]
};

/// Something that happened once, as a candidate: a term that corrects from a moment on, or in a few captures only.
struct TransientEvent {
  Term term;
  std::optional<Moment> from;
  std::string who, where;    // "board B"; " of SET" where there are several
  std::size_t set = 0;       // in which it happened
  std::vector<int> captures; // ids of those it concerns, where they are few
  std::string what;          // happened in these captures: "does not belong to the rest"
  double prior = 0;          // of its moment, against others: in 2 ln of how long nothing was seen
};

/// Whether the same thing moved, at whatever moments of a set; or the same captures are meant.
bool isSameThing(const TransientEvent& one, const TransientEvent& other);

/// "board B moved by 33 mm and 0.8°, 12.3 s after the first capture (between 8.2 and 16.4 s)". `values`: of the event's
/// unknowns.
std::string describeEvent(const TransientEvent& event, const Eigen::VectorXd& values);

/// Boards, robot, cameras and joints' zeros may have moved between any two captures, at some sixteen moments each; any
/// capture may be bad, of very many the 128 with the largest errors.
std::vector<TransientEvent> enumerateEvents(const Measurements& measurements, const CalibrationResult& fit);

/// The same things at all moments between two captures, where they are many at 128 of them.
std::vector<TransientEvent> spreadOverTime(const std::vector<TransientEvent>& things, const Measurements& measurements);

/// What a fit with an event in the model says of it. Far from zero the linearised evidence takes one thing that moved
/// for another, or the moment for another.
struct EventFit {
  double fall = 0;        // of -2 ln likelihood, against the model without it
  Eigen::VectorXd values; // of the event's unknowns
};

/// Each event fitted at the noise levels and the loss of `fit`, from there. Absent where no search ends.
std::vector<std::optional<EventFit>> fitEvents(const std::vector<TransientEvent>& events, const FittedModel& fitted);

} // namespace naocal

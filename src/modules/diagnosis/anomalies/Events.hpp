#pragma once

#include "calibration/Calibration.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// A one-off event as a candidate: a term that acts from a moment on, or in a few captures only.
struct TransientEvent {
  Term term;
  std::optional<Moment> from; // start, if it persists
  std::string who, where;     // "board B"; " of SET" if there are several sets
  std::string moved = {};     // id of the board, tracker or camera that moved, of a stance; empty for other events.
                              // With `captures`: of the board that was displaced in these only
  std::size_t set = 0;        // set of the event
  std::vector<int> captures;  // ids of the affected captures, if few
  std::string what;           // description for these captures: "does not belong to the rest"
  double prior = 0;           // of its moment against others: 2 ln of the gap's relative length
};

/// Whether it is the displacement of something that stands anyhow: a board in the world, a camera beside the robot, a
/// tracker.
bool isMoveAnyhow(const TransientEvent& event);

/// Whether both concern the same object, at any moments of a set, or the same captures.
bool isSameThing(const TransientEvent& one, const TransientEvent& other);

/// "board B moved by 33 mm and 0.8° (x +31.0 ± 0.4 mm, ...), 12.3 s after the first capture (between 8.2 and 16.4 s)".
/// `values`: the event's unknowns, without sigmas where they could not be estimated.
std::string describeEvent(const TransientEvent& event, const std::vector<EventValue>& values);

/// Possible displacements of boards, robot, cameras, trackers and joint zeros, each at up to 16 moments between
/// captures, between poses first if there are more; single bad pictures (the 128 with the largest errors); and boards
/// displaced in one picture (the 48 views that lie farthest off).
std::vector<TransientEvent> enumerateEvents(const Measurements& measurements, const CalibrationResult& fit);

/// The same events at all moments between two captures, at most 128 per object: those between poses
/// first, if there are more.
std::vector<TransientEvent> spreadOverTime(const std::vector<TransientEvent>& things, const Measurements& measurements);

/// Fit with an event in the model. Far from zero the linearised evidence confuses objects and moments.
struct EventFit {
  double fall = 0;        // decrease of -2 ln likelihood against the model without the event
  Eigen::VectorXd values; // estimates of the event's unknowns
};

/// Fits each event at the noise levels and loss of `fit`, starting there. Absent if the search fails.
std::vector<std::optional<EventFit>> fitEvents(const std::vector<TransientEvent>& events, const FittedModel& fitted);

/// An event's estimates, and the noise that is left with it in the model.
struct EventEstimate {
  std::vector<EventValue> values;
  Noise noise;
  bool isRefuted = false; // nothing is left of it, or whole views of what it concerns are not where it moves them
};

/// Calibrates with the event in the model, from `start`, with all noise levels estimated anew: without it, what it did
/// counts as noise, and holds its size back. Absent if the search fails.
std::optional<EventEstimate> estimateEvent(const TransientEvent& event, const FittedModel& fitted,
                                           const Eigen::VectorXd& start);

} // namespace naocal

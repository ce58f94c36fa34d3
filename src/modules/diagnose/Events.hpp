#pragma once

#include "diagnose/Inquiry.hpp"

#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// A moment in one of the sets.
struct Moment {
  std::size_t set = 0;
  double time = 0; // [s]
};

/// Something that happened once, as a candidate: a term that corrects from a moment on, or in one capture only.
struct Event {
  Term term;
  std::optional<Moment> from;
  std::vector<int> captures; // ids of those it concerns, where they are few
  std::string sentence;      // "board B was moved after 12.3 s"
};

/// Boards and robot may have moved between any two captures, at some sixteen moments each; any capture may be bad, of
/// very many the 128 with the largest errors.
std::vector<Event> possibleEvents(const std::vector<CaptureSet>& sets, const Measurements& measurements,
                                  const CalibrationResult& fit);

/// The same thing at all moments between two captures, where they are many at 128 of them.
std::vector<Event> atAnyTime(const Event& event, const std::vector<CaptureSet>& sets, const Measurements& measurements);

/// An event, and how much likelier it is than the best effect or curve, at most 1e12 to 1.
struct LikelyEvent {
  Event event;
  double odds = 1;
};

/// The event that explains the misfit best, where it does so far better than chance and than any candidate effect.
std::optional<LikelyEvent> likeliestEvent(const std::vector<Event>& events, const Measurements& measurements,
                                          const Model& model, const CalibrationResult& fit, const Inquiry& inquiry);

} // namespace naocal

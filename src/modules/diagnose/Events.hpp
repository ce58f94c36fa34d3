#pragma once

#include "diagnose/Inquiry.hpp"

#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// Something that happened once, as a candidate: a term that corrects from a moment on, or in one capture only.
struct Event {
  Term term;
  std::vector<int> captures; // ids of those it concerns, where they are few
  std::string sentence;      // "board B was moved after 12.3 s"
};

/// Boards and robot may have moved between any two poses; any capture may be bad.
std::vector<Event> possibleEvents(const std::vector<CaptureSet>& sets, const Measurements& measurements);

/// An event, and how much likelier it is than the best effect or curve, at most 1e12 to 1.
struct LikelyEvent {
  Event event;
  double odds = 1;
};

/// The event that explains the misfit best, where it does so far better than chance and than any candidate effect.
std::optional<LikelyEvent> likeliestEvent(const std::vector<Event>& events, const Measurements& measurements,
                                          const Model& model, const CalibrationResult& fit, const Inquiry& inquiry);

} // namespace naocal

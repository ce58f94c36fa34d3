#pragma once

#include "calibration/CandidateTests.hpp"
#include "diagnosis/anomalies/Events.hpp"

#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// An event that explains the captures, with its odds against the best effect or curve, at most 1e12 to 1.
struct LikelyEvent {
  TransientEvent event;
  double odds = 1;
  double fall = 0;                     // decrease of chi2 by it
  std::string sentence;                // the event, its size and time, and alternative explanations
  std::vector<EventValue> values = {}; // of the event's unknowns; empty where only the captures are in doubt
};

/// The event that explains the misfit best, if far better than chance and than any candidate effect or curve. All
/// events are ranked by evidence linearised at the fit; the best few are fitted to determine object and moment.
/// `given`: the measurements at full weight. Where whole boards or readings lost theirs, the model is refitted to all
/// at full weight: they may be all that was seen after the event.
std::optional<LikelyEvent> findLikeliestEvent(const FittedModel& fitted, const CandidateTests& candidateTests,
                                              const Measurements& given);

} // namespace naocal

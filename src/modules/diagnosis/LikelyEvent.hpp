#pragma once

#include "diagnosis/Events.hpp"
#include "diagnosis/evidence/CandidateTests.hpp"

#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// An event that explains the captures, and how much likelier it is than the best effect or curve, at most 1e12 to 1.
struct LikelyEvent {
  TransientEvent event;
  double odds = 1;
  std::string sentence; // what happened, by how much, when, and what else it could have been
};

/// The event that explains the misfit best, where it does so far better than chance and than any candidate effect or
/// curve. The evidence of all is linearised at the fit; the best few are fitted, and those fits choose what moved and
/// when. Where the fit gave no weight to whole boards they count in full: they may be all that was seen afterwards.
std::optional<LikelyEvent> findLikeliestEvent(const FittedModel& fitted, const CandidateTests& inquiry);

} // namespace naocal

#include "diagnose/Suspicions.hpp"

#include "diagnose/Events.hpp"
#include "diagnose/SetUps.hpp"

#include <cmath>
#include <fmt/format.h>

namespace naocal {

namespace {

/// An effect of a size that no robot has but a wrong set-up does.
std::optional<Suspicion> setUpFrom(const Inquiry& inquiry) {
  constexpr double boardScale = 0.03, mirrored = -1.5;
  std::size_t best = 0;
  for (std::size_t i = 1; i < inquiry.candidates().size(); ++i) {
    if (inquiry.ofCandidate(i).likelihoodRatio > inquiry.ofCandidate(best).likelihoodRatio) {
      best = i;
    }
  }
  if (inquiry.candidates().empty()) {
    return std::nullopt;
  }
  const Term& term = inquiry.candidates()[best];
  const GroupEvidence& evidence = inquiry.ofCandidate(best);
  constexpr double beyondDoubt = 30;
  if (evidence.likelihoodRatio < beyondDoubt) {
    return std::nullopt;
  }
  if (term.effect.name == "boardScale" && std::abs(evidence.estimate[0]) > boardScale) {
    return Suspicion{{},
                     fmt::format("the squares of {} are {:.1f} % {} than the file says: measure the print and "
                                 "correct squareLength",
                                 term.at == everywhere ? "all boards" : "board " + term.place,
                                 100 * std::abs(evidence.estimate[0]),
                                 evidence.estimate[0] > 0 ? "larger" : "smaller")};
  }
  if (term.effect.name == "encoderGain" && evidence.estimate[0] < mirrored) {
    return Suspicion{{}, fmt::format("{} seems to turn the other way: its angles have the wrong sign", term.place)};
  }
  return std::nullopt;
}

/// Mirrored, a joint's gain is off by -2, of which the linearised estimate shows a good part.
bool mayBeMirrored(const Inquiry& inquiry, std::size_t motor) {
  constexpr double notable = -0.3;
  for (std::size_t i = 0; i < inquiry.candidates().size(); ++i) {
    const Term& term = inquiry.candidates()[i];
    if (term.effect.name == "encoderGain" && term.at == motor && inquiry.ofCandidate(i).freedom > 0) {
      const GroupEvidence& gain = inquiry.ofCandidate(i);
      return gain.estimate[0] - 3 * std::sqrt(gain.covariance(0, 0)) < notable;
    }
  }
  return true;
}

} // namespace

std::vector<Suspicion> suspicions(const std::vector<CaptureSet>& sets, const Measurements& measurements,
                                  const Model& model, const CalibrationResult& fit, const Inquiry& inquiry) {
  const auto mirrored = [&](std::size_t motor) { return mayBeMirrored(inquiry, motor); };
  if (const auto setUp = wrongSetUp(sets, measurements, fit.rmsPx, mirrored)) {
    return {*setUp};
  }
  if (const auto setUp = setUpFrom(inquiry)) {
    return {*setUp};
  }
  return accidents(sets, measurements, model, fit, inquiry);
}

std::vector<Suspicion> accidents(const std::vector<CaptureSet>& sets, const Measurements& measurements,
                                 const Model& model, const CalibrationResult& fit, const Inquiry& inquiry) {
  const std::vector<Event> events = possibleEvents(sets, measurements);
  const auto event = events.empty() ? std::nullopt : likeliestEvent(events, measurements, model, fit, inquiry);
  if (!event) {
    return {};
  }
  return {{event->captures.empty() ? std::nullopt : std::optional{event->captures.front()}, event->sentence}};
}

std::vector<Suspicion> movedBoards(const std::vector<CaptureSet>& sets, const Measurements& measurements,
                                   const CalibrationResult& fit) {
  std::vector<Suspicion> result;
  for (const Doubt& doubt : fit.doubts) {
    if (doubt.whole) {
      const Picture& picture = measurements.pictures[doubt.picture];
      const int id = sets[picture.set].captures[picture.capture].id;
      const std::string& board = measurements.targets[picture.sightings[doubt.sighting].view.board()].name;
      result.push_back({id, fmt::format("board {} in capture {} lies {:.0f} px from where all other captures put it: "
                                        "it or the robot was moved for a moment, or the picture is another one",
                                        board, id, doubt.distance)});
    }
  }
  return result;
}

} // namespace naocal

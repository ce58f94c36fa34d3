#include "diagnosis/anomalies/DataChecks.hpp"

#include "calibration/BoardMoves.hpp"
#include "diagnosis/anomalies/LikelyEvent.hpp"
#include "diagnosis/anomalies/MovedFar.hpp"
#include "effects/Catalogue.hpp"
#include "inference/Thresholds.hpp"
#include "io/InputError.hpp"
#include "setups/SetUpSearch.hpp"

#include <fmt/format.h>
#include <limits>

namespace naocal {

namespace {

/// rms distance of corners with the likeliest effect in the model [px]. Excludes gains: a wrong sign is a gain of -2.
double rmsBesideLikeliest(const CandidateTests& candidateTests, const Measurements& measurements, const Model& model) {
  for (const std::size_t candidate : candidateTests.candidatesByEvidence()) {
    const Term& term = candidateTests.candidates()[candidate];
    if (term.effect.name == effectName::encoderGain || candidateTests.candidateEvidence(candidate).bayes <= 0) {
      continue;
    }
    try {
      Model larger = model;
      larger.add(term);
      return calibrate(measurements, larger, {.estimateNoise = false, .testMissingEffects = false, .robust = false})
          .rmsPx;
    } catch (const InputError&) {
      break;
    }
  }
  return std::numeric_limits<double>::infinity();
}

} // namespace

std::vector<DataAnomaly> suspect(const std::vector<WrongSetUp>& setUps) {
  std::vector<DataAnomaly> result;
  for (const WrongSetUp& setUp : setUps) {
    result.push_back({.why = setUp.why,
                      .odds = setUp.odds > 0 ? std::optional{setUp.odds} : std::nullopt,
                      .setUp = setUp.label,
                      .question = setUp.question});
  }
  return result;
}

std::vector<DataAnomaly> findAnomalies(const FittedModel& fitted, const CandidateTests& candidateTests,
                                       const Measurements& given) {
  const auto setUps = findSetUps(fitted);
  return setUps.empty() ? findAccidents(fitted, candidateTests, given) : suspect(setUps);
}

std::vector<DataAnomaly> findAccidents(const FittedModel& fitted, const CandidateTests& candidateTests,
                                       const Measurements& given) {
  GrossMisfit misfit = GrossMisfit::assess(fitted.fit);
  if (misfit.rmsPx > threshold::impossiblePx) {
    misfit.explainedPx = rmsBesideLikeliest(candidateTests, fitted.measurements, fitted.model);
  }
  if (const auto moved = findMovedFar(fitted.measurements, misfit)) {
    return {*moved};
  }
  return findTransientAnomalies(fitted, candidateTests, given);
}

std::vector<DataAnomaly> findGrossAnomalies(const Measurements& measurements, const Model& model) {
  if (const auto setUps = findSetUps(measurements, model); !setUps.empty()) {
    return suspect(setUps);
  }
  const auto moved = findMovedFar(measurements, {});
  return moved ? std::vector{*moved} : std::vector<DataAnomaly>{};
}

std::vector<DataAnomaly> findSlips(const FittedModel& fitted) {
  return suspect(findSlippedCounts(fitted));
}

namespace {

/// Id of the first capture after a moment.
std::optional<int> firstCaptureAfter(const Moment& moment, const Measurements& measurements) {
  const ImageObservation* first = nullptr;
  for (const ImageObservation& picture : measurements.pictures) {
    const bool isLater = picture.set == moment.set && picture.instant.time.count() > moment.time;
    if (isLater && (!first || picture.instant.time < first->instant.time)) {
      first = &picture;
    }
  }
  return first ? std::optional{measurements.captureOf(*first).id} : std::nullopt;
}

} // namespace

std::vector<DataAnomaly> findTransientAnomalies(const FittedModel& fitted, const CandidateTests& candidateTests,
                                                const Measurements& given) {
  const auto likeliest = findLikeliestEvent(fitted, candidateTests, given);
  if (!likeliest) {
    return {};
  }
  const auto& [event, odds, fall, why, values] = *likeliest;
  if (event.captures.empty()) {
    return {DataAnomaly{.capture = {},
                        .why = why,
                        .odds = odds,
                        .when = event.from.value(),
                        .moved = event.moved,
                        .from = firstCaptureAfter(*event.from, fitted.measurements),
                        .values = values}};
  }
  std::vector<DataAnomaly> result;
  for (const int id : event.captures) {
    const std::string said = result.empty() ? why : fmt::format("capture {} was taken with it", id);
    result.push_back({.capture = id,
                      .why = said,
                      .set = event.set,
                      .odds = odds,
                      .moved = event.moved,
                      .isFurther = !result.empty(),
                      .values = values});
  }
  return result;
}

namespace {

/// With normal 95 % intervals.
std::vector<EventValue> listValues(const BoardMove& move) {
  constexpr double half = 1.96;
  std::vector<EventValue> values;
  for (const Unknown& unknown : boardMoveUnknowns(move.values.size() == 3)) {
    const auto i = static_cast<Eigen::Index>(values.size());
    const double value = move.values[i], sigma = move.sigmas[i];
    values.push_back({unknown.name, unknown.unit, value, sigma, value - half * sigma, value + half * sigma});
  }
  return values;
}

} // namespace

std::vector<DataAnomaly> findDisplacedBoards(const Measurements& measurements, const CalibrationResult& fit) {
  std::vector<DataAnomaly> result;
  for (const Outlier& outlier : fit.outliers) {
    if (outlier.whole) {
      const ImageObservation& picture = measurements.pictures[outlier.picture];
      const int id = measurements.captureOf(picture).id;
      const std::string& board = measurements.targets[picture.observations[outlier.observation].view.board()].name;
      DataAnomaly anomaly{.capture = id, .why = {}, .set = picture.set, .moved = board};
      if (outlier.move) {
        anomaly.why = describeDisplacedBoard(measurements, outlier);
        anomaly.values = listValues(*outlier.move);
      } else {
        anomaly.why = fmt::format("board {} in capture {} lies {:.0f} px from where all other captures put it: "
                                  "it or the robot was moved for a moment, or the picture is another one",
                                  board, id, outlier.distance);
      }
      result.push_back(std::move(anomaly));
    }
  }
  return result;
}

} // namespace naocal

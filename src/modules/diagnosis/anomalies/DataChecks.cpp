#include "diagnosis/anomalies/DataChecks.hpp"

#include "calibration/BoardMoves.hpp"
#include "diagnosis/anomalies/LikelyEvent.hpp"
#include "diagnosis/anomalies/SetUps.hpp"
#include "effects/Catalogue.hpp"
#include "estimation/ModelBuilder.hpp"
#include "inference/Thresholds.hpp"
#include "io/InputError.hpp"

#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace naocal {

namespace {

/// First unknown of an effect, refitted: far from zero the linearised estimate is too small. Absent if no fit is
/// possible.
std::optional<double> estimateTerm(const Term& term, const Measurements& measurements) {
  try {
    const Model model = buildModel(measurements, {term.label()});
    const std::size_t first = model.find(term.label())->first;
    return calibrate(measurements, model, {.testMissingEffects = false}).unknowns[static_cast<Eigen::Index>(first)];
  } catch (const InputError&) {
    return std::nullopt;
  }
}

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

/// A set-up error: an effect of a size that only a wrong set-up explains.
std::optional<DataAnomaly> findSetUp(const CandidateTests& candidateTests, const Measurements& measurements) {
  constexpr double boardScale = 0.03, mirrored = -1.5;
  std::size_t best = 0;
  for (std::size_t i = 1; i < candidateTests.candidates().size(); ++i) {
    if (candidateTests.candidateEvidence(i).likelihoodRatio > candidateTests.candidateEvidence(best).likelihoodRatio) {
      best = i;
    }
  }
  if (candidateTests.candidates().empty()) {
    return std::nullopt;
  }
  const Term& term = candidateTests.candidates()[best];
  const GroupEvidence& evidence = candidateTests.candidateEvidence(best);
  constexpr double beyondDoubt = 30;
  if (evidence.likelihoodRatio < beyondDoubt) {
    return std::nullopt;
  }
  if (term.effect.name == "boardScale" && std::abs(evidence.estimate[0]) > boardScale) {
    const double size = estimateTerm(term, measurements).value_or(evidence.estimate[0]);
    return DataAnomaly{{},
                       fmt::format("the squares of {} are {:.1f} % {} than the file says: measure the print and "
                                   "correct squareLength",
                                   term.placeIndex == allPlaces ? "all boards" : "board " + term.placeName,
                                   100 * std::abs(size), size > 0 ? "larger" : "smaller")};
  }
  if (term.effect.name == effectName::encoderGain && evidence.estimate[0] < mirrored) {
    return DataAnomaly{
        .why = fmt::format("{} seems to turn the other way: its angles have the wrong sign", term.placeName),
        .setUp = reversedJoint + term.placeName};
  }
  return std::nullopt;
}

/// Whether a joint may have the wrong sign: a gain of -2, of which the linearised estimate shows a good part.
bool mayBeMirrored(const CandidateTests& candidateTests, std::size_t motor) {
  constexpr double notable = -0.3;
  for (std::size_t i = 0; i < candidateTests.candidates().size(); ++i) {
    const Term& term = candidateTests.candidates()[i];
    if (term.effect.name == effectName::encoderGain && term.placeIndex == motor &&
        candidateTests.candidateEvidence(i).freedom > 0) {
      const GroupEvidence& gain = candidateTests.candidateEvidence(i);
      return gain.estimate[0] - 3 * std::sqrt(gain.covariance(0, 0)) < notable;
    }
  }
  return true;
}

} // namespace

std::vector<DataAnomaly> findAnomalies(const FittedModel& fitted, const CandidateTests& candidateTests,
                                       const Measurements& given) {
  const auto mirrored = [&](std::size_t motor) { return mayBeMirrored(candidateTests, motor); };
  GrossMisfit misfit = GrossMisfit::assess(fitted.measurements, fitted.fit, fitted.model);
  if (misfit.isGross()) {
    misfit.explainedPx = rmsBesideLikeliest(candidateTests, fitted.measurements, fitted.model);
  }
  if (const auto setUp = findSetupError(fitted.measurements, misfit, mirrored)) {
    return {*setUp};
  }
  std::vector<DataAnomaly> result = findTransientAnomalies(fitted, candidateTests, given);
  if (result.empty()) { // an accident is far likelier than any effect, if it is named
    if (const auto setUp = findSetUp(candidateTests, fitted.measurements)) {
      result.push_back(*setUp);
    }
  }
  return result;
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
  const auto& [event, odds, why, values] = *likeliest;
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
    result.push_back(
        {.capture = id, .why = said, .set = event.set, .odds = odds, .moved = event.moved, .values = values});
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

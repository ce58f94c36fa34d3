#include "calibration/result/Verdict.hpp"

#include "calibration/Uncertainty.hpp"
#include "calibration/result/Assumptions.hpp"
#include "calibration/result/Determination.hpp"
#include "calibration/result/Plausibility.hpp"
#include "calibration/result/Wording.hpp"
#include "effects/Catalogue.hpp"
#include "inference/Thresholds.hpp"
#include "io/Units.hpp"
#include "math/Angles.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace naocal {

namespace {

std::string formatDisplaced(const RejectedMeasurements& rejected) {
  return fmt::format("{} of {} board views {} not lie where the others put {}", rejected.views, rejected.ofViews,
                     rejected.views == 1 ? "does" : "do", rejected.views == 1 ? "it" : "them");
}

/// Whether more than 5 % of the board views: these are no accidents.
bool areManyDisplaced(const RejectedMeasurements& rejected) {
  constexpr double share = 0.05;
  return static_cast<double>(rejected.views) > share * static_cast<double>(rejected.ofViews);
}

/// For example "the error is 4.49 px, the noise floor 0.65 px"; of what is left where measurements that are rejected
/// raise it, after their number.
std::string formatSizes(const CalibrationResult& result) {
  constexpr double noticeable = 1.1; // ratio of the errors with and without
  const RejectedMeasurements& rejected = result.rejected;
  const std::size_t count = rejected.corners + rejected.readings;
  const bool withRejected = count > 0 && rejected.presentPx > noticeable * rejected.keptPx;
  std::vector<std::string> aside;
  if (rejected.views > 0) {
    aside.push_back(formatDisplaced(rejected));
  }
  if (withRejected) {
    aside.push_back(formatRejected(rejected));
  }
  const bool single = aside.size() == 1 && (rejected.views > 0 ? rejected.views : count) == 1;
  const std::string without =
      aside.empty() ? "" : fmt::format("{}; without {} ", joinWords(aside), single ? "it" : "them");
  const double error = withRejected ? rejected.keptPx : rejected.presentPx;
  if (!result.readings.empty() && result.residuals.empty()) {
    return fmt::format("{}the error is {}, {:.1f} times what noise explains", without,
                       formatSizes(withRejected ? rejected.keptReadings : result.readings),
                       error / result.noiseFloorPx);
  }
  return fmt::format("{}the error is {:.2f} px, the noise floor {:.2f} px", without, error, result.noiseFloorPx);
}

/// Whether what the model leaves is noise, apart from rejected measurements up to this share of all.
bool isNoise(const CalibrationResult& result, double mostRejected) {
  const double most = threshold::unexplainedNoises * result.noiseFloorPx;
  const RejectedMeasurements& rejected = result.rejected;
  return rejected.presentPx <= most || (rejected.keptPx <= most && rejected.share() <= mostRejected);
}

bool isBeyondTolerance(const CalibrationResult& result) {
  return result.task && result.task->bound > result.task->tolerance;
}

/// Whether the answer is precise enough with a cause missing: the task's bound is within its tolerance, or without a
/// task half of every offset's 95 % interval within half a degree.
bool isPreciseEnough(const Model& model, const CalibrationResult& result, const HeldOffsets& held) {
  constexpr double widest = radians(0.5); // [rad]
  if (result.task) {
    return !isBeyondTolerance(result);
  }
  return std::all_of(model.terms().begin(), model.terms().end(), [&](const Term& term) {
    if (term.effect.name != effectName::jointOffset || !term.requested || held.contains(term.first)) {
      return true;
    }
    const auto [low, high] = result.estimates[term.first].interval();
    return high - low < 2 * widest;
  });
}

/// Whether the model explains the captures, and if not, whether the answer remains reliable. `missing`: something is
/// missing for another reason.
ResultVerdict judgeExplained(const Model& model, const CalibrationResult& result, const HeldOffsets& held,
                             bool missing) {
  const bool fits =
      result.misfitLeft < threshold::mostMisfit(result.misfitFreedom) || result.rmsPx < result.noiseFloorPx;
  const bool isExplained = !missing && fits && result.noise.pose < suspectScatter;
  if (isExplained && isNoise(result, threshold::fewRejected)) {
    return ResultVerdict::good;
  }
  if (isExplained && isNoise(result, threshold::manyRejected)) { // the rest is explained, however wide the intervals
    return ResultVerdict::causeMissing;
  }
  const bool holds = result.misfitLeft < threshold::bearableMisfit && isPreciseEnough(model, result, held);
  return holds ? ResultVerdict::causeMissing : ResultVerdict::doNotUse;
}

using About = Warning::About;

void warn(About about, std::string sentence, CalibrationResult& result) {
  result.warnings.push_back({about, std::move(sentence)});
}

/// Warns of what forbids to use the result.
void forbid(About about, const std::vector<std::string>& sentences, CalibrationResult& result) {
  for (const std::string& sentence : sentences) {
    result.usable = false;
    result.reasons.push_back(sentence);
    warn(about, sentence, result);
  }
}

/// Warns of offsets that other terms imitate. The result stays usable: beside placements, which nothing holds, they
/// stay at zero; with other effects, as large as is plausible of each, they share what the captures tell.
void warnOfHeldOffsets(const Model& model, const HeldOffsets& held, CalibrationResult& result) {
  for (const Term& term : model.terms()) {
    if (const auto found = held.find(term.first); found != held.end()) {
      warn(About::offset,
           fmt::format("{} cannot be told from {}{} (±{})", describeUnknown(term, 0), describeImitator(*found->second),
                       found->second->isPlacement ? " and is held at zero" : "; only what both do together is known",
                       formatSigma(term, result.estimates[term.first].bestSigma())),
           result);
    }
  }
}

bool isLikelyBeyondTolerance(const CalibrationResult& result) {
  return result.task && result.task->sigma > result.task->tolerance;
}

/// What brings an error within the tolerance.
const char* adviseForTask(bool missing) {
  return missing ? "add the effect that is missing" : "take more poses";
}

/// Forbids results whose error is likely beyond the tolerance.
void checkTask(bool missing, CalibrationResult& result) {
  if (isLikelyBeyondTolerance(result) && !result.task->isGiven) {
    forbid(About::floor,
           {fmt::format("{}: the error, {} (1 sigma), is beyond the tolerance of {}: {}", result.task->what,
                        formatSize(result.task->sigma, "m"), formatSize(result.task->tolerance, "m"),
                        adviseForTask(missing))},
           result);
  }
}

/// The sentence about a bound beyond the tolerance, if it is. `isGiven`: of a tolerance that the user gave.
std::vector<std::string> describeBound(bool isGiven, bool missing, const CalibrationResult& result) {
  if (!isBeyondTolerance(result) || result.task->isGiven != isGiven ||
      (!isGiven && isLikelyBeyondTolerance(result))) { // said already
    return {};
  }
  return {fmt::format("{}: the bound of the error, {} (99.95 %), is beyond the tolerance of {}: {}", result.task->what,
                      formatSize(result.task->bound, "m"), formatSize(result.task->tolerance, "m"),
                      adviseForTask(missing))};
}

/// Warns of doubtful measurements of one kind: "corner", "reading".
void warnOfDoubtful(std::size_t count, const char* kind, CalibrationResult& result) {
  if (count > 0) {
    const bool single = count == 1;
    warn(About::fit,
         fmt::format("{} {}{} {} not fit the rest and got little or no weight: listed under doubtful", count, kind,
                     single ? "" : "s", single ? "does" : "do"),
         result);
  }
}

/// Warns of measurements that lie far from the likeliest explanation and share something.
void warnOfSharedCause(CalibrationResult& result) {
  if (!result.sharedCauses.empty()) {
    const SharedCause& first = result.sharedCauses.front();
    warn(About::fit,
         fmt::format(
             "the measurements that fit worst share {} (p = {:.1g}): they are no accidents, and keep their weight",
             first.driver, first.p),
         result);
  }
}

void warnOfOutliers(CalibrationResult& result) {
  std::size_t corners = 0;
  for (const Outlier& outlier : result.outliers) {
    corners += outlier.corners.size();
  }
  warnOfDoubtful(result.doubtfulReadings.size(), "reading", result);
  warnOfDoubtful(corners, "corner", result);
}

/// What `some` names and `others` does not.
std::vector<std::string> namedOnlyIn(const std::vector<std::string>& some, const std::vector<std::string>& others) {
  std::vector<std::string> result;
  std::copy_if(some.begin(), some.end(), std::back_inserter(result),
               [&](const std::string& one) { return std::find(others.begin(), others.end(), one) == others.end(); });
  return result;
}

/// The named effects that explain almost as well in place of one of the likeliest explanation's, the likeliest of each:
/// "; with b@x instead of a@x 12 %". `whole`: weight of all models that count.
std::string formatRivals(const Explanation& likeliest, const std::vector<Explanation>& explanations, double whole) {
  constexpr std::size_t most = 2;
  const double least = likeliest.weight * std::exp(-threshold::equallyLikely / 2);
  std::vector<std::string> replaced;
  std::string text;
  for (const Explanation& other : explanations) {
    const std::vector<std::string> instead = namedOnlyIn(other.effects, likeliest.effects),
                                   of = namedOnlyIn(likeliest.effects, other.effects);
    if (other.weight > least && instead.size() == 1 && of.size() == 1 && replaced.size() < most &&
        instead.front().find('@') != std::string::npos &&
        std::find(replaced.begin(), replaced.end(), of.front()) == replaced.end()) {
      replaced.push_back(of.front());
      text += fmt::format("; with {} instead of {} {:.0f} %", instead.front(), of.front(), 100 * other.weight / whole);
    }
  }
  return text;
}

/// The most probable cause of the misfit, if something is missing.
std::string formatCause(const CalibrationResult& result, bool missing) {
  // the likeliest that names something: that nothing is missing was just ruled out
  const auto found = std::find_if(result.explanations.begin(), result.explanations.end(),
                                  [](const Explanation& one) { return !one.effects.empty(); });
  if (!missing || found == result.explanations.end()) {
    return "no single cause stands out";
  }
  const Explanation& likeliest = *found;
  const bool countsAll = found == result.explanations.begin();
  double whole = 0;
  for (const Explanation& one : result.explanations) {
    whole += one.effects.empty() ? 0 : one.weight;
  }
  whole = countsAll ? 1 : whole;
  return fmt::format("most probable: {}{}{} (posterior probability {:.0f} % among the models {}{})",
                     joinWords(describeMissing(likeliest.effects)), likeliest.without.empty() ? "" : " instead of ",
                     fmt::join(likeliest.without, " and "), 100 * likeliest.weight / whole,
                     countsAll ? "considered" : "in which something is missing",
                     formatRivals(likeliest, result.explanations, whole));
}

/// Why a result must not be used whose error has an unknown cause.
std::string formatUnexplained(const CalibrationResult& result, const std::string& cause) {
  const std::string harm =
      isBeyondTolerance(result)
          ? fmt::format("the {} may be up to {} off (99.95 %; tolerance {})", result.task->what,
                        formatSize(result.task->bound, "m"), formatSize(result.task->tolerance, "m"))
          : std::string{"the offsets depend on it"};
  return fmt::format("{}; {}, and {}", formatSizes(result), cause, harm);
}

} // namespace

std::string formatVerdict(const CalibrationResult& result, const std::string& cause, const std::string& firm) {
  switch (result.verdict) {
  case ResultVerdict::good:
    return fmt::format("This calibration is good: the model explains the captures ({}).", formatSizes(result));
  case ResultVerdict::causeMissing:
    return fmt::format("Usable, but a cause is missing: {}; {}. The intervals of the offsets already include this "
                       "uncertainty. Find it with 'naocal diagnose'.",
                       formatSizes(result), cause);
  case ResultVerdict::doNotUse:
    return firm.empty() ? fmt::format("Do not use this calibration yet: {}. Find it with 'naocal diagnose'.",
                                      formatUnexplained(result, cause))
                        : fmt::format("Do not use this calibration: {}.", firm);
  }
  return {};
}

void judgeResult(const Measurements& measurements, const Model& model, CalibrationResult& result) {
  result.weak = findWeakDirections(model, result);
  result.usable = true;
  if (!result.converged) {
    forbid(About::fit, {"the search did not converge: try --restarts 20, and check the robot's model and the boards"},
           result);
  }
  forbid(About::fit, listImpossible({measurements, model, result}), result);
  const bool isCertain = !result.usable;
  const HeldOffsets held = findHeldOffsets({measurements, model, result});
  forbid(About::offset, listUndetermined({measurements, model, result}, held), result);
  const bool missing = (result.pValue <= threshold::alarm && result.matters) || !result.sharedCauses.empty();
  checkTask(missing, result);
  forbid(About::floor, describeBound(true, missing, result), result);
  result.verdict = result.usable ? judgeExplained(model, result, held, missing || areManyDisplaced(result.rejected))
                                 : ResultVerdict::doNotUse;
  // reports a missing effect before what is not learned: it implies that the offsets are uncertain
  const std::string cause = formatCause(result, missing);
  const bool isFirm = !result.usable && (isCertain || !missing);
  const bool isExplained = isCertain && missing && result.misfitLeft < threshold::bearableMisfit;
  result.sentence = formatVerdict(
      result, cause,
      isFirm ? fmt::format("{}{}{}", result.reasons.front(), isExplained ? "; " : "", isExplained ? cause : "") : "");
  result.usable = result.verdict != ResultVerdict::doNotUse;
  if (!result.usable && !isFirm) {
    result.reasons.insert(result.reasons.begin(), formatUnexplained(result, cause));
  }
  if (result.usable && result.negligible) {
    result.sentence += " " + formatNegligible(*result.negligible, errorUnitOf(measurements, result.noise));
  }
  warnOfHeldOffsets(model, held, result);
  for (const std::string& sentence : describeBound(false, missing, result)) { // decides only where a cause is missing
    warn(About::floor, sentence, result);
  }
  warnOfOutliers(result);
  warnOfSharedCause(result);
  for (const std::string& sentence : describeDisplacedBoards(measurements, result)) {
    warn(About::fit, sentence, result);
  }
  for (const std::string& sentence : describeAssumptions(measurements, model.terms())) {
    warn(About::fit, sentence, result);
  }
}

std::string toString(ResultVerdict verdict) {
  switch (verdict) {
  case ResultVerdict::good:
    return "good";
  case ResultVerdict::causeMissing:
    return "cause-missing";
  case ResultVerdict::doNotUse:
    return "do-not-use";
  }
  return {};
}

std::vector<std::string> toSentences(const std::vector<Warning>& warnings) {
  std::vector<std::string> result;
  for (const Warning& warning : warnings) {
    result.push_back(warning.sentence);
  }
  return result;
}

} // namespace naocal

#include "calibration/result/Verdict.hpp"

#include "calibration/Uncertainty.hpp"
#include "calibration/result/Determination.hpp"
#include "calibration/result/Notes.hpp"
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

/// Adds what forbids to use the result.
void forbid(std::vector<Finding> findings, CalibrationResult& result) {
  result.usable &= findings.empty();
  append(std::move(findings), result.findings);
}

bool isLikelyBeyondTolerance(const CalibrationResult& result) {
  return result.task && result.task->sigma > result.task->tolerance;
}

/// That the task's error, in words, is beyond the tolerance, and what brings it within.
Finding describeBeyond(FindingLevel level, const std::string& error, bool missing, const FittedModel& fitted) {
  const Task& task = *fitted.fit.task;
  Finding finding = makeFinding("weak", "task", level,
                                fmt::format("{}: {}, is beyond the tolerance of {}: {}", task.what, error,
                                            formatSize(task.tolerance, "m"),
                                            missing ? "add the effect that is missing" : "take more poses"),
                                fitted.measurements);
  finding.numbers = {{"sigma", task.sigma}, {"bound", task.bound}, {"tolerance", task.tolerance}};
  if (!missing) {
    finding.answers = {{"take poses", "", ""}};
  }
  return finding;
}

/// Whether the error is likely beyond the usual tolerance, which then forbids use.
std::vector<Finding> checkTask(bool missing, const FittedModel& fitted) {
  if (!isLikelyBeyondTolerance(fitted.fit) || fitted.fit.task->isGiven) {
    return {};
  }
  return {describeBeyond(FindingLevel::stop,
                         fmt::format("the error, {} (1 sigma)", formatSize(fitted.fit.task->sigma, "m")), missing,
                         fitted)};
}

/// Whether the bound is beyond the tolerance: one that the user gave forbids use; the usual one decides only where a
/// cause is missing (`judgeExplained`).
std::vector<Finding> checkBound(bool isGiven, bool missing, const FittedModel& fitted) {
  if (!isBeyondTolerance(fitted.fit) || fitted.fit.task->isGiven != isGiven ||
      (!isGiven && isLikelyBeyondTolerance(fitted.fit))) { // said already
    return {};
  }
  return {describeBeyond(isGiven ? FindingLevel::stop : FindingLevel::note,
                         fmt::format("the bound of the error, {} (99.95 %)", formatSize(fitted.fit.task->bound, "m")),
                         missing, fitted)};
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

/// The likeliest explanation that names something, if something is missing; null without one.
const Explanation* findCause(const CalibrationResult& result, bool missing) {
  const auto found = std::find_if(result.explanations.begin(), result.explanations.end(),
                                  [](const Explanation& one) { return !one.effects.empty(); });
  return missing && found != result.explanations.end() ? &*found : nullptr;
}

/// What effects, curves and motions are at: "LKneePitch" of "elasticity@LKneePitch" and of "LKneePitch over q".
std::vector<std::string> placesOf(const std::vector<std::string>& labels) {
  std::vector<std::string> places;
  for (const std::string& label : labels) {
    const std::size_t at = label.find('@');
    places.push_back(at == label.npos ? label.substr(0, label.find(' ')) : label.substr(at + 1));
  }
  return places;
}

/// A finding about the most probable cause of the misfit, yet without words.
Finding nameCause(const CalibrationResult& result, bool missing, const Measurements& measurements) {
  const Explanation* const likeliest = findCause(result, missing);
  const std::string label = likeliest == nullptr ? "" : likeliest->effects.front();
  const bool isNamed = label.find('@') != label.npos, isCurve = label.find(" over ") != label.npos;
  Finding finding;
  finding.id = isNamed                             ? "effect-missing:" + label
               : isCurve                           ? "unknown-effect:" + label
               : !label.empty()                    ? "event:" + label
               : areManyDisplaced(result.rejected) ? "accident:boards"
                                                   : "unknown-effect:misfit";
  finding.isVerdict = true;
  if (likeliest != nullptr) {
    finding.where = placeOf(fmt::format("@{}", fmt::join(placesOf(likeliest->effects), ",")), measurements);
    for (const std::string& effect : likeliest->effects) {
      if (effect.find('@') != effect.npos) {
        finding.answers.push_back({"add", "effect", effect});
      }
    }
  }
  return finding;
}

/// The most probable cause of the misfit, if something is missing.
std::string formatCause(const CalibrationResult& result, bool missing) {
  const Explanation* const found = findCause(result, missing);
  if (found == nullptr) {
    return "no single cause stands out";
  }
  const Explanation& likeliest = *found;
  const bool countsAll = found == &result.explanations.front();
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

/// The finding that is the verdict: the calibration is good, or what is missing.
Finding describeVerdict(const Measurements& measurements, bool missing, const CalibrationResult& result) {
  const std::string cause = formatCause(result, missing);
  Finding finding = result.verdict == ResultVerdict::good ? Finding{.id = "good", .isVerdict = true}
                                                          : nameCause(result, missing, measurements);
  switch (result.verdict) {
  case ResultVerdict::good:
    finding.why = formatSizes(result);
    break;
  case ResultVerdict::causeMissing:
    finding.level = FindingLevel::act;
    finding.why = fmt::format("{}; {}", formatSizes(result), cause);
    break;
  case ResultVerdict::doNotUse:
    finding.level = FindingLevel::stop;
    finding.why = formatUnexplained(result, cause);
  }
  finding.sentence = formatVerdict(result, cause, "");
  finding.numbers = {{"rmsPx", result.rmsPx}, {"noiseFloorPx", result.noiseFloorPx}, {"p", result.pValue}};
  return finding;
}

} // namespace

std::string formatVerdict(const CalibrationResult& result, const std::string& cause, const std::string& firm) {
  switch (result.verdict) {
  case ResultVerdict::good:
    return fmt::format("This calibration is good: the model explains the captures ({}).", formatSizes(result));
  case ResultVerdict::causeMissing:
    return fmt::format("Usable, but a cause is missing: {}; {}. The intervals of the offsets already include this "
                       "uncertainty.",
                       formatSizes(result), cause);
  case ResultVerdict::doNotUse:
    return firm.empty() ? fmt::format("Do not use this calibration yet: {}.", formatUnexplained(result, cause))
                        : fmt::format("Do not use this calibration: {}.", firm);
  }
  return {};
}

void judgeResult(const Measurements& measurements, const Model& model, CalibrationResult& result) {
  const FittedModel fitted{measurements, model, result};
  result.weak = findWeakDirections(model, result);
  result.usable = true;
  if (!result.converged) {
    forbid({makeFinding("not-learned", "convergence", FindingLevel::stop,
                        "the search did not converge: try random restarts, and check the robot's model and the boards",
                        measurements)},
           result);
  }
  forbid(listImpossible(fitted), result);
  const bool isCertain = !result.usable;
  const HeldOffsets held = findHeldOffsets(fitted);
  forbid(listUndetermined(fitted, held), result);
  const bool missing = (result.pValue <= threshold::alarm && result.matters) || !result.sharedCauses.empty();
  forbid(checkTask(missing, fitted), result);
  forbid(checkBound(true, missing, fitted), result);
  result.verdict = result.usable ? judgeExplained(model, result, held, missing || areManyDisplaced(result.rejected))
                                 : ResultVerdict::doNotUse;
  // tells of a missing effect before what is not learned: it implies that the offsets are uncertain
  const bool isFirm = !result.usable && (isCertain || !missing);
  result.usable = result.verdict != ResultVerdict::doNotUse;
  if (isFirm) {
    std::string reason = result.findings.front().why;
    if (isCertain && missing && result.misfitLeft < threshold::bearableMisfit) { // and a cause explains it
      Finding cause = nameCause(result, missing, measurements);
      cause.level = FindingLevel::stop;
      cause.why = formatCause(result, missing);
      cause.sentence = formatSentence(cause.why, measurements);
      reason += "; " + cause.why;
      result.findings.push_back(std::move(cause));
    }
    result.findings.front().sentence = formatVerdict(result, "", reason);
  } else {
    result.findings.insert(result.findings.begin(), describeVerdict(measurements, missing, result));
  }
  if (result.usable && result.negligible) {
    Finding finding =
        makeFinding("negligible", result.negligible->label, FindingLevel::note,
                    formatNegligible(*result.negligible, errorUnitOf(measurements, result.noise)), measurements);
    finding.isVerdict = true;
    result.findings.front().sentence += " " + finding.why;
    result.findings.push_back(std::move(finding));
  }
  append(checkBound(false, missing, fitted), result.findings);
  append(listNotes(fitted, held), result.findings);
  sortFindings(result.findings);
  result.sentence = result.findings.front().sentence;
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

} // namespace naocal

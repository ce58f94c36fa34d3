#include "diagnosis/DiagnosisWording.hpp"

#include "calibration/result/Wording.hpp"
#include "inference/Thresholds.hpp"
#include "io/Units.hpp"
#include "math/Angles.hpp"

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>

namespace naocal {

namespace {

std::string percent(double p) {
  return p < 0.01 ? "less than 1 %" : fmt::format("{:.0f} %", 100 * p);
}

/// "tangentialDistortion@camera, axisTilt@x, axisTilt@y and 2 more": what captures cannot tell an effect from.
std::string formatRivals(const std::vector<std::string>& rivals) {
  constexpr std::size_t most = 3;
  const auto shown = static_cast<std::ptrdiff_t>(std::min(most, rivals.size()));
  const std::string more = rivals.size() > most ? fmt::format(" and {} more", rivals.size() - most) : "";
  return fmt::format("{}{}", fmt::join(rivals.begin(), rivals.begin() + shown, ", "), more);
}

/// Labels of effects, each with what it cannot be told from: "a@x (or b@x: these captures cannot tell)".
std::vector<std::string> nameWithRivals(const Diagnosis& diagnosis, std::vector<std::string> labels) {
  for (std::string& label : labels) {
    const CandidateFinding* const found = findCandidate(diagnosis, label);
    if (found != nullptr && !found->equivalent.empty()) {
      label += fmt::format(" (or {}: these captures cannot tell)", formatRivals(found->equivalent));
    }
  }
  return labels;
}

std::string formatFurther(const Diagnosis& diagnosis, const std::vector<std::string>& labels) {
  return labels.empty() ? "" : fmt::format(" Also missing: {}.", fmt::join(nameWithRivals(diagnosis, labels), ", "));
}

std::string formatMissing(const Diagnosis& diagnosis) {
  const CandidateFinding& first = diagnosis.ranking.front();
  std::string text = fmt::format("{} {} missing ({}).", first.term.label(), diagnosis.isTentative ? "may be" : "is",
                                 formatSizes(first));
  if (!first.term.effect.description.empty()) {
    text += fmt::format(" That is: {}.", first.term.effect.description);
  }
  if (!first.equivalent.empty()) {
    text += fmt::format(" These captures cannot tell it from {}.", formatRivals(first.equivalent));
  }
  if (!diagnosis.rivalCurve.empty()) {
    text +=
        fmt::format(" A curve of {} explains about as much or more: the cause may be unknown.", diagnosis.rivalCurve);
  }
  if (!diagnosis.suggested.empty()) {
    text += formatFurther(diagnosis, {diagnosis.suggested.begin() + 1, diagnosis.suggested.end()});
  }
  const SelectionStep &before = diagnosis.steps.front(), &after = diagnosis.steps.back();
  const std::optional<double>& heldOut = diagnosis.suggested.empty() ? before.nextPx : after.heldOutPx;
  if (before.heldOutPx && heldOut) {
    const ErrorUnit& unit = diagnosis.unit;
    text += fmt::format(" The held-out error {} from {:.2f} to {:.2f} {unit} (noise floor: {:.2f} {unit}).",
                        *heldOut < *before.heldOutPx ? "falls" : "does not fall:", unit.perPx * *before.heldOutPx,
                        unit.perPx * *heldOut, unit.perPx * after.noiseFloorPx, fmt::arg("unit", unit.name));
  }
  return diagnosis.isTentative ? text + " The evidence is weak: take more poses before you add it." : text;
}

/// Sentence for an alarm whose best candidate is not likely enough to add.
std::string formatHardlyLikely(const Diagnosis& diagnosis) {
  const CandidateFinding& first = diagnosis.ranking.front();
  if (!first.predicts) {
    return fmt::format("Something changes over time, but not steadily, and no effect in the catalogue does so: {} ({}) "
                       "is closest, and fails to predict the last captures.",
                       first.term.label(), formatSizes(first));
  }
  return fmt::format(
      "Something may be missing (chance that noise alone looks this convincing: {}). The likeliest cause "
      "is {} ({}), but the evidence is too weak to add it: take more poses.",
      percent(diagnosis.alarm), first.term.label(), formatSizes(first));
}

/// Sentence for an effect beyond chance that hardly changes the predictions; empty without one. The alarm's small
/// probability alone would contradict the verdict.
std::string formatTrivial(const Diagnosis& diagnosis) {
  const CandidateFinding* const found = findNegligible(diagnosis);
  return found ? " " + formatNegligible({found->term.label(), formatSizes(*found), found->evidence.movedPx},
                                        diagnosis.unit)
               : "";
}

/// Why the result of a model that explains the captures must not be used all the same, or something may be missing;
/// empty if it is good.
std::string formatAgainst(const CalibrationResult& fit) {
  if (fit.verdict == ResultVerdict::good || fit.findings.empty()) {
    return "";
  }
  return fmt::format(" {}: {}.",
                     fit.verdict == ResultVerdict::doNotUse ? "Do not use this calibration all the same"
                                                            : "Yet something may be missing",
                     fit.findings.front().why);
}

std::string formatAdequate(const Diagnosis& diagnosis) {
  const ErrorUnit& unit = diagnosis.unit;
  const std::string trivial = formatTrivial(diagnosis);
  return fmt::format(
      "The model explains these captures: the error is {:.2f} {unit}, the noise floor {:.2f} {unit}.{}{}",
      unit.perPx * diagnosis.rmsPx, unit.perPx * diagnosis.lackOfFit.noiseFloorPx,
      !trivial.empty()
          ? trivial
          : fmt::format(" Pure noise produces a best candidate this strong in {} of cases.", percent(diagnosis.alarm)),
      formatAgainst(diagnosis.fit), fmt::arg("unit", unit.name));
}

/// Place and amplitude: "LKneePitch", "±0.30°".
std::pair<std::string, std::string> formatPlaceAndAmplitude(const DriverCurve& curve) {
  if (curve.unit == "m") {
    return {
        fmt::format("board {}, whose corners do not lie where its file has them (bent, badly printed or not on flat "
                    "ground?),",
                    curve.place),
        fmt::format("{} along its {} axis", formatAmplitude(curve), curve.about)};
  }
  if (curve.unit == "px") {
    return {fmt::format("the lens of camera {}", curve.place),
            fmt::format("{} along {}", formatAmplitude(curve), curve.about)};
  }
  return {curve.about.empty()
              ? curve.place
              : fmt::format("the mount of camera {}, which turns about its {} axis,", curve.place, curve.about),
          formatAmplitude(curve)};
}

/// What the catalogue explains of a misfit that has an unknown part, too.
std::string formatNamed(const Diagnosis& diagnosis, const std::vector<std::string>& named) {
  if (named.empty()) {
    return "An unknown effect: no effect in the catalogue explains the misfit.";
  }
  const SelectionStep &before = diagnosis.steps.front(),
                      &after = *std::prev(diagnosis.steps.end(), diagnosis.own ? 2 : 1);
  const std::string fall = before.heldOutPx && after.heldOutPx
                               ? fmt::format(" (the held-out error falls from {:.2f} to {:.2f} {})",
                                             diagnosis.unit.perPx * *before.heldOutPx,
                                             diagnosis.unit.perPx * *after.heldOutPx, diagnosis.unit.name)
                               : "";
  return fmt::format("{} {} missing{}, and an unknown effect beside: no effect in the catalogue explains the rest.",
                     fmt::join(nameWithRivals(diagnosis, named), " and "), named.size() > 1 ? "are" : "is", fall);
}

std::string formatUnknown(const Diagnosis& diagnosis) {
  const DriverCurve& curve = diagnosis.driverCurves.front();
  const auto [where, howFar] = formatPlaceAndAmplitude(curve);
  std::vector<std::string> named = diagnosis.suggested; // effects of the catalogue
  std::string own;
  if (diagnosis.own) {
    named.pop_back();
    own = fmt::format("As a custom effect, {}, it lowers the held-out error from {:.2f} to {:.2f} {}.",
                      diagnosis.own->label, diagnosis.unit.perPx * *std::prev(diagnosis.steps.end(), 2)->heldOutPx,
                      diagnosis.unit.perPx * *diagnosis.own->step.heldOutPx, diagnosis.unit.name);
  }
  return fmt::format("{} It sits at {} and varies with {} ({}), by about {}{}.{}", formatNamed(diagnosis, named), where,
                     curve.driver, curve.what, howFar, curve.expression.empty() ? "" : "; like " + curve.expression,
                     own.empty() ? "" : " " + own);
}

} // namespace

std::string toString(Verdict verdict) {
  switch (verdict) {
  case Verdict::adequate:
    return "adequate";
  case Verdict::effectMissing:
    return "effect-missing";
  case Verdict::unknownEffect:
    return "unknown-effect";
  case Verdict::scatter:
    return "scatter";
  case Verdict::inconclusive:
    return "inconclusive";
  case Verdict::badCaptures:
    return "bad-captures";
  }
  return {};
}

std::string toString(CandidateState state) {
  switch (state) {
  case CandidateState::present:
    return "present";
  case CandidateState::aliased:
    return "aliased";
  case CandidateState::trivial:
    return "trivial";
  case CandidateState::absent:
    return "absent";
  case CandidateState::inconclusive:
    return "inconclusive";
  case CandidateState::absorbed:
    return "absorbed";
  case CandidateState::noData:
    return "no-data";
  }
  return {};
}

std::string describeState(CandidateState state) {
  switch (state) {
  case CandidateState::present:
    return "needed";
  case CandidateState::aliased:
    return "could explain";
  case CandidateState::trivial:
    return "too small to matter";
  case CandidateState::absent:
    return "ruled out";
  case CandidateState::inconclusive:
    return "undecided";
  case CandidateState::absorbed:
    return "not testable here";
  case CandidateState::noData:
    return "no data";
  }
  return {};
}

const CandidateFinding* findCandidate(const Diagnosis& diagnosis, const std::string& label) {
  const auto found = std::find_if(diagnosis.ranking.begin(), diagnosis.ranking.end(),
                                  [&](const CandidateFinding& one) { return one.term.label() == label; });
  return found == diagnosis.ranking.end() ? nullptr : &*found;
}

const CandidateFinding* findNegligible(const Diagnosis& diagnosis) {
  const bool isThere = diagnosis.alarm <= threshold::alarm && !diagnosis.ranking.empty() &&
                       diagnosis.ranking.front().state == CandidateState::trivial;
  return isThere ? &diagnosis.ranking.front() : nullptr;
}

CandidateState shownState(const CandidateFinding& finding, const Diagnosis& diagnosis) {
  const auto isPresent = [](const CandidateFinding& one) { return one.state == CandidateState::present; };
  const bool areSeveral =
      diagnosis.steps.size() == 1 && std::count_if(diagnosis.ranking.begin(), diagnosis.ranking.end(), isPresent) > 1;
  const bool isUnknown = diagnosis.verdict == Verdict::unknownEffect &&
                         std::find(diagnosis.suggested.begin(), diagnosis.suggested.end(), finding.term.label()) ==
                             diagnosis.suggested.end();
  return !isPresent(finding)                  ? finding.state
         : diagnosis.isTentative || isUnknown ? CandidateState::inconclusive
         : areSeveral                         ? CandidateState::aliased
                                              : CandidateState::present;
}

std::vector<std::string> mendableSetUps(const Diagnosis& diagnosis) {
  std::vector<std::string> labels;
  for (const DataAnomaly& anomaly : diagnosis.anomalies) {
    if (!anomaly.setUp.empty()) {
      labels.push_back(anomaly.setUp);
    }
  }
  return labels;
}

std::string summarizeUnfitted(const Diagnosis& diagnosis) {
  const std::vector<std::string> setUps = mendableSetUps(diagnosis);
  return setUps.empty() ? diagnosis.sentence
                        : fmt::format("{} These captures cannot be fitted as they are: mend them with 'naocal solve "
                                      "SET --with {} -o result.json'.",
                                      diagnosis.sentence, fmt::join(setUps, ","));
}

std::string formatAmplitude(const DriverCurve& curve) {
  const auto [unit, scale] = displayUnit(curve.unit);
  return appendUnit(fmt::format("±{:.2f}", scale * curve.amplitude), unit);
}

bool isTold(const CandidateFinding& finding, std::size_t unknown) {
  const auto row = static_cast<Eigen::Index>(unknown);
  return finding.evidence.estimate.size() > row &&
         isTold(finding.term.effect.unknowns[unknown], finding.evidence.covariance(row, row));
}

std::string formatSizes(const CandidateFinding& finding) {
  return formatSizes(finding.term.effect, finding.evidence.estimate, finding.evidence.covariance);
}

std::string formatDetectable(const CandidateFinding& finding) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < finding.minimalDetectable.size(); ++i) {
    const Unknown& unknown = finding.term.effect.unknowns.at(i);
    const auto [unit, scale] = displayUnit(unknown.unit);
    parts.push_back(appendUnit(fmt::format("{} = {:.2g}", unknown.name, scale * finding.minimalDetectable[i]), unit));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string describeAnomalies(const std::vector<DataAnomaly>& anomalies) {
  std::vector<std::string> setUps;
  for (const DataAnomaly& anomaly : anomalies) {
    if (!anomaly.setUp.empty()) {
      setUps.push_back(anomaly.why);
    }
  }
  const auto count =
      std::count_if(anomalies.begin(), anomalies.end(), [](const DataAnomaly& one) { return !one.isFurther; });
  return !setUps.empty() ? fmt::format("{}", fmt::join(setUps, "; and "))
         : count > 1     ? fmt::format("{}; and {} more", anomalies.front().why, count - 1)
                         : anomalies.front().why;
}

std::string formatAnomalies(const std::vector<DataAnomaly>& anomalies) {
  return fmt::format("Something is wrong with the captures or the set-up: {}.", describeAnomalies(anomalies));
}

bool areBeside(const Diagnosis& diagnosis) {
  return diagnosis.anomaliesBeside && !diagnosis.suggested.empty() && !diagnosis.own;
}

std::string summarize(const Diagnosis& diagnosis) {
  switch (diagnosis.verdict) {
  case Verdict::badCaptures:
    if (diagnosis.hasStillJoints) {
      return formatAdequate(diagnosis);
    }
    return areBeside(diagnosis) ? fmt::format("{} Besides, something is wrong with the captures: {}.",
                                              formatMissing(diagnosis), describeAnomalies(diagnosis.anomalies))
                                : formatAnomalies(diagnosis.anomalies) + formatFurther(diagnosis, diagnosis.suggested);
  case Verdict::unknownEffect:
    return formatUnknown(diagnosis);
  case Verdict::effectMissing:
    return formatMissing(diagnosis);
  case Verdict::scatter:
    return fmt::format("Joint scatter: joints deflect at random from pose to pose by {:.3f}° (1 sigma), and nothing "
                       "recorded explains it: stiction or a slipping foot. Repeatability limits this robot, "
                       "not the model.{}",
                       degrees(diagnosis.scatter), formatTrivial(diagnosis));
  case Verdict::inconclusive:
    if (diagnosis.unexplained && !diagnosis.ranking.empty()) {
      return formatHardlyLikely(diagnosis);
    }
    return fmt::format(
        "Undecided: the model does not fit (p = {:.1g}), but no single cause stands out. Take more poses.",
        diagnosis.lackOfFit.pValue);
  case Verdict::adequate:
    return formatAdequate(diagnosis);
  }
  return {};
}

} // namespace naocal

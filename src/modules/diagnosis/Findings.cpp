#include "diagnosis/Findings.hpp"

#include "diagnosis/DiagnosisWording.hpp"
#include "setups/LeftOut.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <utility>

namespace naocal {

namespace {

/// Kind and label of something suspicious.
std::pair<std::string, std::string> nameAnomaly(const DataAnomaly& anomaly, const Measurements& measurements) {
  if (!anomaly.setUp.empty()) {
    return {"set-up", anomaly.setUp};
  }
  if (anomaly.capture) {
    return {"accident", fmt::format("capture-{}{}", nameCapture(measurements, anomaly.set, *anomaly.capture),
                                    anomaly.moved.empty() ? "" : "@" + anomaly.moved)};
  }
  return {"event", anomaly.moved.empty() ? "captures" : anomaly.moved};
}

/// Adds a capture that is concerned, and that it can be left out; of a displaced board's this is done already.
void addCapture(const DataAnomaly& anomaly, const Measurements& measurements, Finding& finding) {
  finding.where.captures.push_back(*anomaly.capture);
  for (const Capture& capture : (*measurements.sets)[anomaly.set].captures) {
    if (capture.id == *anomaly.capture) {
      finding.where.poses = {capture.pose};
    }
  }
  if (anomaly.moved.empty()) {
    const std::string name = nameCapture(measurements, anomaly.set, *anomaly.capture);
    finding.answers = {{"leave out", "label",
                        finding.answers.empty() ? leaveOutLabel(name) : finding.answers.front().what + "," + name}};
  }
}

Finding describeAnomaly(const DataAnomaly& anomaly, const Measurements& measurements) {
  const auto [kind, label] = nameAnomaly(anomaly, measurements);
  Finding finding = makeFinding(kind, label, FindingLevel::stop, anomaly.why, measurements);
  if (!anomaly.moved.empty()) {
    finding.where = placeOf(anomaly.moved, measurements);
  }
  if (anomaly.capture) {
    addCapture(anomaly, measurements, finding);
  }
  if (!anomaly.setUp.empty()) {
    finding.answers = {{"mend", "setUp", anomaly.setUp}};
  }
  if (anomaly.odds) {
    finding.numbers = {{"odds", *anomaly.odds}};
  }
  return finding;
}

std::optional<FindingLook> lookAt(const std::string& label, const Diagnosis& diagnosis) {
  for (const PartialResidual& cause : diagnosis.figures.causes) {
    if (cause.label == label) {
      return FindingLook{cause.error, cause.over};
    }
  }
  return std::nullopt;
}

/// One effect that is missing.
Finding describeEffect(const std::string& label, FindingLevel level, const Diagnosis& diagnosis,
                       const Measurements& measurements) {
  const CandidateFinding* const candidate = findCandidate(diagnosis, label);
  Finding finding =
      makeFinding("effect-missing", label, level,
                  fmt::format("{} {} missing{}", label, diagnosis.isTentative ? "may be" : "is",
                              candidate == nullptr ? std::string{} : fmt::format(" ({})", formatSizes(*candidate))),
                  measurements);
  finding.look = lookAt(label, diagnosis);
  finding.answers = {{"add", "effect", label}};
  if (candidate != nullptr) {
    finding.numbers["evidence"] = candidate->evidence.bayes;
  }
  return finding;
}

/// What is missing: the effects to add, or where none may be added the likeliest.
std::vector<Finding> listMissing(FindingLevel level, const Diagnosis& diagnosis, const Measurements& measurements) {
  std::vector<std::string> labels = diagnosis.suggested;
  if (diagnosis.own) { // `describeUnknown`
    labels.pop_back();
  }
  if (labels.empty() && diagnosis.verdict == Verdict::effectMissing && !diagnosis.ranking.empty()) {
    labels = {diagnosis.ranking.front().term.label()};
  }
  std::vector<Finding> findings;
  for (const std::string& label : labels) {
    findings.push_back(describeEffect(label, level, diagnosis, measurements));
  }
  return findings;
}

/// A misfit that no named effect explains: where it sits, if that is known.
Finding describeUnknown(FindingLevel level, const Diagnosis& diagnosis, const Measurements& measurements) {
  std::string label = "misfit";
  if (diagnosis.verdict == Verdict::unknownEffect) {
    label = fmt::format("{} over {}", diagnosis.driverCurves.front().place, diagnosis.driverCurves.front().driver);
  } else if (diagnosis.unexplained && !diagnosis.ranking.empty()) {
    const CandidateFinding& likeliest = diagnosis.ranking.front();
    label = likeliest.predicts ? likeliest.term.label() : "time";
  }
  Finding finding = makeFinding("unknown-effect", label, level, diagnosis.sentence, measurements);
  finding.look = lookAt(label, diagnosis);
  finding.answers = {{"take poses", "", ""}};
  if (diagnosis.own) {
    finding.answers.push_back({"add", "effect", diagnosis.own->label});
  }
  return finding;
}

/// The verdict as findings, its own first.
std::vector<Finding> describeVerdict(const Diagnosis& diagnosis, const Measurements& measurements) {
  const bool isUsable = diagnosis.fit.usable && diagnosis.verdict != Verdict::badCaptures;
  const FindingLevel level = isUsable ? FindingLevel::act : FindingLevel::stop;
  std::vector<Finding> missing = listMissing(level, diagnosis, measurements), findings;
  switch (diagnosis.verdict) {
  case Verdict::badCaptures:
    findings = listAnomalies(diagnosis.anomalies, measurements);
    if (areBeside(diagnosis)) { // the effects explain more
      std::swap(findings, missing);
    }
    break;
  case Verdict::unknownEffect:
  case Verdict::inconclusive:
    findings = {describeUnknown(level, diagnosis, measurements)};
    std::swap(findings, missing); // what has a name is told first
    break;
  case Verdict::scatter:
    findings = {makeFinding("noise", "joint-scatter", level, diagnosis.sentence, measurements)};
    findings.front().numbers = {{"scatter", diagnosis.scatter}};
    break;
  case Verdict::adequate:
    if (diagnosis.fit.verdict == ResultVerdict::good) {
      findings = {Finding{.id = "good", .why = diagnosis.sentence, .sentence = diagnosis.sentence}};
    } else if (!diagnosis.fit.findings.empty()) { // why it is not
      findings = {diagnosis.fit.findings.front()};
    }
    break;
  case Verdict::effectMissing:
    break;
  }
  append(std::move(missing), findings);
  return findings;
}

/// Of an effect that is certain, but too small to matter.
std::vector<Finding> listNegligible(const Diagnosis& diagnosis, const Measurements& measurements) {
  const CandidateFinding* const found = findNegligible(diagnosis);
  if (found == nullptr || (diagnosis.verdict != Verdict::adequate && diagnosis.verdict != Verdict::scatter)) {
    return {};
  }
  const std::string label = found->term.label();
  Finding finding = makeFinding("negligible", label, FindingLevel::note,
                                formatNegligible({label, formatSizes(*found), found->evidence.movedPx}, diagnosis.unit),
                                measurements);
  finding.numbers = {{"evidence", found->evidence.bayes}, {"movedPx", found->evidence.movedPx}};
  finding.look = lookAt(label, diagnosis);
  return {std::move(finding)};
}

} // namespace

std::vector<Finding> listAnomalies(const std::vector<DataAnomaly>& anomalies, const Measurements& measurements) {
  std::vector<Finding> findings;
  for (const DataAnomaly& anomaly : anomalies) {
    if (anomaly.isFurther && !findings.empty()) {
      addCapture(anomaly, measurements, findings.back());
    } else {
      findings.push_back(describeAnomaly(anomaly, measurements));
    }
  }
  std::stable_partition(findings.begin(), findings.end(), // as the sentence tells of these alone
                        [](const Finding& one) { return one.kind() == "set-up"; });
  findings.front().sentence = formatAnomalies(anomalies);
  return findings;
}

std::vector<Finding> listFindings(const Diagnosis& diagnosis, const Measurements& measurements) {
  std::vector<Finding> findings = describeVerdict(diagnosis, measurements),
                       further = furtherThanVerdict(diagnosis.fit.findings, measurements);
  for (Finding& finding : findings) { // what is impossible of the fit, under its own name
    const auto same = std::find_if(further.begin(), further.end(),
                                   [&](const Finding& one) { return !one.why.empty() && one.why == finding.why; });
    finding = same == further.end() ? finding : *same;
  }
  appendNew(listNegligible(diagnosis, measurements), findings);
  if (mendableSetUps(diagnosis).empty()) { // of a fit to a wrong set-up nothing holds
    appendNew(std::move(further), findings);
  }
  appendNew(diagnosis.assumptions, findings);
  sortFindings(findings);
  findings.front().sentence = diagnosis.sentence;
  return findings;
}

} // namespace naocal

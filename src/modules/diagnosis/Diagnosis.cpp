#include "diagnosis/Diagnosis.hpp"

#include "calibration/Outliers.hpp"
#include "diagnosis/DataChecks.hpp"
#include "diagnosis/DiagnosisWording.hpp"
#include "diagnosis/OwnEffect.hpp"
#include "diagnosis/SetUps.hpp"
#include "diagnosis/StepwiseSelection.hpp"
#include "diagnosis/views/DriverCurves.hpp"
#include "estimation/ModelBuilder.hpp"
#include "inference/DriverBasis.hpp"
#include "inference/Thresholds.hpp"
#include "io/InputError.hpp"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <list>

namespace naocal {

namespace {

/// A model, its fit, and its candidate tests.
struct DiagnosedModel {
  FittedModel fitted;
  const CandidateTests& candidateTests;
};

/// Whether a curve of the map explains the misfit better than `candidate` and than any other named effect, transient
/// effects aside (they do not predict). The required lead grows with the evidence: a free curve mimics several effects
/// at once, which are then named one by one.
bool isUnknown(const CandidateTests& candidateTests, std::optional<std::size_t> candidate) {
  const GroupEvidence& best = candidateTests.curveEvidence(candidateTests.curvesByEvidence().front());
  const double curve = best.matters() ? best.bayes : 0;
  double named = candidate ? candidateTests.candidateEvidence(*candidate).bayes : -threshold::unnamed;
  for (std::size_t i = 0; i < candidateTests.candidates().size(); ++i) {
    named = isTransient(candidateTests.candidates()[i].effect)
                ? named
                : std::max(named, candidateTests.candidateEvidence(i).bayes);
  }
  return curve > 0 && curve - named > std::max(threshold::unnamed, named * named / threshold::unnamedGrowth);
}

/// Whether a named effect elsewhere has so much evidence (more than twice the field's) that the field may be its
/// consequence, or can wait until the effect is added.
bool explains(const CandidateTests& candidateTests, std::optional<std::size_t> candidate, const ImageField& field) {
  if (!candidate) {
    return false;
  }
  const Term& term = candidateTests.candidates()[*candidate];
  const EffectSite of = field.of == ImageField::Of::camera ? EffectSite::camera : EffectSite::board;
  const bool samePlace = term.effect.place == of && term.site == field.at;
  return !samePlace && candidateTests.candidateEvidence(*candidate).bayes > 2 * field.fit.bayes;
}

/// The field, unless it is the weak remainder of a field already explained. `most`: largest evidence of all fields so
/// far.
std::optional<ImageField> noteworthyField(const std::optional<ImageField>& field, double& most) {
  most = std::max(most, field ? field->fit.bayes : 0);
  return field && field->fit.bayes < threshold::fieldRemainder * most ? std::nullopt : field;
}

/// `missing`: a named effect explains the misfit. `unknown`: only an unnamed curve does.
Verdict verdictOf(const Diagnosis& diagnosis, double misfitLeft, bool missing, bool unknown) {
  if (!diagnosis.anomalies.empty()) {
    return Verdict::badCaptures;
  }
  if (unknown) {
    return Verdict::unknownEffect;
  }
  if (missing) {
    return Verdict::effectMissing;
  }
  // sharp corners share errors below the noise floor: lens distortion that the model lacks, detector bias
  const bool matters = diagnosis.rmsPx > diagnosis.lackOfFit.noiseFloorPx;
  if (diagnosis.unexplained || (misfitLeft > threshold::misfit && matters)) {
    return Verdict::inconclusive;
  }
  return diagnosis.fit.scatter > threshold::scatterRatio ? Verdict::scatter : Verdict::adequate;
}

/// Appends anomalies of captures without an earlier anomaly.
void appendNewAnomalies(const std::vector<DataAnomaly>& further, std::vector<DataAnomaly>& suspicious) {
  const std::vector<DataAnomaly> before = suspicious;
  std::copy_if(further.begin(), further.end(), std::back_inserter(suspicious), [&](const DataAnomaly& one) {
    return std::none_of(before.begin(), before.end(),
                        [&](const DataAnomaly& other) { return other.capture == one.capture; });
  });
}

/// Diagnosis of captures without a feasible fit.
Diagnosis diagnoseUnfittable(const Measurements& measurements, const InputError& error) {
  Diagnosis result;
  result.verdict = Verdict::badCaptures;
  const auto setUp = findSetupError(measurements, {}, [](std::size_t) { return true; });
  result.anomalies.push_back(setUp.value_or(DataAnomaly{{}, error.what()}));
  result.sentence = summarize(result);
  return result;
}

Figures::Left buildResidualViews(const DiagnosedModel& diagnosed) {
  const FittedModel& fitted = diagnosed.fitted;
  return {computeJointCorrections(fitted.measurements, diagnosed.candidateTests), computeResidualField(fitted),
          estimateBoardShapes(fitted)};
}

/// Adds the figures to a finished diagnosis: captures per pose, correlations of the first candidates, their signatures,
/// and the residuals of both models. `given`: the model as given.
void assembleFigures(const DiagnosedModel& given, const DiagnosedModel& last, Diagnosis& diagnosis) {
  constexpr std::size_t compared = 12, shown = 10;
  diagnosis.figures.taken = indexCaptures(given.fitted.measurements);
  std::vector<std::string> labels;
  std::vector<std::size_t> candidates;
  std::vector<CandidateFinding*> findings;
  for (CandidateFinding& finding : diagnosis.ranking) {
    labels.push_back(finding.term.label());
    if (const auto candidate = given.candidateTests.findCandidate(labels.back());
        candidate && candidates.size() < shown) {
      candidates.push_back(*candidate);
      findings.push_back(&finding);
    }
  }
  diagnosis.figures.aliases = computeAliasMatrix(given.candidateTests, labels, compared);
  std::vector<EffectSignature> looks = computeSignatures(given.fitted, given.candidateTests, candidates);
  for (std::size_t i = 0; i < looks.size(); ++i) {
    findings[i]->imprint = std::move(looks[i]);
  }
  diagnosis.figures.recorded = collectDrivers(given.fitted.measurements, given.fitted.model, given.fitted.fit.unknowns);
  diagnosis.figures.given = buildResidualViews(given);
  if (!diagnosis.suggested.empty()) {
    diagnosis.figures.last = buildResidualViews(last);
  }
}

/// Main loop: tests the model and adds missing effects until the alarm stops; then takes back additions that do not
/// hold, and describes what is left.
Diagnosis diagnoseModel(const Measurements& measurements, const Model& asked, const DiagnosisOptions& options) {
  Diagnosis result;
  StepwiseSelection selection{measurements, asked, options};
  result.fit = selection.fit();
  result.rmsPx = result.fit.rmsPx;
  bool unknown = false;
  double most = 0;                    // largest evidence of a field within pictures so far
  std::list<CandidateTests> allTests; // tests of the model as given, and of the latest model
  while (true) {
    if (allTests.size() > 1) {
      allTests.pop_back();
    }
    const FittedModel fitted{measurements, selection.model(), selection.fit()};
    const CandidateTests& candidateTests =
        allTests.emplace_back(fitted, selection.testableTerms(), options.candidateTests);
    selection.recordStep(candidateTests, result);
    if (result.steps.size() == 1) {
      result.anomalies = findAnomalies(fitted, candidateTests);
      result.alarm = candidateTests.evidence().pValue;
    } else { // the misfit of the effect added last may have masked an accident
      result.anomalies = findTransientAnomalies(fitted, candidateTests);
    }
    const std::optional<ImageField> field = noteworthyField(findStrikingField(fitted), most);
    const double level = result.suggested.empty() ? options.alarm : threshold::laterAlarm * options.alarm;
    const bool striking = candidateTests.evidence().pValue <= level && candidateTests.evidence().matters;
    const bool alarm = (striking || field) && result.anomalies.empty();
    const std::optional<StepwiseSelection::Choice> next = alarm ? selection.chooseNext(candidateTests) : std::nullopt;
    const std::optional<std::size_t> candidate = next ? std::optional{next->candidate} : std::nullopt;
    if (alarm && candidateTests.curveCount() > 0) {
      unknown = isUnknown(candidateTests, candidate);
    }
    const bool unknownField = alarm && field && !explains(candidateTests, candidate, *field) &&
                              selection.fieldPersists(*field, candidateTests);
    unknown = unknown || unknownField;
    const bool grows = options.extend && (!options.shouldContinue || options.shouldContinue());
    if (!grows || !alarm || unknown || !candidate || !selection.add(candidateTests, *next, result)) {
      if (selection.removeLastAdditions(result)) {
        unknown = false;
        continue;
      }
      auto [cells, best] = mapDrivers(candidateTests, measurements);
      result.driverScores = std::move(cells);
      result.driverCurves = std::move(best);
      if (unknownField) {
        result.driverCurves.insert(result.driverCurves.begin(), curveFromField(*field, measurements));
      }
      result.scatter = selection.fit().noise.pose;
      const bool lasting = !result.anomalies.empty() && !result.anomalies.front().capture; // then all seem displaced
      if (!unknown && !lasting && (result.suggested.empty() || !striking)) {
        appendNewAnomalies(findDisplacedBoards(measurements, selection.refitWithoutDisplacedBoards()),
                           result.anomalies);
      }
      const bool missing = !result.suggested.empty() || (!grows && candidate);
      result.unexplained = alarm && !candidate && !unknown && !missing;
      result.verdict = verdictOf(result, selection.fit().misfit, missing, unknown);
      result.with = selection.added();
      if (unknown && !unknownField && grows) {
        result.own = fitOwnEffect(result.driverCurves.front(), measurements, selection, result, options.candidateTests);
      }
      const std::vector<std::string> leading = result.suggested.empty() && candidate
                                                   ? std::vector{candidateTests.candidates()[*candidate].label()}
                                                   : result.suggested;
      result.ranking =
          judgeCandidates(selection.findings(), candidateTests, selection.model(), selection.fit(), leading);
      if (result.own) {
        result.suggested.push_back(result.own->label);
        result.steps.push_back(result.own->step);
      }
      break;
    }
  }
  result.lastFit = selection.fit();
  assembleFigures({{measurements, asked, result.fit}, allTests.front()},
                  {{measurements, selection.model(), result.lastFit}, allTests.back()}, result);
  result.sentence = summarize(result);
  return result;
}

/// Whether an accident spoiled specific captures only.
bool isSpoiled(const DataAnomaly& suspicion) {
  return suspicion.capture && suspicion.odds;
}

/// Removes the corners of these captures.
Measurements excludeSuspicious(const std::vector<DataAnomaly>& suspicious, Measurements measurements) {
  for (std::size_t index = 0; index < measurements.pictures.size(); ++index) {
    const ImageObservation& picture = measurements.pictures[index];
    const int id = measurements.captureOf(picture).id;
    const bool spoiled = std::any_of(suspicious.begin(), suspicious.end(), [&](const DataAnomaly& suspicion) {
      return isSpoiled(suspicion) && suspicion.capture == id && suspicion.set == picture.set;
    });
    for (std::size_t observation = 0; spoiled && observation < picture.observations.size(); ++observation) {
      excludeObservation(measurements, {index, observation});
    }
  }
  return measurements;
}

/// Copies each candidate's evidence against the model as given from `all`, the diagnosis of all captures, into `left`,
/// the diagnosis without spoiled ones.
void copyLoneEvidence(const std::vector<CandidateFinding>& all, std::vector<CandidateFinding>& left) {
  for (CandidateFinding& finding : left) {
    const auto same = std::find_if(all.begin(), all.end(), [&](const CandidateFinding& other) {
      return other.term.label() == finding.term.label();
    });
    if (same != all.end()) {
      finding.alone = same->alone;
      finding.evidence = finding.step == 0 && finding.state != CandidateState::noData ? same->alone : finding.evidence;
    }
  }
}

/// Repeats the diagnosis without captures spoiled by an accident, to find other missing effects.
Diagnosis diagnoseWithoutSpoiled(const Measurements& measurements, const Model& asked,
                                 const DiagnosisOptions& options) {
  constexpr int most = 4; // accidents
  Diagnosis result = diagnoseModel(measurements, asked, options);
  std::ptrdiff_t known = 0; // suspicions
  for (int round = 0; options.extend && round < most; ++round) {
    if (std::none_of(result.anomalies.begin() + known, result.anomalies.end(), isSpoiled)) {
      break;
    }
    known = std::ssize(result.anomalies);
    Diagnosis next = diagnoseModel(excludeSuspicious(result.anomalies, measurements), asked, options);
    appendNewAnomalies(next.anomalies, result.anomalies);
    next.anomalies = result.anomalies;
    next.alarm = result.alarm;
    copyLoneEvidence(result.ranking, next.ranking);
    next.verdict = Verdict::badCaptures;
    next.sentence = summarize(next);
    result = std::move(next);
  }
  return result;
}

} // namespace

Diagnosis diagnose(const Measurements& measurements, const DiagnosisOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  const Model asked = buildModel(measurements, options.with, options.without, options.effects);
  Diagnosis result;
  try {
    result = diagnoseWithoutSpoiled(measurements, asked, options);
  } catch (const InputError& error) {
    if (measurements.cornerCount == 0) {
      throw;
    }
    result = diagnoseUnfittable(measurements, error);
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

} // namespace naocal

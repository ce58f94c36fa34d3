#include "diagnosis/Diagnosis.hpp"

#include "calibration/ModelUncertainty.hpp"
#include "calibration/Outliers.hpp"
#include "calibration/result/Assumptions.hpp"
#include "calibration/result/Determination.hpp"
#include "calibration/result/Plausibility.hpp"
#include "diagnosis/CandidateJudgement.hpp"
#include "diagnosis/DiagnosisFigures.hpp"
#include "diagnosis/DiagnosisWording.hpp"
#include "diagnosis/Findings.hpp"
#include "diagnosis/OwnEffect.hpp"
#include "diagnosis/StepwiseSelection.hpp"
#include "diagnosis/anomalies/DataChecks.hpp"
#include "diagnosis/views/DriverCurves.hpp"
#include "estimation/CandidateTerms.hpp"
#include "estimation/ModelBuilder.hpp"
#include "inference/Thresholds.hpp"
#include "io/InputError.hpp"
#include "math/Angles.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>

namespace naocal {

namespace {

/// The likeliest curve, and its evidence in the sum of the explanations, where each choice has its price
/// (`searchModelWindow`): comparable with the evidence of named effects together.
struct LikelyCurve {
  std::size_t curve;
  double evidence;
};

std::optional<LikelyCurve> findLikeliestCurve(const CandidateTests& candidateTests) {
  if (candidateTests.curveCount() == 0) {
    return std::nullopt;
  }
  const std::size_t curve = candidateTests.curvesByEvidence().front();
  const ColumnGroup& group = candidateTests.problem().groups[candidateTests.candidates().size() + curve];
  const double price = threshold::unnamed + 2 * std::log(static_cast<double>(candidateTests.curveCount())) -
                       2 * std::log(static_cast<double>(group.choices)); // paid already
  return LikelyCurve{curve, candidateTests.curveEvidence(curve).bayes - price};
}

/// Whether a curve of the map explains the misfit better than named effects: likelier than the likeliest together, and
/// clearly better than these and than any alone, those aside that the selection refutes; transient effects, which do
/// not predict, count against curves over time and temperature, which do not either. The required lead grows with their
/// evidence: a free curve mimics more effects than an explanation may have, which are then named one by one. `isNamed`:
/// whether any can be named.
bool isUnknown(const CandidateTests& candidateTests, bool isNamed, const StepwiseSelection& selection) {
  const double together = selection.namedEvidence();
  const std::optional<LikelyCurve> likeliest = findLikeliestCurve(candidateTests);
  if (!likeliest || !candidateTests.curveEvidence(likeliest->curve).matters() || likeliest->evidence <= together) {
    return false;
  }
  const double curve = candidateTests.curveEvidence(likeliest->curve).bayes;
  const Driver over = candidateTests.map().drivers[candidateTests.curveBasis(likeliest->curve).driver].kind;
  double named = isNamed ? together : -threshold::unnamed;
  for (std::size_t i = 0; i < candidateTests.candidates().size(); ++i) {
    const bool counts =
        !selection.refuted().contains(i) && (isTransient(over) || !isTransient(candidateTests.candidates()[i].effect));
    named = counts ? std::max(named, candidateTests.candidateEvidence(i).bayes) : named;
  }
  return curve > 0 && curve - named > std::max(threshold::unnamed, named * named / threshold::unnamedGrowth);
}

/// Whether a named effect has so much evidence (more than twice the field's) that the field may be its consequence, or
/// one elsewhere moves corners so far that it is no consequence of the field. The field then waits until the effect is
/// added: a lens that lacks several effects leaves a field that no single one of them explains.
bool explains(const CandidateTests& candidateTests, std::optional<std::size_t> candidate, const ImageField& field) {
  if (!candidate) {
    return false;
  }
  const Term& term = candidateTests.candidates()[*candidate];
  const PlaceKind of = field.of == ImageField::Of::camera ? PlaceKind::camera : PlaceKind::board;
  const bool samePlace = term.effect.placeKind == of && term.placeIndex == field.at;
  const GroupEvidence& evidence = candidateTests.candidateEvidence(*candidate);
  return evidence.bayes > 2 * field.fit.bayes ||
         (!samePlace && evidence.movedPx > threshold::fieldBias * field.fit.rmsPx);
}

/// The field, unless it is the weak remainder of a field already explained. `most`: largest evidence of all fields so
/// far.
std::optional<ImageField> noteworthyField(const std::optional<ImageField>& field, double& most) {
  most = std::max(most, field ? field->fit.bayes : 0);
  return field && field->fit.bayes < threshold::fieldRemainder * most ? std::nullopt : field;
}

/// Whether the captures tell joint scatter from the noise of encoders and readings: not an encoder's of unknown step,
/// nor where readings of unknown noise are never repeated.
bool tellScatter(const Measurements& measurements, double scatter) {
  constexpr double encoderScatter = radians(0.02); // of an encoder whose step is not known
  const bool readsUnknown = !measurements.hasRepeats && measurements.hasUnknownNoise();
  return !readsUnknown && (!measurements.hasUnknownSteps() || scatter >= encoderScatter);
}

/// Whether a fit leaves more misfit than noise explains, in size, too: sharp corners share errors below the noise floor
/// (lens distortion that the model lacks, detector bias).
bool leavesMisfit(const CalibrationResult& fit) {
  return fit.misfit > threshold::mostMisfit(fit.misfitFreedom) && fit.rmsPx > fit.noiseFloorPx;
}

bool isSetUpWrong(const std::vector<DataAnomaly>& anomalies) {
  return std::any_of(anomalies.begin(), anomalies.end(), [](const DataAnomaly& one) { return !one.setUp.empty(); });
}

/// What remained of the misfit: a named effect explains it, or only an unnamed curve does.
struct Remainder {
  bool missing = false, unknown = false;
};

Verdict verdictOf(const Diagnosis& diagnosis, const CalibrationResult& last, const Remainder& remainder,
                  const Measurements& measurements) {
  if (!diagnosis.anomalies.empty()) {
    return Verdict::badCaptures;
  }
  if (remainder.unknown) {
    return Verdict::unknownEffect;
  }
  if (remainder.missing) {
    return Verdict::effectMissing;
  }
  if (diagnosis.unexplained || (leavesMisfit(last) && diagnosis.rmsPx > diagnosis.lackOfFit.noiseFloorPx)) {
    return Verdict::inconclusive;
  }
  return diagnosis.fit.scatter > threshold::scatterRatio && tellScatter(measurements, diagnosis.scatter)
             ? Verdict::scatter
             : Verdict::adequate;
}

/// Whether two anomalies concern the same capture, and the same board where both name one.
bool areOfSameView(const DataAnomaly& one, const DataAnomaly& other) {
  return one.capture == other.capture &&
         (one.moved.empty() || other.moved.empty() || one.moved == other.moved || !one.capture);
}

/// Appends anomalies of captures without an earlier anomaly.
void appendNewAnomalies(const std::vector<DataAnomaly>& further, std::vector<DataAnomaly>& suspicious) {
  const std::vector<DataAnomaly> before = suspicious;
  std::copy_if(further.begin(), further.end(), std::back_inserter(suspicious), [&](const DataAnomaly& one) {
    return std::none_of(before.begin(), before.end(),
                        [&](const DataAnomaly& other) { return areOfSameView(one, other); });
  });
}

/// Diagnosis of captures without a feasible fit.
Diagnosis diagnoseUnfittable(const Measurements& measurements, const Model& asked, const InputError& error) {
  Diagnosis result;
  result.verdict = Verdict::badCaptures;
  result.anomalies = findGrossAnomalies(measurements, asked);
  if (result.anomalies.empty()) {
    result.anomalies.push_back(DataAnomaly{{}, error.what()});
  }
  result.sentence = summarize(result);
  return result;
}

/// Assessment of a model by its tests.
struct Assessment {
  bool striking = false;                           // a candidate or curve is significant and large enough to matter
  bool alarm = false;                              // the misfit is real, and no anomaly accounts for it
  bool grows = true;                               // the options allow a further addition
  std::optional<ImageField> field;                 // noteworthy field within pictures
  std::optional<StepwiseSelection::Choice> next;   // effect to add
  bool unknownCurve = false, unknownField = false; // only such a curve or field explains the misfit

  bool unknown() const { return unknownCurve || unknownField; }
  std::optional<std::size_t> candidate() const { return next ? std::optional{next->candidate} : std::nullopt; }
};

/// Diagnosis of one model: adds missing effects until the alarm stops, and describes the misfit that is left.
class ModelDiagnosis {
public:
  ModelDiagnosis(const Measurements& measurements, const Model& asked, const DiagnosisOptions& options)
      : given_{measurements}, asked_{asked}, options_{options}, selection_{measurements, asked, options},
        measurements_{selection_.measurements()} {}

  Diagnosis run() {
    result_.fit = selection_.fit();
    result_.rmsPx = result_.fit.rmsPx;
    do {
      testModel();
      findModelAnomalies();
      assessMisfit();
    } while (addNextEffect());
    describeCurves();
    rankCandidates();
    suggestOwnEffect();
    result_.lastFit = selection_.fit();
    result_.given = result_.steps.front();
    assembleFigures({{measurements_, asked_, result_.fit}, *firstTests_}, {fitted(), *tests_}, result_);
    if (last_.unknown()) {
      addUnnamedCause({fitted(), *tests_}, result_);
    }
    addDisplacedBoards();
    reachVerdict();
    pictureNegligible();
    result_.sentence = summarize(result_);
    return std::move(result_);
  }

  /// Whether the last model leaves an error that no robot has, and most of that of the `first`.
  bool leavesImpossible(const CalibrationResult& first) const {
    return selection_.fit().rmsPx > threshold::correctionShare * first.rmsPx && describeImpossibleError(fitted());
  }

private:
  FittedModel fitted() const { return {measurements_, selection_.model(), selection_.fit()}; }

  void testModel() {
    tests_ = selection_.testModel();
    firstTests_ = firstTests_ ? firstTests_ : tests_;
    selection_.recordStep(*tests_, result_);
  }

  void findModelAnomalies() {
    if (result_.steps.size() == 1) {
      result_.anomalies = findAnomalies(fitted(), *tests_, given_);
      result_.alarm = tests_->evidence().pValue;
    } else { // the misfit of the effect added last may have masked an accident
      result_.anomalies = findTransientAnomalies(fitted(), *tests_, given_);
      result_.anomaliesBeside = !result_.anomalies.empty();
    }
  }

  void assessMisfit() {
    const CandidateTests& tests = *tests_;
    const double level = result_.suggested.empty() ? options_.alarm : threshold::laterAlarm * options_.alarm;
    last_ = {};
    last_.field = noteworthyField(findStrikingField(fitted()), mostField_);
    const bool matters = tests.evidence().matters || leavesMisfit(selection_.fit());
    last_.striking = tests.evidence().pValue <= level && matters;
    last_.alarm = (last_.striking || last_.field) && result_.anomalies.empty();
    if (last_.alarm) {
      last_.next = selection_.chooseNext(tests);
      last_.unknownCurve = isUnknown(tests, last_.next.has_value(), selection_);
      last_.unknownField = last_.field && !explains(tests, last_.candidate(), *last_.field) &&
                           selection_.fieldPersists(*last_.field, tests);
    }
    noteRivalCurve();
    last_.grows = !options_.shouldContinue || options_.shouldContinue(result_.suggested.size());
  }

  /// Notes a curve that is at least about as likely as the likeliest effects together, before any is added.
  void noteRivalCurve() {
    if (!last_.next || last_.unknown() || !result_.suggested.empty()) {
      return;
    }
    const std::optional<LikelyCurve> curve = findLikeliestCurve(*tests_);
    const bool isRival = curve && tests_->curveEvidence(curve->curve).matters() &&
                         curve->evidence > selection_.namedEvidence() - threshold::asLikely;
    result_.rivalCurve =
        isRival ? formatGroup(tests_->wide(), measurements_.robot, tests_->candidates().size() + curve->curve) : "";
  }

  /// False if no effect is to be added, or no further one may be.
  bool addNextEffect() {
    return last_.grows && !last_.unknown() && last_.next && selection_.add(*tests_, *last_.next, result_);
  }

  void describeCurves() {
    auto [cells, best] = mapDrivers(*tests_, measurements_);
    result_.driverScores = std::move(cells);
    result_.driverCurves = std::move(best);
    if (last_.unknownField) {
      result_.driverCurves.insert(result_.driverCurves.begin(), curveFromField(*last_.field, measurements_));
    }
  }

  /// Only beside a model that explains the other captures.
  void addDisplacedBoards() {
    const bool lasting = !result_.anomalies.empty() && !result_.anomalies.front().capture; // then all seem displaced
    if (!last_.unknown() && !lasting && (result_.suggested.empty() || !last_.striking)) {
      const bool wasClear = result_.anomalies.empty();
      appendNewAnomalies(findDisplacedBoards(measurements_, result_.lastFit), result_.anomalies);
      result_.anomaliesBeside |= wasClear && !result_.anomalies.empty() && !result_.suggested.empty();
    }
  }

  void reachVerdict() {
    const bool missing = !result_.suggested.empty() || (!last_.grows && last_.next);
    result_.unexplained = last_.alarm && !last_.next && !last_.unknown() && !missing;
    result_.scatter = selection_.fit().noise.pose;
    result_.unit = errorUnitOf(measurements_, selection_.fit().noise);
    const std::vector<DataAnomaly> slipped =
        isSetUpWrong(result_.anomalies) ? std::vector<DataAnomaly>{} : findSlips({measurements_, asked_, result_.fit});
    result_.anomalies.insert(result_.anomalies.begin(), slipped.begin(), slipped.end());
    result_.anomaliesBeside = result_.anomaliesBeside && slipped.empty();
    result_.verdict = verdictOf(result_, selection_.fit(), {missing, last_.unknown()}, measurements_);
    doubtFit();
    result_.isTentative = isTentative();
    result_.with = selection_.added();
    std::vector<Term> named = selection_.model().terms();
    for (const CandidateFinding& finding : result_.ranking) {
      if (finding.state == CandidateState::present || finding.state == CandidateState::aliased) {
        named.push_back(finding.term);
      }
    }
    result_.assumptions = listAssumptions(measurements_, named);
  }

  /// Whether what is suggested may be the best of many candidates by chance: its evidence hardly pays for their number
  /// (K candidates: 2 ln K, and odds of 20 to 1 beyond), and unseen poses are predicted hardly better.
  bool isTentative() const {
    constexpr double clearly = 0.95; // ratio of held-out errors
    const std::optional<double>&before = result_.steps.front().heldOutPx, &after = result_.steps.back().heldOutPx;
    if (result_.verdict != Verdict::effectMissing || result_.suggested.empty() || !before || !after ||
        *after < clearly * *before) {
      return false;
    }
    const double price = 2 * std::log(static_cast<double>(firstTests_->candidates().size())) + threshold::equallyLikely;
    return std::all_of(result_.ranking.begin(), result_.ranking.end(), [&](const CandidateFinding& finding) {
      const auto& suggested = result_.suggested;
      return std::find(suggested.begin(), suggested.end(), finding.term.label()) == suggested.end() ||
             finding.evidence.bayes < price;
    });
  }

  /// Nothing may rest on a fit with errors, noise or zeros that no robot has and no named cause, nor on captures that
  /// a model explains but that tell nothing of offsets.
  void doubtFit() {
    const FittedModel first{measurements_, asked_, result_.fit};
    const Verdict verdict = result_.verdict;
    const bool isUnexplained = result_.suggested.empty() && verdict != Verdict::unknownEffect;
    if (isUnexplained && verdict != Verdict::badCaptures) {
      for (Finding& finding : listImpossible(first)) {
        result_.anomalies.push_back({{}, std::move(finding.why)});
        result_.verdict = Verdict::badCaptures;
      }
    }
    const auto still = describeStillJoints(first);
    if (still && result_.verdict == Verdict::adequate) {
      result_.anomalies.push_back({{}, still->why});
      result_.hasStillJoints = true;
      result_.verdict = Verdict::badCaptures;
    }
  }

  /// Where an effect is certain, but too small to matter, its picture shows how small.
  void pictureNegligible() {
    const CandidateFinding* const found = result_.verdict == Verdict::adequate ? findNegligible(result_) : nullptr;
    if (found == nullptr) {
      return;
    }
    const Model larger = selection_.addTerm(found->term);
    try {
      if (const Term* const effect = larger.find(found->term.label())) {
        const CalibrationResult fit = selection_.fitLarger(larger);
        addNegligibleCause({measurements_, larger, fit}, *effect, result_);
      }
    } catch (const InputError&) { // no fit with it: no picture
      return;
    }
  }

  void rankCandidates() {
    std::vector<std::string> leading = result_.suggested;
    if (leading.empty() && last_.next) {
      leading = {tests_->candidates()[last_.next->candidate].label()};
    }
    result_.ranking = judgeCandidates(selection_.findings(), *tests_, selection_.model(), selection_.fit(), leading);
  }

  /// The unknown curve as an effect, if it holds.
  void suggestOwnEffect() {
    if (last_.unknown() && !last_.unknownField && last_.grows) {
      result_.own = fitOwnEffect(result_.driverCurves.front(), measurements_, selection_, result_,
                                 options_.calibration.candidateTests);
    }
    if (result_.own) {
      result_.suggested.push_back(result_.own->label);
      result_.steps.push_back(result_.own->step);
    }
  }

  const Measurements& given_;
  const Model& asked_;
  const DiagnosisOptions& options_;
  StepwiseSelection selection_;
  const Measurements& measurements_;                         // as the likeliest explanation weighs them
  std::shared_ptr<const CandidateTests> firstTests_, tests_; // of the model as given, and of the latest model
  double mostField_ = 0;                                     // largest evidence of a field within pictures so far
  Assessment last_;                                          // of the latest model
  Diagnosis result_;
};

/// Whether an accident spoiled specific captures only.
bool isSpoiled(const DataAnomaly& suspicion) {
  return suspicion.capture && suspicion.odds;
}

/// Without effects where these leave an error that no robot has, and most of it: they explain nothing.
Diagnosis diagnoseModel(const Measurements& measurements, const Model& asked, const DiagnosisOptions& options) {
  ModelDiagnosis diagnosis{measurements, asked, options};
  Diagnosis result = diagnosis.run();
  const std::vector<DataAnomaly>& found = result.anomalies;
  if (result.suggested.empty() || result.own || isSetUpWrong(found) ||
      std::any_of(found.begin(), found.end(), isSpoiled) || !diagnosis.leavesImpossible(result.fit)) {
    return result;
  }
  DiagnosisOptions alone = options;
  alone.shouldContinue = [](std::size_t) { return false; };
  return ModelDiagnosis{measurements, asked, alone}.run();
}

/// Removes a picture's corners and readings.
void excludeCapture(std::size_t index, Measurements& measurements) {
  for (std::size_t observation = 0; observation < measurements.pictures[index].observations.size(); ++observation) {
    excludeObservation(measurements, {index, observation});
  }
  excludeReadings(measurements, index);
}

/// Removes the corners and readings of these captures, or of the board that was displaced in them.
Measurements excludeSuspicious(const std::vector<DataAnomaly>& suspicious, Measurements measurements) {
  for (std::size_t index = 0; index < measurements.pictures.size(); ++index) {
    const ImageObservation& picture = measurements.pictures[index];
    const int id = measurements.captureOf(picture).id;
    for (const DataAnomaly& suspicion : suspicious) {
      if (!isSpoiled(suspicion) || suspicion.capture != id || suspicion.set != picture.set) {
        continue;
      }
      if (suspicion.moved.empty()) {
        excludeCapture(index, measurements);
      }
      for (std::size_t observation = 0; observation < picture.observations.size(); ++observation) {
        const std::size_t board = picture.observations[observation].view.board();
        if (suspicion.moved == measurements.targets[board].name) {
          excludeObservation(measurements, {index, observation});
        }
      }
    }
  }
  return measurements;
}

/// Without pictures of which the order of captures tells no direction of approach, for the effects of a diagnosis that
/// depend on it: each is off by as much as these effects can move it. Absent if there are none.
std::optional<Measurements> excludeUnknownApproaches(const Diagnosis& diagnosis, const Measurements& measurements) {
  std::vector<Eigen::Index> joints;
  for (const CandidateFinding& finding : diagnosis.ranking) {
    const auto& with = diagnosis.with;
    if (reliesOnOrder(measurements, finding.term) &&
        std::find(with.begin(), with.end(), finding.term.label()) != with.end()) {
      joints.push_back(static_cast<Eigen::Index>(finding.term.placeIndex));
    }
  }
  std::optional<Measurements> kept;
  for (std::size_t index = 0; index < measurements.pictures.size(); ++index) {
    const ImageObservation& picture = measurements.pictures[index];
    const bool isUnknown = std::any_of(joints.begin(), joints.end(), [&](Eigen::Index joint) {
      return picture.instant.approach[joint] == 0 && measurements.captureOf(picture).joints.approach.empty();
    });
    if (isUnknown) {
      kept = kept ? std::move(kept) : measurements;
      excludeCapture(index, *kept);
    }
  }
  return kept;
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
Diagnosis diagnoseWithoutSpoiled(const Measurements& given, const Model& asked, const DiagnosisOptions& options) {
  constexpr int most = 4; // accidents
  Diagnosis result = diagnoseModel(given, asked, options);
  const SelectionStep ofAll = result.given;
  const std::optional<Measurements> withKnownApproach = excludeUnknownApproaches(result, given);
  if (withKnownApproach) {
    result = diagnoseModel(*withKnownApproach, asked, options);
  }
  const Measurements& measurements = withKnownApproach ? *withKnownApproach : given;
  std::ptrdiff_t known = 0; // suspicions
  for (int round = 0; round < most; ++round) {
    if (std::none_of(result.anomalies.begin() + known, result.anomalies.end(), isSpoiled)) {
      break;
    }
    known = std::ssize(result.anomalies);
    Diagnosis next = diagnoseModel(excludeSuspicious(result.anomalies, measurements), asked, options);
    appendNewAnomalies(next.anomalies, result.anomalies);
    next.anomalies = result.anomalies;
    next.anomaliesBeside = result.anomaliesBeside;
    next.hasStillJoints = false; // not alone
    next.alarm = result.alarm;
    copyLoneEvidence(result.ranking, next.ranking);
    next.verdict = Verdict::badCaptures;
    next.isTentative = false;
    next.sentence = summarize(next);
    result = std::move(next);
  }
  result.given = ofAll;
  return result;
}

/// Whether the scatter of a diagnosis was estimated from few poses that were taken once each. It may then stand for
/// several effects, or for one false capture.
bool assumesScatter(const Diagnosis& diagnosis, const Measurements& measurements) {
  return diagnosis.lastFit.noise.pose > 0 && diagnosis.lastFit.noiseSource != "repeats" &&
         measurements.poses.size() < threshold::fewPoses;
}

/// Held-out error with the effects of the catalogue [px].
std::optional<double> heldOutError(const Diagnosis& diagnosis) {
  return diagnosis.steps[diagnosis.steps.size() - (diagnosis.own ? 2 : 1)].heldOutPx;
}

/// Whether effects predict unseen poses better than the scatter of the other diagnosis lets any model do, or clearly
/// better than the effects that the other found.
bool refutesScatter(const Diagnosis& exact, const Diagnosis& scattered) {
  const std::optional<double> error = heldOutError(exact), other = heldOutError(scattered);
  return error && other &&
         (*error < threshold::refutedScatter * scattered.lackOfFit.noiseFloorPx ||
          *error < threshold::betterPrediction * *other);
}

/// Diagnoses without scatter, too, where no pose is repeated: prediction decides between the two.
Diagnosis diagnoseScatter(const Measurements& measurements, const Model& asked, const DiagnosisOptions& options) {
  Diagnosis scattered = diagnoseWithoutSpoiled(measurements, asked, options);
  if (!assumesScatter(scattered, measurements) ||
      (options.shouldContinue && !options.shouldContinue(scattered.suggested.size()))) {
    return scattered;
  }
  DiagnosisOptions rigid = options;
  rigid.calibration.scatterWithoutRepeats = false;
  Diagnosis exact = diagnoseWithoutSpoiled(measurements, asked, rigid);
  return refutesScatter(exact, scattered) ? std::move(exact) : std::move(scattered);
}

} // namespace

Diagnosis diagnose(const Measurements& measurements, const DiagnosisOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  const Model asked = buildModel(measurements, options.with, options.without, options.calibration.effects);
  requireUnknowns(measurements, asked);
  Diagnosis result;
  try {
    result = diagnoseScatter(measurements, asked, options);
  } catch (const InputError& error) {
    if (measurements.cornerCount == 0) {
      throw;
    }
    result = diagnoseUnfittable(measurements, asked, error);
  }
  result.findings = listFindings(result, measurements);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

} // namespace naocal

#pragma once

#include "calibration/Calibration.hpp"
#include "calibration/CandidateTests.hpp"
#include "diagnosis/anomalies/Events.hpp"
#include "diagnosis/evidence/LackOfFit.hpp"
#include "diagnosis/views/AddedVariable.hpp"
#include "diagnosis/views/DriverCurves.hpp"
#include "diagnosis/views/EffectSignature.hpp"
#include "diagnosis/views/Figures.hpp"
#include "effects/Catalogue.hpp"
#include "inference/Thresholds.hpp"

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace naocal {

/// Verdict of a diagnosis.
enum class Verdict {
  adequate,      // the model explains the captures
  effectMissing, // a named effect is missing
  unknownEffect, // only a curve without a name explains the misfit
  scatter,       // significant joint scatter
  inconclusive,  // the misfit is real, but no single cause stands out
  badCaptures    // the captures contain an accident or a set-up error, or the fit what no robot or instrument has
};

/// The state of one candidate given these captures.
enum class CandidateState {
  present,      // the misfit requires it
  aliased,      // explains the misfit alone, but so does another effect: these captures cannot tell them apart
  trivial,      // significant, but too small to matter
  absent,       // would have been detected at its plausible size
  inconclusive, // may be present below the detection limit
  absorbed,     // not testable: other unknowns mimic it in these poses
  noData        // not testable: its driver was not recorded
};

/// Result for an effect at one place.
struct CandidateFinding {
  Term term;
  CandidateState state = CandidateState::inconclusive;
  bool predicts = true;                  // the last captures from those before, where it depends on time or warmth
  std::string why;                       // reason for `noData`: "no temperatures were recorded"
  GroupEvidence evidence;                // strongest evidence, against the model as given or after later additions
  GroupEvidence alone;                   // evidence against the model as given
  std::size_t step = 0;                  // number of additions before `evidence`
  double power = 0;                      // detection probability if any one of its unknowns has its plausible size
  std::vector<double> minimalDetectable; // per unknown: size detected with 90 % power [the unknown's unit]
  std::optional<double> chi2Drop;        // decrease of chi2 after refitting, where refitted
  std::optional<double> heldOutBefore, heldOutAfter; // held-out error without and with it [px]
  bool plausible = true;                             // estimates within three prior sigmas
  std::vector<std::string> equivalent;               // labels of effects that these captures cannot distinguish from it
  std::optional<AddedVariable> addedVariable;        // for the first few candidates only
  std::optional<EffectSignature> imprint;            // for the first few candidates only, in the model as given
};

/// One step of the selection: the model with one more effect.
struct SelectionStep {
  std::string added;                // label; empty for the model as given
  std::vector<std::string> dropped; // labels of earlier additions that it made superfluous
  double rmsPx = 0, noiseFloorPx = 0;
  std::optional<double> heldOutPx; // held-out error, with effects chosen anew in each fold; absent with a single pose
  std::optional<double> nextPx;    // the same with the effect that would be chosen next
  double chi2 = 0, dof = 0;
  double alarm = 1; // family-wise p-value of the model being complete
};

/// A curve outside the catalogue, as a user-defined effect that lowers the held-out error.
struct OwnEffect {
  std::string label;      // "found_LKneePitch_over_q@LKneePitch"
  std::string definition; // JSON, as in a model file's `define`
  SelectionStep step;     // the step that adds it; expression chosen on all poses, coefficients fitted per fold
};

struct Diagnosis {
  Verdict verdict = Verdict::adequate;
  std::string sentence;
  ErrorUnit unit;      // of errors, for people
  LackOfFit lackOfFit; // of the model as given
  double rmsPx = 0;
  double alarm = 1;                      // of the model as given
  bool isTentative = false;              // what is suggested is weak, and unseen poses are predicted no better with it
  bool unexplained = false;              // the alarm persists, but no candidate is likely enough to add
  double scatter = 0;                    // pose noise of the last model [rad]
  std::vector<CandidateFinding> ranking; // all candidates, best first
  std::vector<std::string> suggested;    // labels in order of addition; `own` last
  std::optional<OwnEffect> own;          // user-defined effect beyond the catalogue, on top of the last model
  std::vector<SelectionStep> steps;      // selection steps, starting with the model as given
  SelectionStep given;                   // the model as given, with the captures that the diagnosis sets aside
  std::vector<DriverCurve> driverCurves; // for the last model, best first
  std::vector<DriverScore> driverScores; // for the last model
  std::string rivalCurve; // a curve at least about as likely as the likeliest effects: "LKneePitch over q"; empty: none
  std::vector<DataAnomaly> anomalies;
  bool hasStillJoints = false;    // whether the captures are bad only since joints never moved; the model explains them
  bool anomaliesBeside = false;   // whether these were found beside the suggestions, which explain more
  std::vector<Finding> assumptions; // `listAssumptions`
  std::vector<Finding> findings;    // `listFindings`, most serious first
  Figures figures;
  CalibrationResult fit;         // of the model as given
  CalibrationResult lastFit;     // of the last model: with all suggested catalogue effects
  std::vector<std::string> with; // effects of the last model beyond the base model
  double seconds = 0;
};

struct DiagnosisOptions {
  CalibrationOptions calibration;
  std::vector<std::string> with, without; // model to diagnose: the base model with and without these effects
  double alarm = threshold::alarm;        // family-wise false-alarm rate
  /// Called before each addition with the number of effects found so far; false ends the search there.
  std::function<bool(std::size_t found)> shouldContinue;
};

} // namespace naocal

#pragma once

#include "calibration/Calibration.hpp"
#include "diagnosis/Events.hpp"
#include "diagnosis/evidence/CandidateTests.hpp"
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

enum class Verdict { adequate, effectMissing, unknownEffect, scatter, inconclusive, badCaptures };

/// What these captures say about one candidate.
enum class CandidateState {
  present,      // the misfit needs it
  aliased,      // it would explain the misfit as well, but one that explains it as well was taken
  trivial,      // there, but smaller than matters
  absent,       // it would have been seen were it as large as it plausibly is
  inconclusive, // it might be there and not be seen
  absorbed,     // these poses cannot test it: other unknowns imitate it
  noData        // what drives it was not recorded
};

/// An effect at a place, and what the captures say about it.
struct CandidateFinding {
  Term term;
  CandidateState state = CandidateState::inconclusive;
  std::string why;                       // of noData: "no temperatures were recorded"
  GroupEvidence evidence;                // where it was strongest: alone, or after others were added
  GroupEvidence alone;                   // beside the model as given
  std::size_t step = 0;                  // after how many additions that was
  double power = 0;                      // chance to be noticed were any one of its unknowns as large as plausible
  std::vector<double> minimalDetectable; // per unknown: noticed in 9 of 10 cases [the unknown's unit]
  std::optional<double> chi2Drop;        // after refitting, where that was done
  std::optional<double> heldOutBefore, heldOutAfter; // [px]
  bool plausible = true;                             // within three of its sigmas
  std::vector<std::string> equivalent;               // labels of effects that these captures cannot tell from it
  std::optional<AddedVariable> addedVariable;        // of the first few
  std::optional<EffectSignature> imprint;            // of the first few, in the model as given
};

/// A capture, board or setting that looks wrong.
struct DataAnomaly {
  std::optional<int> capture; // its id
  std::string why;
  std::size_t set = 0;             // the capture's
  std::optional<double> odds = {}; // to 1 against the best effect or curve, where they were compared
  std::optional<Moment> when = {}; // of what happened between two captures
};

/// One rung of the ladder: the model with one more effect.
struct SelectionStep {
  std::string added;                // its label; empty for the model as it was given
  std::vector<std::string> dropped; // labels of earlier additions that it made superfluous
  double rmsPx = 0, noiseFloorPx = 0;
  std::optional<double> heldOutPx; // on poses that neither the fit nor the choice of effects has seen; not of one pose
  std::optional<double> nextPx;    // the same with the effect that would be chosen next
  double chi2 = 0, dof = 0;
  double alarm = 1; // family-wise p-value that something is missing here
};

/// A curve that no effect of the catalogue follows, as an effect of a person's own that lowers the held-out error.
struct OwnEffect {
  std::string label;      // "found_LKneePitch_over_q@LKneePitch"
  std::string definition; // JSON, as in a model file's `define`
  SelectionStep step;     // the rung with it; its expression was chosen on all poses, its sizes in each fold
};

struct Diagnosis {
  Verdict verdict = Verdict::adequate;
  std::string sentence;
  LackOfFit lackOfFit; // of the model as given
  double rmsPx = 0;
  double alarm = 1;                      // of the model as given
  bool unexplained = false;              // the alarm stands, but nothing is likely enough to be added
  double scatter = 0;                    // pose noise of the last model [rad]
  std::vector<CandidateFinding> ranking; // best first
  std::vector<std::string> suggested;    // labels, in the order they were added; that of `own` last
  std::optional<OwnEffect> own;          // beyond the catalogue, on top of the last model
  std::vector<SelectionStep> steps;      // the ladder
  std::vector<DriverCurve> driverCurves; // on the last model, best first
  std::vector<DriverScore> driverScores; // on the last model
  std::vector<DataAnomaly> anomalies;
  Figures figures;
  CalibrationResult fit;         // of the model as given
  CalibrationResult lastFit;     // with everything suggested that the catalogue has
  std::vector<std::string> with; // what that last model has beyond the base
  double seconds = 0;
};

struct DiagnosisOptions {
  CalibrationOptions calibration;
  CandidateTestOptions inquiry;
  std::vector<std::string> with, without; // the model to question: the base with and without these
  std::vector<Effect> effects = allEffects();
  double alarm = threshold::alarm; // family-wise rate of false alarms
  bool extend = true;              // add what is missing; else only question the model as it is
  std::function<bool()>
      shouldContinue; // asked before each addition; false: the diagnosis says what it has found so far
};

} // namespace naocal

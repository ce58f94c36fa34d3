#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

/// All decision thresholds of inference and diagnosis: unit, what lies beyond, and how each was chosen.
///
/// Evidence is 2 ln(Bayes factor): above 6 is strong, above 10 very strong (Kass and Raftery, JASA 90 (1995) 773).
/// "Simulated" levels were tuned on blind sets of simulated robots with randomly drawn hidden effects.
namespace naocal::threshold {

// False alarms [probability]
inline constexpr double alarm = 0.05; // family-wise rate at which a complete model is called incomplete
inline constexpr double laterAlarm =
    0.4; // factor on `alarm` for each later look of one diagnosis; limits the total rate of false alarms
inline constexpr double curveRarity = 16; // factor: p-values of curves are this much weaker, as many curves stand
                                          // beside few named effects (weighted test: Genovese, Roeder, Wasserman,
                                          // Biometrika 93 (2006) 509)
inline constexpr double fieldAlarm =
    0.001; // a shape within pictures, over all fields; strict, since the tail is not bootstrapped
inline constexpr double movedBoardAlarm = 1e-6; // p-value per set of a displaced board; strict, as it is set aside
inline constexpr double sharedCause = 0.01;     // p-value per set of rejected measurements that share something
inline constexpr double scatterRatio = 9;       // likelihood ratio of joint scatter at its boundary: p = 0.0013

// Evidence [2 ln(Bayes factor)]
inline constexpr double equallyLikely = 6; // 1 to 20; below this gap neither of two explanations is preferred
inline constexpr double asLikely = 2;      // 2.7 to 1; below this gap a rival is worth a word beside what is added
inline constexpr double veryStrong =
    10; // 150 to 1; beyond it not chance, and beyond it an event is replaced by a lasting effect
inline constexpr double maxEvidenceGap =
    14; // 1 to 1100; a correlated candidate that trails by more is ruled out and not refitted
inline constexpr double unnamed =
    4; // 7 to 1; prior odds of a named effect against a curve, and of an event against a transient effect
inline constexpr double unnamedGrowth =
    500; // adds named^2 / 500 to `unnamed`, since a free curve mimics several effects at once; simulated
inline constexpr double stillNeeded =
    3.3; // Wald z above which an earlier addition is no alias of the latest (p = 0.001)
inline constexpr double fieldEvidence = 6;    // of a shape within pictures
inline constexpr double fieldRemainder = 0.2; // share of the strongest shape so far; a smaller remainder does not count
inline constexpr double predictsNext =
    3; // gain on the last block of time above which an effect predicts; 84 simulated robots
inline constexpr double predictsTail = 0.001; // p-value of the misfit in that block, above which an effect predicts

// What captures tell of an offset [1 - posterior sigma / prior sigma]
inline constexpr double learned = 0.5; // below it the prior tells more than the captures: not determined

// Where averages over models hold [prior sigmas]
inline constexpr double untold = 0.1; // information; below it a direction's standard error is more than 95 % of the
                                      // prior's: only the prior holds it
inline constexpr double farthest = 4; // a linear step that takes an unknown further is extrapolated: 1 in 16 000 are

// Values beyond what any robot is wrong by
inline constexpr double farthestTurn = 0.262; // [rad], 15 degrees; worn and fallen NAOs' offsets reach 11.5
inline constexpr double farthestSlide = 0.1;  // [m], of the zero of a slide
inline constexpr double farthestSigmas = 5;   // and, of a mount's turn, prior sigmas: a set may say that it is unknown

// Aliasing
inline constexpr double related = 0.5; // correlation; below it neither candidate explains the other's misfit
inline constexpr double power = 0.8;   // power at a plausible size; above it an undetected candidate is ruled out

// Misfit and sizes
inline constexpr double misfit = 1.6; // chi2 / freedom between poses that noise does not exceed; 248 simulated robots
/// The same with few degrees of freedom: three standard deviations of chi2 / freedom, if that is more.
inline double mostMisfit(double freedom) {
  return std::max(misfit, 1 + 3 * std::sqrt(2 / std::max(1.0, freedom)));
}
inline constexpr double bearableMisfit = 1.5; // the same with suspected missing effects; below it offsets are usable
inline constexpr double refutedScatter =
    0.7; // share of the noise floor; a smaller held-out error refutes the scatter that raises the floor. Where joints
         // did scatter, it was at least 0.84, in 48 simulated sets of 14 or 24 poses
inline constexpr double betterPrediction = 0.8; // held-out error without scatter, as a share of that with it; below it
                                                // the joints do not scatter. At least 0.92 in the same sets
inline constexpr double fieldBias = 3; // ratio of the corners' displacement by an effect to a field's rms, beyond which
                                       // the effect is no consequence of the field. Where there was only a field it was
                                       // at most 2.0 in 23 of 24 simulated sets; hidden effects: 3.6 to 33
inline constexpr double implausible = 3; // size of an effect in prior sigmas, beyond which it is implausible
inline constexpr double negligiblePx =
    0.1; // [px]; a tenth of a millimetre at arm's length, the accuracy of lenses, detectors and printers
inline constexpr std::size_t fewPoses = 128;    // with fewer, one bad pose or several effects may pass for scatter;
                                                // beyond, a pose at ten times the scatter still stands out by seven
inline constexpr double manyCorners = 1.0 / 20; // share of doubted corners above which the model is at fault
inline constexpr double undetermined = 10; // standard error in prior sigmas above which an estimate is undetermined

// Noise of readings that a set does not give, per axis. Upper ends: of 97.5 % of instruments of the kind; what readings
// differ beyond them is misfit. Points: boards and tags seen by a camera (0.2 to 5 mm) differ most, motion capture by
// 0.05 to 1 mm, laser trackers by 0.01 to 0.15 mm. Turns: 0.05 to 1 degree. Contacts of a ball: 0.01 to 0.3 mm, by hand
// three times as much
inline constexpr double leastReadingNoise = 1e-5; // [m] or [rad]; a laser tracker at its best
inline constexpr double mostPointNoise = 0.005;   // [m]
inline constexpr double mostTurnNoise = 0.0175;   // [rad]
inline constexpr double mostContactNoise = 0.001; // [m]

// Grossly wrong set-ups [px]
inline constexpr double impossiblePx = 25; // distance from its prediction that no physics of a walking robot explains
inline constexpr double absurdPx = 100;    // rms that neither physics nor an event explains
inline constexpr double soundPx =
    5; // rms that a correct set may have with unmodelled physics; corrections must leave less
inline constexpr double correctionShare =
    0.4; // remaining share of the misfit; a correction that leaves less is reported

// Errors beyond what any robot is wrong by, and beyond what noise explains
inline constexpr double impossibleMetres = 0.05; // rms error of readings [m]: `impossiblePx` at the 560 px focal length
                                                 // of a NAO, seen from a metre away
inline constexpr double impossibleRadians = 0.045; // the same as an angle, of orientations and directions [rad]
inline constexpr double impossibleNoises = 20; // and in units of a noise that is given: the instrument may be coarse
inline constexpr double unexplainedNoises = 3; // rms error in noise floors, above which it is not noise
inline constexpr double manyRejected = 0.1;    // share of rejected measurements from which on the fit is at fault, too
inline constexpr double fewRejected = 0.01;    // share of measurements that accidents of a detector may spoil

} // namespace naocal::threshold

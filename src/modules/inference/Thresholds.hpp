#pragma once

/// Every level at which inference and diagnosis decide: its unit, what lies beyond it, and how it was chosen.
///
/// Evidence counts as 2 ln(Bayes factor): above 6 it is strong, above 10 very strong (Kass and Raftery, JASA 90 (1995)
/// 773). "Simulated" levels were set on blind sets of simulated robots whose hidden effects were drawn at random.
namespace naocal::threshold {

// False alarms [probability]
inline constexpr double alarm = 0.05; // family-wise: how often something is said to be missing where nothing is
inline constexpr double laterAlarm =
    0.4; // factor for every further look of one diagnosis: else one in several would be false
inline constexpr double curveRarity = 16; // factor: many curves stand beside few named effects (weighted test:
                                          // Genovese, Roeder, Wasserman, Biometrika 93 (2006) 509)
inline constexpr double fieldAlarm =
    0.001; // a shape within pictures, all fields together: its noise is not drawn, so its tail is not proved
inline constexpr double movedBoardAlarm =
    1e-6;                                 // a board said to be displaced, per set: it is set aside, so it must be sure
inline constexpr double scatterRatio = 9; // likelihood ratio of joint scatter at its boundary: p = 0.0013

// Evidence [2 ln(Bayes factor)]
inline constexpr double equallyLikely = 6; // closer than 1 to 20: neither of two explanations is preferred
inline constexpr double veryStrong =
    10; // 150 to 1: no chance finding; as many times likelier than an event is an effect that lasts
inline constexpr double maxEvidenceGap =
    14; // 1 to 1100: a correlated candidate farther behind is ruled out, and not worth a fit
inline constexpr double unnamed =
    4; // 7 to 1: prior odds of a named effect against a curve, of an event against an effect that passes
inline constexpr double unnamedGrowth =
    500; // named^2 / 500 is added to `unnamed`: a free curve follows several effects at once; simulated
inline constexpr double stillNeeded = 3.3;    // chi2 of an earlier addition that is no twin of the last (p = 0.07)
inline constexpr double fieldEvidence = 6;    // a shape within pictures
inline constexpr double fieldRemainder = 0.2; // share of the strongest shape so far that is no shape of its own
inline constexpr double predictsNext =
    3; // gain on the last block of time of an effect that predicts; 84 simulated robots
inline constexpr double predictsTail = 0.001; // and the least probability of what it leaves there

// Aliasing
inline constexpr double related = 0.5; // correlation below which neither candidate explains what the other does
inline constexpr double power = 0.8;   // chance to see a plausible size, above which a candidate not seen is ruled out

// Misfit and sizes
inline constexpr double misfit = 1.6; // chi2 / freedom from pose to pose that noise does not make; 248 simulated robots
inline constexpr double bearableMisfit = 1.5; // the same beside what may be missing: offsets still hold
inline constexpr double implausible = 3;      // plausible sigmas of an effect's size
inline constexpr double negligiblePx =
    0.1; // [px] a tenth of a millimetre at arm's length: no lens, detector or printer is known better
inline constexpr double manyCorners = 1.0 / 20; // share of doubted corners that are the model's fault, not theirs
inline constexpr double untold = 10;            // plausible sigmas of an estimate's standard error: undetermined

// Grossly wrong set-ups [px]
inline constexpr double impossiblePx = 25; // farther from its prediction no physics of a walking robot puts a corner
inline constexpr double grossPx = 3;       // rms above which wrong set-ups are tried at all
inline constexpr double nonsensePx = 100;  // rms that neither physics nor an event makes
inline constexpr double soundPx = 5;       // rms of a set that is right but for its physics
inline constexpr double mends = 0.4;       // largest share of the misfit left by a correction that is named

} // namespace naocal::threshold

#pragma once

#include "estimation/Residuals.hpp"
#include "inference/ScoreProblem.hpp"

#include <vector>

namespace naocal {

/// Expected rms distance of corners [px] under noise alone: noise of corners and, through the Jacobian J, of joint
/// readings at all noise levels, sqrt(2 sum ((pixel^2 + pixelAlike^2) n + tr(J S J^T)) / sum n) over poses with n image
/// coordinates.
double noiseFloorPx(const std::vector<PoseRows>& poses, const Noise& noise);

/// Estimated noise levels of the joints' random deflections, with their uncertainty.
struct NoiseLevels {
  Noise noise; // most likely levels
  struct Level {
    Noise noise;
    double weight = 0; // posterior probability; sums to 1 over all levels
  };
  std::vector<Level> levels; // grid of pose noise levels; empty: noise is taken as known
  double scatter = 0;        // decrease of -2 ln likelihood from zero pose noise to the most likely level
};

/// How poses were repeated within the captures.
struct RepeatInfo {
  bool reapproached = false; // the robot left a pose and returned to it
  bool restood = false;      // the same, and the robot was put down anew in between
  bool none = false;         // no repeats at all: scatter is told from few effects by their costs
};

/// Upper limit of joint scatter [rad], the scatter of real gears. Misfit beyond it is not attributed to noise.
constexpr double mostScatter = 0.15 * 3.14159265358979323846 / 180;
/// Joint scatter [rad] beyond which the misfit, not stiction of the gears, drives the estimated level to its limit.
constexpr double suspectScatter = 0.8 * mostScatter;

/// -2 ln of the half-Cauchy prior on pose noise [rad] with scale 0.02 degrees, up to a constant. Few poses hardly
/// determine the level (Gelman, Bayesian Analysis 1 (2006) 515).
double poseNoisePenalty(double level);

/// Smallest pose noise above zero [rad] at which D is evaluated.
constexpr double leastScatter = 0.003 * 3.14159265358979323846 / 180;

/// Estimates re-approach, stance and pose noise by restricted likelihood (REML: Patterson and Thompson, Biometrika 58
/// (1971) 545) under the widest model: all candidate effects enter as random effects gamma ~ N(0, kappa^2) in units of
/// `plausible`. Without the candidates, scatter is the only explanation of any misfit, and every missing effect
/// inflates it. With the candidates as an alternative, structured misfit stays misfit (error variance from the largest
/// model: Mallows, Technometrics 15 (1973) 661; as a linear mixed model: Harville, JASA 72 (1977) 320):
///
///   D(level) = min over kappa of  D_alone(level) - z^T (S + kappa^-2)^-1 z + ln |1 + kappa^2 S|,
///
/// D_alone the restricted deviance without candidates, z and S score and information of the candidates, the own
/// unknowns projected out. Re-approach and stance noise follow from differences within poses (pose noise
/// unconstrained): re-approach only if `repeated.reapproached`, stance only if `repeated.restood`. Beside re-approach
/// noise stand only the candidates that `varies` marks, one per named group: effects of the posture alone are the same
/// at every approach. Their columns differ there by the errors of the readings, which a joint's gain of -1 would hide.
/// `noise` gives the pixel and encoder levels, which stay fixed. Curves of the problem are excluded, since they would
/// fit scatter.
/// With few poses the random effects gamma are as flexible as scatter, which then takes the place of one or two large
/// effects. Where no pose is repeated, `costExplanations` stands beside them: the more likely of the two counts at each
/// level. The random effects then come on top of the effects fitted at the linearisation point, and bear their cost.
NoiseLevels estimateNoiseLevels(const ScoreProblem& wide, const Noise& noise, const RepeatInfo& repeated,
                                const std::vector<bool>& varies);

/// Whether the data estimate the pose noise at its boundary, zero: D(0) <= D(leastScatter), the penalty included.
/// `noise`: the other levels.
bool isPoseNoiseAtBoundary(const ScoreProblem& wide, const Noise& noise);

} // namespace naocal

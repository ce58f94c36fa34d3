#pragma once

#include "estimation/Residuals.hpp"
#include "inference/ScoreProblem.hpp"

#include <vector>

namespace naocal {

/// rms distance of corners that noise alone leaves [px]: of corners and, through the slopes J, of the joints' readings
/// and levels, sqrt(2 sum (pixel^2 n + tr(J S J^T)) / sum n) over poses of n numbers.
double noiseFloorPx(const std::vector<PoseRows>& poses, const Noise& noise);

/// Levels of the joints' random deflections, and how sure they are.
struct NoiseLevels {
  Noise noise; // the likeliest
  struct Level {
    Noise noise;
    double weight = 0; // posterior probability; all levels' sum to 1
  };
  std::vector<Level> levels; // of pose noise; empty: the noise is taken as known
  double scatter = 0;        // fall of -2 ln likelihood from no pose noise to the likeliest level
};

/// How poses were repeated.
struct RepeatInfo {
  bool reapproached = false; // left and taken again
  bool restood = false;      // that, and by a robot that was put down anew besides
};

/// No more than real gears have [rad]: what candidates cannot explain within that is misfit, not noise.
constexpr double mostScatter = 0.15 * 3.14159265358979323846 / 180;
/// More than this is no gear's stiction, but a misfit that joints' levels take as far as they may [rad].
constexpr double suspectScatter = 0.8 * mostScatter;

/// -2 ln of the half-Cauchy prior of pose noise [rad], up to a constant, of 0.02 degrees: few poses hardly tell its
/// level (Gelman, Bayesian Analysis 1 (2006) 515).
double poseNoisePenalty(double level);

/// Re-approach, stance and pose noise by restricted likelihood (REML: Patterson and Thompson, Biometrika 58 (1971) 545)
/// under the widest model: all candidate effects are in it as random effects gamma ~ N(0, kappa^2) in units of what is
/// plausible. Of the model alone, restricted likelihood asks whether the misfit is larger than readings explain, and
/// with scatter as the only other answer takes every missing effect for scatter; with the candidates as another answer
/// a misfit that has a shape stays a misfit (the error variance is that of the largest model: Mallows, Technometrics 15
/// (1973) 661; as a linear mixed model: Harville, JASA 72 (1977) 320):
///
///   D(level) = min over kappa of  D_alone(level) - z^T (S + kappa^-2)^-1 z + ln |1 + kappa^2 S|,
///
/// D_alone the model's own restricted deviance, z and S score and information of the candidates, the model's unknowns
/// projected out. Re-approach and stance are told by differences within poses alone (pose noise set free); re-approach
/// only where poses were left and taken again, stance only where they were taken again by a robot put down anew.
/// `noise`: pixels and encoders, which stay. The problem's curves are left out: they would take scatter for a shape.
NoiseLevels estimateNoiseLevels(const ScoreProblem& wide, const Noise& noise, const RepeatInfo& repeated);

} // namespace naocal

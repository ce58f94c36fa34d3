#pragma once

#include "calibrate/JointNoise.hpp"
#include "residuals/Residuals.hpp"

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

struct CalibrationOptions {
  Noise noise;               // assumed where the captures cannot tell it
  bool pixelGiven = false;   // the pixel noise was set by a person: taken as it is where no repeats tell it
  bool estimateNoise = true; // from repeats, where there are any
  /// What a corner's fit is off by in every picture of a pose alike, so that repeats cannot show it: its place between
  /// the pixels stays (rendered pictures: 0.02 px where boards are near) [px].
  double repeatedCornerError = 0.02;
  /// As much misfit within single pictures as repeats do not show may be put down to that error, too; and no corner is
  /// trusted better than this, however well it repeats [px].
  double largestCornerError = 0.02;
  bool robust = true;     // doubtful corners lose their weight (and are listed)
  bool setAside = true;   // so are, if robust, sightings whose board moved
  bool alternate = false; // the thesis's way: joints and cameras in turns instead of together
  int restarts = 0;       // further random starts; the lowest cost wins
  std::uint64_t seed = 1;
  std::optional<Eigen::VectorXd>
      start; // unknowns to start from, instead of zero with placements found from the pictures
};

/// One unknown's estimate.
struct Estimate {
  double value = 0; // [the unknown's unit]
  double sigma = 0; // standard error; where the model does not explain the captures, of noise scaled by `sigmaScale`
  double halfWidth = 0; // of the 95 % interval: Student's t where noise levels rest on few poses
  double freedom = 0;   // of that t
  double learned = 0;   // 1 - posterior sigma / prior sigma
};

/// A combination of unknowns that the captures hardly tell: a direction of unit length, and the standard error along
/// it. In radians where all that takes part are angles, else counted in units of the priors' sigmas.
struct WeakDirection {
  std::vector<std::pair<std::string, double>> parts; // unknown, share
  double sigma = 0;
  std::string unit; // "rad" or "prior sigmas"
  std::string sentence;
};

/// A corner or a whole sighting that does not fit the rest. It is kept and listed, never dropped in silence.
struct Doubt {
  std::size_t picture = 0, sighting = 0;
  std::vector<int> corners; // ids; all of the sighting's when `whole`
  bool whole = false;       // most of the sighting does not fit: the board or the robot was moved
  double distance = 0;      // rms of what does not fit [px]
};

/// Why a result should be used with care, and what to do.
struct Warning {
  enum class About { fit, offset, floor };
  About about;
  std::string sentence;
};

struct CalibrationResult {
  bool converged = false;
  bool usable = false;
  std::vector<Warning> warnings;
  Eigen::VectorXd unknowns;
  std::vector<Estimate> estimates; // per unknown
  Eigen::MatrixXd covariance;      // of the unknowns
  Residuals::State state;
  std::vector<SightingResidual> sightings;  // at the estimate, the joints' deflections included
  std::vector<SightingResidual> asReported; // the same sightings with the joints' readings as they are
  Noise noise;                              // before any scaling by `sigmaScale`
  std::string noiseSource;                  // "repeats" or "configured"
  Loss loss;
  double rmsPx = 0, medianPx = 0; // of all corners' distances without their poses' deflections [px]
  double chi2 = 0, dof = 0, pValue = 1;
  double sigmaScale = 1; // sqrt(chi2/dof) where the misfit is beyond doubt (p < 0.001), else 1
  std::vector<WeakDirection> weak;
  std::vector<Doubt> doubts;
  double floorErrorAt2m = 0; // predicted error of a floor point 2 m ahead, 1 sigma, scaled [m]; 0 without floor boards
  int iterations = 0;
  int restartsTried = 0;
  bool restartsChanged = false;
  double seconds = 0;
};

/// The straight line from captures to trustworthy numbers: start, fit, noise levels, fit, uncertainty, doubts, verdict.
/// Throws InputError when there is nothing to fit.
CalibrationResult calibrate(const Measurements& measurements, const Model& model,
                            const CalibrationOptions& options = {});

} // namespace naocal

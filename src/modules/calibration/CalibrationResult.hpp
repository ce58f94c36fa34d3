#pragma once

#include "effects/Catalogue.hpp"
#include "estimation/Residuals.hpp"
#include "inference/NoiseLevels.hpp"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

struct CalibrationOptions {
  Noise noise;               // assumed where the captures cannot tell it
  bool pixelGiven = false;   // the pixel noise was set by a person: taken as it is where no repeats tell it
  bool estimateNoise = true; // from repeats, where there are any
  /// Also asks what may be missing: noise levels from the widest model, offsets averaged over what could be missing,
  /// and whether the captures show it. Without: noise levels as if nothing could be.
  bool question = true;
  std::vector<Effect> effects = allEffects(); // that may be missing
  Eigen::Index draws = 199;                   // of pure noise, for the p-value
  std::uint64_t drawSeed = 1;
  bool robust = true;           // doubtful corners lose their weight (and are listed)
  bool excludeDisplaced = true; // so are, if robust, sightings whose board moved
  bool alternate = false;       // the thesis's way: joints and cameras in turns instead of together
  int restarts = 0;             // further random starts; the lowest cost wins
  std::uint64_t seed = 1;
  std::optional<Eigen::VectorXd>
      start;                // unknowns to start from, instead of zero with placements found from the pictures
  std::optional<Loss> loss; // under which `start` was found, where the search shall go on as it ended
};

/// An unknown's value over everything that could be missing (`ModelWindow`).
struct Averaged {
  double value = 0, sigma = 0;
  double low = 0, high = 0; // 95 % interval
};

/// One unknown's estimate.
struct Estimate {
  double value = 0;                      // of the model as it is [the unknown's unit]
  double sigma = 0;                      // standard error, widened by `sigmaScale`
  double halfWidth = 0;                  // of the 95 % interval: Student's t where noise levels rest on few poses
  double freedom = 0;                    // of that t
  double learned = 0;                    // 1 - posterior sigma / prior sigma, at least 0
  std::optional<Averaged> averaged = {}; // where the question was asked what may be missing

  /// The answer: over what could be missing where that was asked, else the model's.
  double best() const { return averaged ? averaged->value : value; }
  double bestSigma() const { return averaged ? averaged->sigma : sigma; }
  std::array<double, 2> interval() const {
    return averaged ? std::array{averaged->low, averaged->high} : std::array{value - halfWidth, value + halfWidth};
  }
};

/// One explanation of the captures: the model with these effects and curves, and without those.
struct Explanation {
  std::vector<std::string> effects; // labels beyond the model's; empty: the model as it is
  std::vector<std::string> without; // of those that were added to the base: it does without them
  double weight = 0;                // of 1 for all explanations
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
struct Outlier {
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

/// What a result is worth.
enum class ResultVerdict {
  good,         // the model explains the captures
  causeMissing, // usable, but something is missing: find it
  doNotUse
};

struct CalibrationResult {
  bool converged = false;
  ResultVerdict verdict = ResultVerdict::good;
  bool usable = false;  // not `doNotUse`
  std::string sentence; // the verdict in words, the same on every screen
  std::vector<Warning> warnings;
  Eigen::VectorXd unknowns;
  std::vector<Estimate> estimates; // per unknown
  Eigen::MatrixXd covariance;      // of the unknowns
  Residuals::State state;
  std::vector<BoardResidual> sightings;          // at the estimate, the joints' deflections included
  std::vector<BoardResidual> withReportedAngles; // the same sightings with the joints' readings as they are
  Noise noise;                                   // before any scaling by `sigmaScale`
  std::string noiseSource;                       // "repeats" or "configured"
  Loss loss;
  double rmsPx = 0, medianPx = 0; // of all corners' distances without their poses' deflections [px]
  double noiseFloorPx = 0;        // rms distance that noise alone would leave [px]
  double chi2 = 0, dof = 0;
  double pValue = 1;                     // how often pure noise would show as striking a sign that something is missing
  bool matters = false;                  // what shows moves corners by more than a lens is known to
  double sigmaScale = 1;                 // sqrt(`misfit`): how far error bars are widened
  double misfit = 1;                     // from pose to pose, chi2 / freedom of the model as it is, where above 1
  double misfitLeft = 1;                 // the same of the likeliest explanation
  double scatter = 0;                    // fall of -2 ln likelihood from no pose noise to the level found
  std::vector<Explanation> explanations; // likeliest first; those that weigh more than a hundredth
  std::vector<WeakDirection> weak;
  std::vector<Outlier> doubts;
  double floorErrorAt2m = 0; // predicted error of a floor point 2 m ahead, 1 sigma, scaled [m]; 0 without floor boards
  int iterations = 0;
  int restartsTried = 0;
  bool restartsChanged = false;
  double seconds = 0;
};

/// A model, the measurements it was fitted to, and the fit. A view: the caller keeps all three (temporaries are
/// refused).
struct FittedModel {
  FittedModel(std::reference_wrapper<const Measurements> fittedTo, std::reference_wrapper<const Model> ofModel,
              std::reference_wrapper<const CalibrationResult> theFit)
      : measurements{fittedTo.get()}, model{ofModel.get()}, fit{theFit.get()} {}

  const Measurements& measurements;
  const Model& model;
  const CalibrationResult& fit;
};

} // namespace naocal

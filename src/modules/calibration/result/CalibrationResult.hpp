#pragma once

#include "calibration/ReadingErrors.hpp"
#include "calibration/result/DataAnomaly.hpp"
#include "calibration/result/Finding.hpp"
#include "effects/Catalogue.hpp"
#include "estimation/Residuals.hpp"
#include "inference/NoiseLevels.hpp"
#include "math/LevenbergMarquardt.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

struct CandidateTestOptions {
  Eigen::Index draws = 199; // bootstrap draws of pure noise for the null distribution of the p-value
  std::uint64_t seed = 1;
  bool map = true; // includes curves of joints and mounts over drivers
};

struct CalibrationOptions {
  Noise noise;               // assumed where the captures do not determine it
  bool pixelGiven = false;   // `noise.pixel` is user-supplied: kept unless repeats determine it
  bool estimateNoise = true; // estimates joint noise from repeats, where present
  /// Estimates joint scatter also where no pose was repeated. If false, it stays as in `noise` there.
  bool scatterWithoutRepeats = true;
  /// Tests for missing effects: noise levels from the widest model, offsets averaged over possible explanations, and
  /// the evidence. If false, noise levels assume a complete model.
  bool testMissingEffects = true;
  std::vector<Effect> effects = allEffects(); // candidates for missing effects
  CandidateTestOptions candidateTests;        // of a fitted model
  bool robust = true;                         // downweights and lists doubtful corners
  bool excludeDisplaced = true;               // if robust, also excludes observations whose board was displaced
  bool alternate = false; // alternates joints and cameras as Adikari's thesis does, instead of fitting all at once
  /// Of each first search; the fits that continue it have their own limit.
  int maxIterations = LevenbergMarquardtOptions{}.maxIterations;
  int restarts = 0; // additional random starts; the lowest cost wins
  std::uint64_t seed = 1;
  std::optional<Eigen::VectorXd>
      start;                       // initial unknowns; default: zero, with placements initialised from the pictures
  std::optional<double> tolerance; // largest bound of the task's error [m] at which a result is usable; default: `Task`
  std::optional<Loss> loss;        // loss under which `start` was found; continues that search
};

/// An explanation that alone makes a bound more than 1.5 times as wide as the likeliest explanation does.
struct Shoulder {
  std::vector<std::string> effects; // as of `Explanation`
  std::vector<std::string> without;
  double weight = 0; // its posterior weight, at least 0.0001
  double value = 0;  // under this explanation [the unknown's unit]
};

/// An estimate averaged over possible missing effects (`ModelAverage`). An average over models may be narrow with a far
/// shoulder, so that a multiple of its sigma is no bound.
struct Averaged {
  double value = 0, sigma = 0;
  std::array<double, 2> interval = {}; // 95 % between [low, high]
  std::array<double, 2> bound = {};    // 99.95 %
  std::optional<Shoulder> shoulder = {};
};

/// Estimate of one unknown.
struct Estimate {
  double value = 0;                      // under the model as given [the unknown's unit]
  double sigma = 0;                      // standard error, the misfit included
  double halfWidth = 0;                  // of the 95 % interval: Student's t if few poses determine the noise levels
  double freedom = 0;                    // degrees of freedom of that t distribution
  double learned = 0;                    // 1 - `bestSigma` / prior sigma, at least 0
  std::optional<Averaged> averaged = {}; // if `CalibrationOptions::testMissingEffects`

  /// Final value: averaged over possible missing effects if tested, else under the model as given.
  double best() const { return averaged ? averaged->value : value; }
  double bestSigma() const { return averaged ? averaged->sigma : sigma; }
  std::array<double, 2> interval() const {
    return averaged ? averaged->interval : std::array{value - halfWidth, value + halfWidth};
  }
};

/// One explanation of the captures: the model plus `effects` and curves, minus `without`.
struct Explanation {
  std::vector<std::string> effects; // labels of additional effects; empty: the model as given
  std::vector<std::string> without; // user-added effects that this explanation omits
  double weight = 0;                // posterior weight; all explanations sum to 1
};

/// A combination of unknowns that the captures hardly determine: a unit direction and the standard error along it, in
/// radians if all parts are angles, else in units of the prior sigmas.
struct WeakDirection {
  std::vector<std::pair<std::string, double>> parts; // (unknown, component)
  double sigma = 0;
  std::string unit; // "rad" or "prior sigmas"
  std::string sentence;
};

/// Displacement of a board in one picture against its place in all others, in the coordinates of its placement.
struct BoardMove {
  Eigen::VectorXd values, sigmas; // on the floor x, y [m], yaw [rad]; else x, y, z [m], roll, pitch, yaw [rad]

  double distance() const { return values.head(values.size() == 3 ? 2 : 3).norm(); } // [m]
};

/// A corner or a whole observation that disagrees with the rest. Outliers are kept and always listed.
struct Outlier {
  std::size_t picture = 0, observation = 0;
  std::vector<int> corners;           // corner ids; all ids of the observation if `whole`
  bool whole = false;                 // most of the observation disagrees: the board or robot was moved
  double distance = 0;                // rms residual of the outlying corners [px]
  std::optional<BoardMove> move = {}; // if `whole`, and if that its board was displaced explains the observation
};

/// A reading other than corners that disagrees with the rest. Kept with little or no weight, and always listed.
struct DoubtfulReading {
  std::size_t picture = 0, witness = 0;
};

/// What measurements of little or no weight have in common: a joint, "time", a board, a camera. Then they are no
/// accidents, and keep their weight.
struct SharedCause {
  std::string driver; // "LKneePitch", "approach of LKneePitch", "time", "board A", "camera top"
  double p = 1;       // probability that accidents share anything as strongly
};

/// Measurements that the fit's loss rejects (`outlierWeight`), and the errors that the others leave.
struct RejectedMeasurements {
  std::size_t views = 0, ofViews = 0;       // of boards, which do not lie where the others put them; of all
  std::size_t corners = 0, ofCorners = 0;   // on boards that lie where the others put them; of all corners
  std::size_t readings = 0, ofReadings = 0; // other than corners
  double presentPx = 0;                     // rms distance without displaced boards; as `CalibrationResult::rmsPx`
  double keptPx = 0;                        // the same without the rejected measurements
  ReadingErrors keptReadings;               // of the other readings

  /// Share of all measurements.
  double share() const {
    return static_cast<double>(corners + readings) / std::max(1.0, static_cast<double>(ofCorners + ofReadings));
  }
};

/// An effect or curve beyond chance that hardly changes what is predicted.
struct NegligibleEffect {
  std::string label, sizes; // "rollingShutter@top", "t = 0.3 ± 0.1 ms"; no sizes of a curve
  double movedPx = 0;       // rms displacement of predicted corners [px]
};

/// A mistake in how the captures were set up (setups/Catalogue.hpp).
struct WrongSetUp {
  std::string label;    // "reversedJoint@elbow"
  std::string why;      // a clause: "elbow's angles have the wrong sign (so corrected the error is 0.4 px)"
  std::string question; // to ask a person
  double odds = 0;      // x to 1 against the best other explanation
};

/// Overall quality of a result.
enum class ResultVerdict {
  good,         // the model explains the captures
  causeMissing, // usable, but an effect is missing and should be identified
  doNotUse
};

/// The point by which a result is judged, with its uncertainty [m] (`fillTask`).
struct Task {
  std::string what; // "ball at 2 m" or "tool"
  double sigma = 0, bound = 0;
  double tolerance = 0;
  bool isGiven = false; // the tolerance is the user's
};

/// The worst bias that the captures would not show with 80 % power (`ModelWindow::undetected`).
struct Undetectable {
  std::string effect; // that causes it: "elasticity@LKneePitch"
  std::string of;     // "task", or the joint whose offset it shifts
  double bias = 0;    // in `unit`
  std::string unit;   // "m", or the offset's
};

struct CalibrationResult {
  bool converged = false;
  ResultVerdict verdict = ResultVerdict::good;
  bool usable = false;           // verdict is not `doNotUse`
  std::string sentence;          // the verdict as a sentence, identical on all surfaces: that of the first finding
  std::vector<Finding> findings; // most serious first
  Eigen::VectorXd unknowns;
  std::vector<Estimate> estimates; // one per unknown
  Eigen::MatrixXd covariance;      // of the unknowns, at `misfit` (`temperPrecision`)
  Residuals::State state;
  std::vector<BoardResidual> residuals;          // at the estimate, including the joints' deflections
  std::vector<BoardResidual> withReportedAngles; // the same observations, with joint angles as read
  Noise noise;                                   // before scaling by `sigmaScale`
  std::string noiseSource; // "repeats", else "configured", also where pixel noise was estimated within pictures
  Loss loss;
  double rmsPx = 0, medianPx = 0; // corner distances, joint angles as read [px]; without corners `collectDistances`
  ReadingErrors readings;         // other measurements, joint angles as read
  double noiseFloorPx = 0;        // expected rms distance under noise alone [px]
  double chi2 = 0, dof = 0;
  double pValue = 1;                     // probability that pure noise shows evidence this strong for a missing effect
  bool matters = false;                  // the missing effect moves corners by more than `threshold::negligiblePx`
  double sigmaScale = 1;                 // sqrt(`misfit`): scale factor of the standard errors
  double misfit = 1;                     // chi2 / freedom between poses of the model as given, at least 1
  double misfitFreedom = 0;              // that freedom
  double misfitLeft = 1;                 // the same for the likeliest explanation
  double scatter = 0;                    // decrease of -2 ln likelihood from zero to the estimated pose noise
  std::vector<Explanation> explanations; // by decreasing weight; weights above 0.01
  std::vector<WrongSetUp> setUps;        // that explain the misfit; those were not mended
  std::vector<DataAnomaly> suspicious;   // a one-off event that explains the misfit, if any
  /// What is beyond chance, if it does not matter.
  std::optional<NegligibleEffect> negligible;
  std::vector<WeakDirection> weak;
  std::vector<Outlier> outliers;
  std::vector<DoubtfulReading> doubtfulReadings;
  std::vector<SharedCause> sharedCauses; // of measurements that lie far from the likeliest explanation
  RejectedMeasurements rejected;
  std::optional<Task> task;
  std::optional<Undetectable> undetectable;
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

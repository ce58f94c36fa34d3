#pragma once

#include "calibration/Calibration.hpp"
#include "io/InputError.hpp"
#include "math/LevenbergMarquardt.hpp"

namespace naocal {

using FitMinimum = Minimum<Residuals::State, Residuals::Linear>;

/// Minimum cost decrease of intermediate fits: they stop when unknowns would move by less than about a hundredth of a
/// sigma (cost = chi2 / 2).
constexpr double coarseTolerance = 1e-4;

/// A minimum of the cost under one noise level and loss.
struct Fit {
  Noise noise;
  Loss loss;
  FitMinimum minimum;
  bool restartsChanged = false;
};

/// Error for a search that ends with an observed corner behind its camera.
InputError behindCameraError();

/// First fit, with quadratic loss, from the start of `options` and its random restarts; or a continuation from that
/// start under its loss. Stops at `coarseTolerance`.
Fit fitInitially(const Measurements& measurements, const Model& model, const Noise& noise,
                 const CalibrationOptions& options);

/// rms distance of all corners from their prediction at the joint angles as read [px].
double rmsAsReported(const Measurements& measurements, const Model& model, const Fit& fit);

/// Continues from a fit under other noise levels or another loss, until the cost decreases by less than `smallestFall`.
Fit refit(const Measurements& measurements, const Model& model, const Noise& noise, const Loss& loss, Fit from,
          double smallestFall = LevenbergMarquardtOptions{}.minCostDecrease);

/// Minimum cost decrease of fits that are only compared: their costs differ by tens.
constexpr double comparisonTolerance = 0.01;

/// Fits from unknowns without known deflections; stops at `comparisonTolerance`.
Fit fitForComparison(const Measurements& measurements, const Model& model, const Noise& noise, const Loss& loss,
                     const Eigen::VectorXd& unknowns);

/// Robust refit: downweights corners far from their prediction. The loss scale follows the median distance, so that a
/// missing effect does not turn a whole board into outliers. Stops at `coarseTolerance`.
Fit fitRobustly(const Measurements& measurements, const Model& model, const Noise& noise, Fit from);

/// Loss weight below which a corner is an outlier: 4.5 sigma, 1 in 30 000 good corners.
constexpr double outlierWeight = 0.7;
/// True if more than half of the observation's corners are outliers.
bool isMostlyOutliers(const BoardResidual& observation);

/// Refit of a model that lacks an effect other than joint noise: adds the misfit beyond the noise floor to the pixel
/// noise, or keeps joints from scattering, whichever comes nearer to the pictures. Otherwise the fit deflects joints to
/// follow relative positions of sharp corners and ends up to several times farther from the pictures than necessary.
/// The result is stated at the noise of `from`; returns `from` unless the rms error falls by more than 10 %.
Fit refitWithMisfitNoise(const Measurements& measurements, const Model& model, const Fit& from);

} // namespace naocal

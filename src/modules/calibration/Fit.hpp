#pragma once

#include "calibration/Calibration.hpp"
#include "io/InputError.hpp"
#include "math/LevenbergMarquardt.hpp"

namespace naocal {

using FitMinimum = Minimum<Residuals::State, Residuals::Linear>;

/// Fits that only lead to noise levels and losses stop when they would move by less than a hundredth of their sigmas
/// (fall of the cost: half a chi2 unit).
constexpr double coarseTolerance = 1e-4;

/// The least cost of a model under one noise level and one loss.
struct Fit {
  Noise noise;
  Loss loss;
  FitMinimum minimum;
  bool restartsChanged = false;
};

/// A search ended where a corner that was seen lies behind its camera: what to say of such captures.
InputError behindCameraError();

/// From far: quadratic loss, from the start of `options` and as many random ones as it asks for; or on from that start,
/// under the loss that it was found with. Ends at `coarseTolerance`.
Fit fitInitially(const Measurements& measurements, const Model& model, const Noise& noise,
                 const CalibrationOptions& options);

/// On from a fit, under another noise level or loss, until the cost would fall by less than `minCostDecrease`.
Fit refit(const Measurements& measurements, const Model& model, const Noise& noise, const Loss& loss, Fit from,
          double smallestFall = LevenbergMarquardtOptions{}.minCostDecrease);

/// Fits that are only compared stop here: their costs differ by tens.
constexpr double nearly = 0.01;

/// On from unknowns whose deflections are not known; ends `nearly`.
Fit fitNearly(const Measurements& measurements, const Model& model, const Noise& noise, const Loss& loss,
              const Eigen::VectorXd& unknowns);

/// On from a fit: corners far off their prediction lose their weight. The loss's scale follows the median distance, so
/// that a model that misses something is not mistaken for a board full of false corners. Ends at `coarseTolerance`.
Fit fitRobustly(const Measurements& measurements, const Model& model, const Noise& noise, Fit from);

/// A corner of less weight is beyond 5 sigma: one of 200 000 good ones.
constexpr double trusted = 0.7;
/// Most corners of a board in a picture are such.
bool hasLostWeight(const BoardResidual& sighting);

/// On from a fit of a model that lacks an effect: where whole boards lost their weight, which a wrong model predicts
/// worst and which are not false, corners lose it only beyond what the model leaves of nearly all of them.
Fit fitFully(const Measurements& measurements, const Model& model, Fit from);

/// On from a fit of a model that lacks an effect of another kind than its noise: what it leaves beyond the noise floor
/// counts as noise of every corner. Else it bends joints, which may scatter, to follow what sharp corners say of each
/// other, and lies up to several times farther from the pictures than it need. The fit is stated at the noise of
/// `from`, and is that one where the error would hardly fall.
Fit weighByMisfit(const Measurements& measurements, const Model& model, const Fit& from);

} // namespace naocal

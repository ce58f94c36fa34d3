#pragma once

#include "calibration/Calibration.hpp"
#include "calibration/Fit.hpp"

#include <optional>
#include <vector>

namespace naocal {

/// Lists corners downweighted by the loss, and observations that lost most of their corners that way.
std::vector<Outlier> findOutliers(const Measurements& measurements, const CalibrationResult& result);

/// Lists readings downweighted by the loss.
std::vector<DoubtfulReading> findDoubtfulReadings(const std::vector<WitnessResidual>& residuals);

/// The measurements with the weights that a fit's loss gives them (`CornerBlock::present`,
/// `WitnessObservation::weight`), so that other models are fitted to the same ones. Absent if all keep their weight.
std::optional<Measurements> weighDoubtful(const Measurements& measurements, const Model& model, const Fit& fit);

/// Share of corners and readings whose weight is below `outlierWeight` in a fit: the larger of the two shares.
double shareOfDoubtful(const Measurements& measurements, const Model& model, const Fit& fit);

/// Number of board views: pairs of a picture and a board seen in it.
std::size_t countViews(const Measurements& measurements);

/// Removes a picture's readings from the measurements.
void excludeReadings(Measurements& measurements, std::size_t picture);

/// Evidence that the board was displaced in this one picture (or the robot stood differently).
struct BoardDisplacement {
  std::size_t picture = 0, observation = 0;
  double chi2 = 0;     // decrease of chi2 with a free board; chi2 with six degrees of freedom under the null
  double distance = 0; // rms displacement of its corners [px]
};

/// Score test of a free rigid motion of each observation's board against a fit that holds it in place:
///
///   chi2 = g^T V^-1 g,   g = L^T Sigma^-1 r,   V = L^T (Sigma^-1 - Sigma^-1 J H^-1 J^T Sigma^-1) L
///
/// (Cox, Hinkley: Theoretical statistics, 1974, section 9.3). The robust loss misses such displacements: where many
/// corners move together, deflecting the joints costs less than rejecting every corner.
std::vector<BoardDisplacement> testDisplacements(const Measurements& measurements, const Model& model, const Fit& fit);

/// The most displaced observation, if significant (false-alarm rate `threshold::movedBoardAlarm` per set of captures)
/// and displaced by at least `threshold::negligiblePx`. `misfit`: overall chi2 / freedom; the statistic is divided by
/// it.
std::optional<BoardDisplacement> findDisplacedBoard(const Measurements& measurements, const Model& model,
                                                    const Fit& fit, double misfit = 1);

/// Removes an observation's corners from the measurements. The observation keeps its place in the lists.
void excludeObservation(Measurements& measurements, const BoardDisplacement& move);

} // namespace naocal

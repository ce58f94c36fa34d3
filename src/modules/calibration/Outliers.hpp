#pragma once

#include "calibration/Calibration.hpp"
#include "calibration/Fit.hpp"

#include <optional>
#include <vector>

namespace naocal {

/// Corners whose weight the loss took away, and sightings that lost most of their corners that way.
std::vector<Outlier> findOutliers(const Measurements& measurements, const CalibrationResult& result);

/// Boards in pictures that do not lie where all others put them, of all boards in pictures.
struct Accidents {
  std::size_t moved = 0, all = 0;

  Accidents() = default;
  Accidents(const Measurements& measurements, const std::vector<Outlier>& doubts);

  bool any() const { return moved > 0; }
  /// More than a picture or two in a set: worth a word.
  bool areMany() const { return isMore(0.05); }
  /// More than accidents move: the model is wrong, and must see them.
  bool areTooMany() const { return isMore(0.2); }
  /// How many may be set aside as accidents.
  std::size_t mostSetAside() const;

private:
  bool isMore(double share) const { return static_cast<double>(moved) > share * static_cast<double>(all); }
};

/// How much a sighting asks that its board, in this one picture, lay elsewhere (or the robot stood differently).
struct BoardDisplacement {
  std::size_t picture = 0, sighting = 0;
  double chi2 = 0;     // fall of chi2 if the board were free: chi2 with six degrees of freedom where nothing moved
  double distance = 0; // rms of how far its corners would go [px]
};

/// Score test of a free rigid motion of each sighting's board, against a fit that holds it in place:
///
///   chi2 = g^T V^-1 g,   g = L^T Sigma^-1 r,   V = L^T (Sigma^-1 - Sigma^-1 J H^-1 J^T Sigma^-1) L
///
/// (Cox, Hinkley: Theoretical statistics, 1974, section 9.3). It sees what the corners' own loss cannot: where many
/// corners moved together it costs less to bend the joints, against their noise, than to give up every corner.
std::vector<BoardDisplacement> testDisplacements(const Measurements& measurements, const Model& model, const Fit& fit);

/// The sighting that moved most, if any did beyond doubt (once in a million sets of captures in which nothing moved)
/// and by more than a detector's own bias. `misfit`: what the model misses everywhere, in chi2 per freedom; a move must
/// stand out from that.
std::optional<BoardDisplacement> findDisplacedBoard(const Measurements& measurements, const Model& model,
                                                    const Fit& fit, double misfit = 1);

/// The same measurements without the corners of a sighting: it stays in the lists, but counts nothing.
void excludeObservation(Measurements& measurements, const BoardDisplacement& move);

} // namespace naocal

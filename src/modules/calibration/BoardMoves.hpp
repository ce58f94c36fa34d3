#pragma once

#include "calibration/Fit.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace naocal {

/// The unknowns of a board's displacement: x, y, yaw on the floor, else all six.
std::vector<Unknown> boardMoveUnknowns(bool isFlat);

/// A board's displacement in one picture as a term: added to its placement at that instant only.
Term makeBoardMove(const Measurements& measurements, std::size_t picture, std::size_t observation);

/// Fills `Outlier::move` of whole observations: refits with the displacements of all of them in the model, at the noise
/// of `fit`. An observation whose corners still lie beyond noise was no displaced board and gets none.
void estimateBoardMoves(const Measurements& measurements, const Model& model, const Fit& fit,
                        CalibrationResult& result);

/// "30.2 ± 0.6 mm elsewhere (x +29.1 ± 0.5 mm, y -7.6 ± 0.8 mm, yaw +0.10 ± 0.15°)".
std::string describeBoardMove(const BoardMove& move);

/// "board A lies 30.2 ± 0.6 mm elsewhere (...) in capture 17 than in all others", of an outlier with a move.
std::string describeDisplacedBoard(const Measurements& measurements, const Outlier& outlier);

} // namespace naocal

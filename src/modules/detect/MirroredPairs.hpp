#pragma once

#include "detect/CornerFit.hpp"

#include <functional>

namespace naocal {

/// The window in which a corner is fitted: pairs of places opposite to each other on the board.
///
/// In each direction of the board it reaches `reach` squares, but at least 2 px (less tells nothing) and at most 7 px
/// (more costs time); so it is as flat in the picture as the board. The weight falls towards its rim.
/// `pixelFromBoard` maps squares to pixels; `risingIsWhite`: the squares at the upper right and lower left are white.
std::vector<MirroredPair> mirroredPairs(const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& pixelFromBoard,
                                        const Eigen::Vector2d& corner, double reach, bool risingIsWhite);

} // namespace naocal

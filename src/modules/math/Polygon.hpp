#pragma once

#include <Eigen/Core>
#include <vector>

namespace naocal {

/// The corners of a convex area on the floor, counter-clockwise [m].
using Outline = std::vector<Eigen::Vector2d>;

/// How deep a point lies inside: its distance to the nearest side's line, negative outside [m].
double depthInside(const Outline& outline, const Eigen::Vector2d& point);

/// The convex outline around some points, corners on a side left out.
Outline hull(const Outline& points);

/// The mean of its corners.
Eigen::Vector2d middle(const Outline& outline);

/// Whether a point lies within the convex outline around some points.
bool withinHull(const Outline& points, const Eigen::Vector2d& point);

/// Whether a side of one of the two has the whole other one beyond it.
bool apart(const Outline& a, const Outline& b);

} // namespace naocal

#pragma once

#include <Eigen/Core>
#include <vector>

namespace naocal {

/// The corners of a convex area on the floor, counter-clockwise [m].
using ConvexPolygon = std::vector<Eigen::Vector2d>;

/// How deep a point lies inside: its distance to the nearest side's line, negative outside [m].
double insideDepth(const ConvexPolygon& outline, const Eigen::Vector2d& point);

/// The convex outline around some points, corners on a side left out.
ConvexPolygon convexHull(const ConvexPolygon& points);

/// The mean of its corners.
Eigen::Vector2d vertexMean(const ConvexPolygon& outline);

/// Whether a point lies within the convex outline around some points.
bool hullContains(const ConvexPolygon& points, const Eigen::Vector2d& point);

/// Whether a side of one of the two has the whole other one beyond it.
bool areSeparated(const ConvexPolygon& a, const ConvexPolygon& b);

} // namespace naocal

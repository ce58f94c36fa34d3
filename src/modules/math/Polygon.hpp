#pragma once

#include <Eigen/Core>
#include <vector>

namespace naocal {

/// Vertices of a convex area on the floor, counter-clockwise [m].
using ConvexPolygon = std::vector<Eigen::Vector2d>;

/// Depth of a point inside: distance to the nearest side's line, negative outside [m].
double insideDepth(const ConvexPolygon& outline, const Eigen::Vector2d& point);

/// Convex hull of some points, without collinear vertices.
ConvexPolygon convexHull(const ConvexPolygon& points);

/// Mean of the vertices.
Eigen::Vector2d vertexMean(const ConvexPolygon& outline);

/// Whether a point lies within the convex hull of some points.
bool hullContains(const ConvexPolygon& points, const Eigen::Vector2d& point);

/// Whether a side of one polygon separates it from the other.
bool areSeparated(const ConvexPolygon& a, const ConvexPolygon& b);

} // namespace naocal

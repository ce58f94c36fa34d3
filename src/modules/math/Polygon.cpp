#include "math/Polygon.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <limits>
#include <numeric>

namespace naocal {

double insideDepth(const ConvexPolygon& outline, const Eigen::Vector2d& point) {
  double depth = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d side = outline[(i + 1) % outline.size()] - outline[i];
    const Eigen::Vector2d inwards{-side.y(), side.x()};
    depth = std::min(depth, inwards.dot(point - outline[i]) / side.norm());
  }
  return depth;
}

ConvexPolygon convexHull(const ConvexPolygon& points) {
  namespace geometry = boost::geometry;
  using Point = geometry::model::d2::point_xy<double>;
  constexpr bool clockwise = false, closed = false;
  geometry::model::multi_point<Point> all;
  for (const Eigen::Vector2d& point : points) {
    all.emplace_back(point.x(), point.y());
  }
  geometry::model::ring<Point, clockwise, closed> ring;
  geometry::convex_hull(all, ring);
  ConvexPolygon result;
  for (const Point& corner : ring) {
    result.emplace_back(corner.x(), corner.y());
  }
  return result;
}

bool hullContains(const ConvexPolygon& points, const Eigen::Vector2d& point) {
  // Outside the hull, all points lie in a wedge from `right` to `left` of less than 180 degrees, seen from `point`.
  const auto turn = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); };
  Eigen::Vector2d right = points.front() - point, left = right;
  for (const Eigen::Vector2d& other : points) {
    const Eigen::Vector2d to = other - point;
    const bool beyondLeft = turn(left, to) > 0, beyondRight = turn(right, to) < 0;
    if (beyondLeft && beyondRight) {
      return true;
    }
    left = beyondLeft ? to : left;
    right = beyondRight ? to : right;
  }
  return false;
}

Eigen::Vector2d vertexMean(const ConvexPolygon& outline) {
  const Eigen::Vector2d sum = std::accumulate(outline.begin(), outline.end(), Eigen::Vector2d::Zero().eval());
  return sum / static_cast<double>(outline.size());
}

bool areSeparated(const ConvexPolygon& a, const ConvexPolygon& b) {
  const auto hasBeyond = [](const ConvexPolygon& one, const ConvexPolygon& other) {
    for (std::size_t i = 0; i < one.size(); ++i) {
      const Eigen::Vector2d side = one[(i + 1) % one.size()] - one[i];
      const Eigen::Vector2d inwards{-side.y(), side.x()};
      if (std::all_of(other.begin(), other.end(),
                      [&](const Eigen::Vector2d& corner) { return inwards.dot(corner - one[i]) < 0; })) {
        return true;
      }
    }
    return false;
  };
  return hasBeyond(a, b) || hasBeyond(b, a);
}

} // namespace naocal

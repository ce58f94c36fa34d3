#include "hardware/simulated/RestingPlane.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

namespace naocal {
namespace {

using Triangle = std::array<std::size_t, 3>;

/// Barycentric coordinates of the centre of mass (x, y); all positive inside the triangle.
Eigen::Vector3d weights(const std::vector<Eigen::Vector3d>& points, const Triangle& triangle,
                        const Eigen::Vector3d& centre) {
  Eigen::Matrix3d corners;
  for (int i = 0; i < 3; ++i) {
    corners.col(i) << points[triangle[std::size_t(i)]].head<2>(), 1;
  }
  return corners.inverse() * Eigen::Vector3d{centre.x(), centre.y(), 1};
}

/// The plane z = a x + b y + c through the corners.
Eigen::Vector3d plane(const std::vector<Eigen::Vector3d>& points, const Triangle& triangle) {
  Eigen::Matrix3d places;
  Eigen::Vector3d heights;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d& point = points[triangle[std::size_t(i)]];
    places.row(i) << point.x(), point.y(), 1;
    heights[i] = point.z();
  }
  return places.inverse() * heights;
}

/// The lower face below `centre`, z up. The last three points are far-away sentinels: a solution that uses one of them
/// is no support.
std::optional<Triangle> lowerFace(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& centre) {
  constexpr double below = 1e-12; // [m]; smaller penetrations are rounding errors
  Triangle triangle{points.size() - 3, points.size() - 2, points.size() - 1};
  for (int exchange = 0; exchange < 200; ++exchange) {
    const Eigen::Vector3d floor = plane(points, triangle);
    std::size_t lowest = 0;
    double depth = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double here = points[i].z() - floor.dot(Eigen::Vector3d{points[i].x(), points[i].y(), 1});
      if (here < depth) {
        depth = here;
        lowest = i;
      }
    }
    if (depth > -below) {
      break;
    }
    // The exchanged corner: the remaining triangle contains the centre.
    double best = -1;
    Triangle next = triangle;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      Triangle candidate = triangle;
      candidate[corner] = lowest;
      const double least = weights(points, candidate, centre).minCoeff();
      if (std::isfinite(least) && least > best) {
        best = least;
        next = candidate;
      }
    }
    triangle = next;
  }
  for (const std::size_t corner : triangle) {
    if (corner + 3 >= points.size()) {
      return std::nullopt;
    }
  }
  return triangle;
}

} // namespace

std::optional<RestingPlane> findRestingPlane(const std::vector<Eigen::Vector3d>& points,
                                             const Eigen::Vector3d& centreOfMass, const Eigen::Vector3d& up,
                                             double mostTilt) {
  constexpr double settled = 1e-8; // [rad]; faces that differ less are one (1e-12 m across 0.1 mm)
  RestingPlane resting{up.normalized(), 0, {}};
  for (int tilt = 0; tilt < 50; ++tilt) {
    const Eigen::Matrix3d uprightFromBody =
        Eigen::Quaterniond::FromTwoVectors(resting.up, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    std::vector<Eigen::Vector3d> upright;
    upright.reserve(points.size() + 3);
    for (const Eigen::Vector3d& point : points) {
      upright.push_back(uprightFromBody * point);
    }
    const Eigen::Vector3d centre = uprightFromBody * centreOfMass;
    for (const double angle : {0.1, 2.2, 4.3}) { // [rad]
      upright.emplace_back(centre.x() + 10 * std::cos(angle), centre.y() + 10 * std::sin(angle), 100);
    }
    const auto face = lowerFace(upright, centre);
    if (!face) {
      return std::nullopt;
    }
    const Eigen::Vector3d floor = plane(upright, *face);
    const Eigen::Vector3d normal = Eigen::Vector3d{-floor.x(), -floor.y(), 1}.normalized();
    const Eigen::Vector3d before = resting.up;
    resting = {uprightFromBody.transpose() * normal, 0, *face};
    resting.height = resting.up.dot(points[(*face)[0]]);
    if (std::acos(std::min(1.0, resting.up.dot(up.normalized()))) > mostTilt) {
      return std::nullopt;
    }
    if ((resting.up - before).norm() < settled) {
      return resting;
    }
  }
  return std::nullopt; // does not converge: tipping over
}

} // namespace naocal

#include "evidence/MountCurves.hpp"

#include <algorithm>
#include <set>

namespace naocal {

namespace {

constexpr Eigen::Index mostPolynomials = 2;

/// Whether this joint turns the head, and the camera with it.
bool carries(const Robot& robot, std::size_t joint, std::size_t camera) {
  std::optional<std::size_t> link = robot.cameras[camera].link;
  while (link && robot.links[*link].joint != joint) {
    link = robot.links[*link].parent;
  }
  return link.has_value();
}

bool canDrive(const DriverValues& driver, const Robot& robot, std::size_t camera) {
  return driver.kind == Driver::time || (driver.kind == Driver::angle && carries(robot, driver.joint, camera));
}

double valueAt(const Instant& instant, Driver kind, std::size_t joint) {
  return kind == Driver::time ? instant.time.count() : instant.q[static_cast<Eigen::Index>(joint)];
}

Effect turning(const DriverValues& driver, const DriverCell& cell) {
  Effect effect{.name = "mountTurns",
                .what = {},
                .formula = {},
                .place = Place::camera,
                .unknowns = {},
                .correct = [kind = driver.kind, joint = driver.joint,
                            cell](Belief& belief, const Instant& instant, std::size_t, std::span<const double> values) {
                  const Eigen::RowVectorXd basis = cell.basis(valueAt(instant, kind, joint));
                  const Eigen::Map<const Eigen::Matrix3Xd> coefficients{values.data(), 3, cell.count};
                  belief.mountRotation() += coefficients * basis.transpose();
                }};
  for (Eigen::Index n = 1; n <= cell.count; ++n) {
    for (const char* axis : {"x", "y", "z"}) {
      effect.unknowns.push_back({axis + std::to_string(n), "rad", plausibleCurve});
    }
  }
  return effect;
}

} // namespace

std::vector<MountCurve> mountCurves(const Measurements& measurements, const std::vector<DriverValues>& drivers) {
  std::vector<MountCurve> result;
  for (std::size_t camera = 0; camera < measurements.robot.cameras.size(); ++camera) {
    for (std::size_t i = 0; i < drivers.size(); ++i) {
      if (!canDrive(drivers[i], measurements.robot, camera)) {
        continue;
      }
      std::vector<double> values;
      for (std::size_t picture = 0; picture < measurements.pictures.size(); ++picture) {
        if (measurements.pictures[picture].camera == camera && !measurements.pictures[picture].sightings.empty()) {
          values.push_back(drivers[i].atPicture[picture]);
        }
      }
      const std::set<double> distinct = distinctValues(values);
      if (distinct.size() < 2) {
        continue;
      }
      DriverCell cell = smoothCell(distinct, mostPolynomials);
      cell.driver = i;
      result.push_back(
          {{turning(drivers[i], cell), camera, measurements.robot.cameras[camera].name + " over " + drivers[i].name},
           cell});
    }
  }
  return result;
}

} // namespace naocal

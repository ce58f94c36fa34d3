#include "diagnose/MountCurves.hpp"

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

Effect turning(const DriverValues& driver, Eigen::Index count, double middle, double half) {
  Effect effect{.name = "mountTurns",
                .what = {},
                .formula = {},
                .place = Place::camera,
                .unknowns = {},
                .correct = [kind = driver.kind, joint = driver.joint, count, middle,
                            half](Belief& belief, const Instant& instant, std::size_t, std::span<const double> values) {
                  const Eigen::RowVectorXd basis = curveBasis((valueAt(instant, kind, joint) - middle) / half, count);
                  const Eigen::Map<const Eigen::Matrix3Xd> coefficients{values.data(), 3, count};
                  belief.mountRotation() += coefficients * basis.transpose();
                }};
  for (Eigen::Index n = 1; n <= count; ++n) {
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
      std::set<double> distinct;
      for (std::size_t picture = 0; picture < measurements.pictures.size(); ++picture) {
        if (measurements.pictures[picture].camera == camera && !measurements.pictures[picture].sightings.empty()) {
          distinct.insert(drivers[i].atPicture[picture]);
        }
      }
      if (distinct.size() < 2) {
        continue;
      }
      const double middle = (*distinct.begin() + *distinct.rbegin()) / 2, half = *distinct.rbegin() - middle;
      const Eigen::Index count = std::min<Eigen::Index>(mostPolynomials, std::ssize(distinct) - 1);
      result.push_back({{turning(drivers[i], count, middle, half), camera,
                         measurements.robot.cameras[camera].name + " over " + drivers[i].name},
                        i,
                        count,
                        middle,
                        half});
    }
  }
  return result;
}

} // namespace naocal

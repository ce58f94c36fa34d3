#include "evidence/Drivers.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace naocal {

namespace {

/// Adds a driver unless it was not recorded or is the same everywhere.
void add(std::vector<DriverValues>& drivers, DriverValues driver, const std::vector<Instant>& instants,
         const std::function<double(const Instant&)>& value) {
  for (const Instant& instant : instants) {
    driver.atPicture.push_back(value(instant));
  }
  const auto [least, most] = std::minmax_element(driver.atPicture.begin(), driver.atPicture.end());
  if (std::all_of(driver.atPicture.begin(), driver.atPicture.end(), [](double x) { return std::isfinite(x); }) &&
      *most - *least > leastChange) {
    drivers.push_back(std::move(driver));
  }
}

} // namespace

std::vector<DriverValues> driversOf(const Measurements& measurements, const Model& model,
                                    const Eigen::VectorXd& unknowns) {
  std::vector<Instant> instants;
  for (const Picture& picture : measurements.pictures) {
    instants.push_back(instantOf(measurements, model, picture, unknowns));
  }
  std::vector<DriverValues> drivers;
  for (std::size_t joint : measurements.joints) {
    const std::string& name = measurements.robot.joints[joint].name;
    const auto index = static_cast<Eigen::Index>(joint);
    add(drivers, {.kind = Driver::angle, .joint = joint, .name = name, .unit = "rad", .what = "the angle of " + name},
        instants, [index](const Instant& instant) { return instant.q[index]; });
    add(drivers,
        {.kind = Driver::torque, .joint = joint, .name = "tau_" + name, .unit = "Nm", .what = "the torque on " + name},
        instants, [index](const Instant& instant) { return instant.torque[index]; });
    add(drivers,
        {.kind = Driver::approach,
         .joint = joint,
         .name = "approach",
         .unit = "1",
         .what = "how it was approached",
         .motor = joint},
        instants, [index](const Instant& instant) { return instant.approach[index]; });
    add(drivers,
        {.kind = Driver::temperature,
         .joint = joint,
         .name = "T",
         .unit = "°C",
         .what = "its temperature",
         .motor = joint},
        instants, [index](const Instant& instant) { return instant.temperature[index]; });
    add(drivers,
        {.kind = Driver::velocity, .joint = joint, .name = "qd", .unit = "rad/s", .what = "its speed", .motor = joint},
        instants, [index](const Instant& instant) { return instant.velocity[index]; });
  }
  add(drivers, {.kind = Driver::time, .name = "t", .unit = "s", .what = "time"}, instants,
      [](const Instant& instant) { return instant.time.count(); });
  return drivers;
}

std::string nameAt(const DriverValues& driver, std::size_t motor) {
  if (driver.joint == motor && driver.kind == Driver::angle) {
    return "q";
  }
  return driver.joint == motor && driver.kind == Driver::torque ? "tau" : driver.name;
}

} // namespace naocal

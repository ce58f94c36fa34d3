#include "robot/Robot.hpp"

#include "io/InputError.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>

namespace naocal {

namespace {

template <typename Named> std::optional<std::size_t> indexOf(const std::vector<Named>& all, std::string_view name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
  if (found == all.end()) {
    return std::nullopt;
  }
  return static_cast<std::size_t>(found - all.begin());
}

AngleRange interpolateLimits(const CoupledLimits& coupled, double angle) {
  const auto& angles = coupled.angles;
  const auto above = static_cast<std::size_t>(std::upper_bound(angles.begin(), angles.end(), angle) - angles.begin());
  if (above == 0) {
    return coupled.ranges.front();
  }
  if (above == angles.size()) {
    return coupled.ranges.back();
  }
  const AngleRange &low = coupled.ranges[above - 1], &high = coupled.ranges[above];
  const double share = (angle - angles[above - 1]) / (angles[above] - angles[above - 1]);
  return {std::lerp(low.lower, high.lower, share), std::lerp(low.upper, high.upper, share)};
}

} // namespace

std::optional<std::size_t> Robot::jointIndex(std::string_view name) const {
  return indexOf(joints, name);
}

std::optional<std::size_t> Robot::linkIndex(std::string_view name) const {
  return indexOf(links, name);
}

std::optional<std::size_t> Robot::lengthIndex(std::string_view name) const {
  return indexOf(lengths, name);
}

std::optional<std::size_t> Robot::cameraIndex(std::string_view name) const {
  return indexOf(cameras, name);
}

const Sole* Robot::findSole(std::string_view name) const {
  const auto index = indexOf(soles, name);
  return index ? &soles[*index] : nullptr;
}

std::size_t requireLink(const Robot& robot, const std::string& place, std::string_view link) {
  const auto index = robot.linkIndex(link);
  if (!index) {
    throw InputError{fmt::format("{}: expected a link of {}, found \"{}\"", place, robot.model, link)};
  }
  return *index;
}

AngleRange jointLimitsAt(const Robot& robot, std::size_t joint, const Eigen::VectorXd& angles) {
  AngleRange limits = robot.joints[joint].limits;
  if (const auto& coupled = robot.joints[joint].coupled) {
    const AngleRange there = interpolateLimits(*coupled, angles[static_cast<Eigen::Index>(coupled->onJoint)]);
    limits = {std::max(limits.lower, there.lower), std::min(limits.upper, there.upper)};
  }
  return limits;
}

std::filesystem::path configurationDirectory() {
  if (const char* given = std::getenv("NAOCAL_CONFIGURATION"); given != nullptr && *given != '\0') {
    return given;
  }
  std::error_code unreadable;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", unreadable);
  const auto above = program.parent_path().parent_path(); // the prefix of bin, or its libexec
  for (const auto& prefix : {above, above.parent_path()}) {
    const auto installed = prefix / "share" / "naocal" / "configuration";
    if (!unreadable && std::filesystem::is_directory(installed)) {
      return installed;
    }
  }
  return NAOCAL_SOURCE_CONFIGURATION;
}

std::array<Eigen::Vector3d, 2> bearingNormals(const Eigen::Vector3d& axis) {
  Eigen::Index along = 0;
  for (Eigen::Index i = 1; i < 3; ++i) {
    along = std::abs(axis[i]) >= std::abs(axis[along]) ? i : along;
  }
  const Eigen::Vector3d next = Eigen::Vector3d::Unit((along + 1) % 3);
  const Eigen::Vector3d n1 = (next - axis.dot(next) * axis).normalized();
  return {n1, axis.cross(n1)};
}

} // namespace naocal

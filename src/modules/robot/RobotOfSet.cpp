#include "robot/RobotOfSet.hpp"

#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "robot/Kinematics.hpp"
#include "robot/Urdf.hpp"
#include "robot/UrdfChecks.hpp"
#include "robot/UrdfContent.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <span>

namespace naocal {

namespace {

/// `description`: what lists the robot's joints, for error messages.
void requireJoints(const Robot& robot, const CaptureSet& set, const std::string& description) {
  for (const std::string& name : set.jointNames) {
    if (!robot.jointIndex(name)) {
      throw InputError{
          fmt::format("{}: jointNames: expected movable joints of {}, found \"{}\"", set.name, description, name)};
    }
  }
}

CameraMount mountOf(const Robot& robot, const CaptureSet& set, const std::string& name,
                    const CameraMounting& mounting) {
  const bool inWorld = mounting.link == "world";
  const RigidTransform linkFromMount = transformFromPlacement(
      mounting.placement.value_or(inWorld ? mounting.guess.value_or(Placement{}) : Placement{}).numbers());
  const Eigen::Matrix3d mountFromCamera = mounting.isOptical ? opticalFromCamera() : Eigen::Matrix3d::Identity();
  return {.name = name,
          .link = inWorld ? robot.base
                          : requireLink(robot, fmt::format("{}: cameras.{}.link", set.name, name), mounting.link),
          .inWorld = inWorld,
          .translation = linkFromMount.translation,
          .rotation = linkFromMount.rotation * mountFromCamera};
}

/// Adds the frame of a sole as a link of its own, once.
void addSole(const CaptureSet& set, const std::string& place, const std::string& name, Robot& robot) {
  if (robot.findSole(name)) {
    return;
  }
  const std::size_t foot = requireLink(robot, place, name);
  const auto given = set.soles.find(name);
  const RigidTransform footFromSole =
      transformFromPlacement((given == set.soles.end() ? Placement{} : given->second).numbers());
  Link sole{.name = name + " sole", .parent = foot, .constant = footFromSole.translation};
  sole.rotation = footFromSole.rotation;
  robot.soles.push_back({.name = name, .link = robot.links.size()});
  robot.links.push_back(std::move(sole));
}

std::filesystem::path findUrdf(const CaptureSet& set) {
  const auto file = fileInside(set.folder, set.urdf);
  if (!file) {
    throw InputError{fmt::format("{}: robot.urdf: expected a file within the set's folder, found a path out of it; "
                                 "copy the URDF into the set",
                                 (set.folder / set.urdf).string())};
  }
  return *file;
}

/// Adds the soles and cameras of a set.
void addMounts(const CaptureSet& set, Robot& robot) {
  for (const Stance& stance : set.stances) {
    for (const std::string& link : stance.supportLinks) {
      addSole(set, fmt::format("{}: stances[{}].supportLinks", set.name, stance.id), link, robot);
    }
  }
  for (const auto& [link, sole] : set.soles) {
    addSole(set, set.name + ": soles", link, robot);
  }
  for (const auto& [name, mounting] : set.mountings) {
    if (!robot.cameraIndex(name)) {
      robot.cameras.push_back(mountOf(robot, set, name, mounting));
    }
  }
}

/// Whether a set's URDF says the same as this one's text.
bool hasUrdf(const CaptureSet& set, const std::string& urdf) {
  const std::filesystem::path file = findUrdf(set);
  const std::string own = readUrdf(file);
  if (own == urdf) {
    return true;
  }
  checkUrdf(own, file.string());
  return urdfContent(own) == urdfContent(urdf);
}

/// `urdf`: the text of the first set's.
void refuseOtherUrdf(const CaptureSet& set, const CaptureSet& first, const std::string& urdf) {
  if (set.urdf.empty() || set.base != first.base || !hasUrdf(set, urdf)) {
    throw InputError{fmt::format("{}: robot: expected the URDF and the base of {}, found others; sets given together "
                                 "must be of one robot",
                                 set.name, first.name)};
  }
}

void refuseOtherMounts(const CaptureSet& set, const CaptureSet& first) {
  for (const auto& [name, mounting] : set.mountings) {
    const auto other = first.mountings.find(name);
    if (other != first.mountings.end() && mounting.link != "world" &&
        (mounting.link != other->second.link || mounting.placement.value_or(Placement{}).numbers() !=
                                                    other->second.placement.value_or(Placement{}).numbers())) {
      throw InputError{fmt::format("{}: cameras.{}: expected the link and the placement that {} gives, found others; "
                                   "sets given together must be of one robot",
                                   set.name, name, first.name)};
    }
  }
}

Robot loadUrdfOf(std::span<const CaptureSet> sets) {
  const CaptureSet& first = sets.front();
  const std::filesystem::path file = findUrdf(first);
  const std::string urdf = readUrdf(file);
  Robot robot = parseUrdf(urdf, file.string());
  if (!first.base.empty()) {
    robot.base = requireLink(robot, first.name + ": robot.base", first.base);
  }
  for (const CaptureSet& set : sets.subspan(1)) {
    refuseOtherUrdf(set, first, urdf);
    refuseOtherMounts(set, first);
  }
  for (const CaptureSet& set : sets) {
    requireJoints(robot, set, set.urdf);
    addMounts(set, robot);
  }
  return robot;
}

} // namespace

Robot loadRobot(const CaptureSet& set, const std::filesystem::path& configuration) {
  return loadRobot(std::span{&set, 1}, configuration);
}

Robot loadRobot(std::span<const CaptureSet> sets, const std::filesystem::path& configuration) {
  const CaptureSet& set = sets.front();
  if (!set.urdf.empty()) {
    return loadUrdfOf(sets);
  }
  Robot robot = loadRobot(configuration, set.model);
  if (!set.model.starts_with('V')) { // a NAO's names are checked with the file; its hands move no link
    requireJoints(robot, set, "the " + set.model);
  }
  return robot;
}

} // namespace naocal

#include "robot/Urdf.hpp"

#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "robot/UrdfChecks.hpp"
#include "robot/UrdfShapes.hpp"

#include <Eigen/Geometry>
#include <console_bridge/console.h>
#include <fmt/format.h>
#include <limits>
#include <mutex>
#include <urdf_parser/urdf_parser.h>

namespace naocal {

namespace {

constexpr std::uintmax_t largestUrdf = std::uintmax_t{64} << 20; // [bytes]

/// Keeps the first message of the library, which otherwise prints it, as long as the object exists. One at a time.
class FirstMessage : public console_bridge::OutputHandler {
public:
  FirstMessage() { console_bridge::useOutputHandler(this); }
  ~FirstMessage() override { console_bridge::restorePreviousOutputHandler(); }
  FirstMessage(const FirstMessage&) = delete;
  FirstMessage& operator=(const FirstMessage&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR && text_.empty()) {
      text_ = text;
    }
  }
  const std::string& text() const { return text_; }

private:
  std::string text_;
};

urdf::ModelInterfaceSharedPtr parseModel(const std::string& text, const std::string& name) {
  static std::mutex only; // the library's output handler is global
  const std::lock_guard lock{only};
  const FirstMessage message;
  auto model = urdf::parseURDF(text);
  if (!model) {
    throw InputError{fmt::format("{}: expected a URDF, found one that cannot be read ({})", name,
                                 message.text().empty() ? "no reason was given" : message.text())};
  }
  return model;
}

Eigen::Vector3d vectorOf(const urdf::Vector3& vector) {
  return {vector.x, vector.y, vector.z};
}

/// Reads a tree of links into a robot.
class UrdfReader {
public:
  UrdfReader(const urdf::ModelInterface& model, std::string name) : model_{model}, name_{std::move(name)} {}

  Robot read() {
    robot_.model = model_.getName();
    addLink(*model_.getRoot(), std::nullopt);
    for (Joint& joint : robot_.joints) {
      resolveMimic(joint);
    }
    return std::move(robot_);
  }

private:
  [[noreturn]] void refuse(const std::string& place, const std::string& expected, const std::string& found) const {
    throw InputError{fmt::format("{}, {}: expected {}, found {}", name_, place, expected, found)};
  }

  void addLink(const urdf::Link& drawn, std::optional<std::size_t> parent) {
    const std::size_t index = robot_.links.size();
    Link& link = robot_.links.emplace_back();
    link.name = drawn.name;
    link.parent = parent;
    if (drawn.inertial) {
      if (drawn.inertial->mass < 0) {
        refuse(fmt::format("link '{}'", drawn.name), "a mass of at least 0 kg",
               fmt::format("{}", drawn.inertial->mass));
      }
      link.mass = drawn.inertial->mass;
      link.centreOfMass = vectorOf(drawn.inertial->origin.position);
    }
    for (Capsule& capsule : makeCapsules(drawn, index)) {
      robot_.collisionCapsules.push_back(capsule);
    }
    if (drawn.parent_joint) {
      place(*drawn.parent_joint, link);
      if (drawn.parent_joint->type != urdf::Joint::FIXED) {
        link.joint = robot_.joints.size();
        addJoint(*drawn.parent_joint, index);
      }
    }
    for (const urdf::LinkSharedPtr& child : drawn.child_links) {
      addLink(*child, index);
    }
  }

  static void place(const urdf::Joint& drawn, Link& link) {
    const urdf::Pose& pose = drawn.parent_to_joint_origin_transform;
    link.constant = vectorOf(pose.position);
    const Eigen::Quaterniond turn{pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z};
    if (turn.vec().norm() > 0) {
      link.rotation = turn.normalized().toRotationMatrix();
    }
  }

  void addJoint(const urdf::Joint& drawn, std::size_t link) {
    const std::string place = fmt::format("joint '{}'", drawn.name);
    Joint& joint = robot_.joints.emplace_back();
    joint.name = drawn.name;
    joint.link = link;
    joint.axis = vectorOf(drawn.axis);
    if (joint.axis.norm() == 0) {
      refuse(place, "an axis with a direction", "0 0 0");
    }
    joint.axis.normalize();
    joint.isPrismatic = drawn.type == urdf::Joint::PRISMATIC;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    joint.limits = {-infinity, infinity};
    if (drawn.type != urdf::Joint::CONTINUOUS) {
      joint.limits = {drawn.limits->lower, drawn.limits->upper};
      if (joint.limits.lower > joint.limits.upper) {
        refuse(place, "a lower limit not above the upper one",
               fmt::format("{} and {}", joint.limits.lower, joint.limits.upper));
      }
    }
    joint.maxSpeed = drawn.limits ? drawn.limits->velocity : 0;
    joint.motor = robot_.joints.size() - 1;
  }

  /// Follows a chain of joints that mimic others to its first.
  void resolveMimic(Joint& joint) const {
    const urdf::Joint* drawn = model_.joints_.at(joint.name).get();
    for (std::size_t steps = 0; drawn->mimic; ++steps) {
      const std::string place = fmt::format("joint '{}'", drawn->name);
      const auto motor = robot_.jointIndex(drawn->mimic->joint_name);
      if (!motor) {
        refuse(place, "to mimic a joint that moves", fmt::format("'{}'", drawn->mimic->joint_name));
      }
      if (steps == robot_.joints.size()) {
        refuse(place, "to mimic a joint that does not depend on it", "joints that mimic each other in a circle");
      }
      joint.motor = *motor;
      joint.shift += joint.ratio * drawn->mimic->offset;
      joint.ratio *= drawn->mimic->multiplier;
      drawn = model_.joints_.at(drawn->mimic->joint_name).get();
    }
  }

  const urdf::ModelInterface& model_;
  std::string name_;
  Robot robot_;
};

} // namespace

Robot loadUrdf(const std::filesystem::path& file) {
  return parseUrdf(readUrdf(file), file.string());
}

std::string readUrdf(const std::filesystem::path& file) {
  return readFile(file, largestUrdf);
}

Robot parseUrdf(const std::string& text, const std::string& name) {
  checkUrdf(text, name);
  const urdf::ModelInterfaceSharedPtr model = parseModel(text, name);
  return UrdfReader{*model, name}.read();
}

} // namespace naocal

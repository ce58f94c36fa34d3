#pragma once

#include "robot/ModelState.hpp"
#include "robot/Robot.hpp"
#include "robot/RobotSample.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace naocal {

/// An unknown of an effect.
struct Unknown {
  std::string name; // as in result files: "o"
  std::string unit; // SI: "rad", "m", "1", "px"
  double sigma =
      0; // plausible size: prior standard deviation, solver scale, finite-difference step, reference of `learned`
};

/// Kind of place where an effect acts. A motor drives one joint, or both hip yaw-pitch joints. (Stances, markers,
/// frames and places are places of unknown placements only.)
enum class PlaceKind { motor, joint, camera, board, sole, length, all, stance, tracker, marker, frame, place };

/// Index of the place of a shared board effect: one set of unknowns for all boards.
constexpr std::size_t allPlaces = std::numeric_limits<std::size_t>::max();

/// A driver at a joint other than the effect's own.
struct RemoteDriver {
  Driver driver;
  std::size_t joint;
};

/// Another effect that an effect turns into when one of its unknowns has this value.
struct Limit {
  std::string effect, unknown;
  double value = 0;
};

/// A physical cause of a difference between nominal model and picture.
///
/// `correct` modifies the model state at an instant. Called once per joint of the motor for PlaceKind::motor, once per
/// board for a shared board effect, and otherwise only for pictures of that camera, board or stance, or on that sole.
struct Effect {
  std::string name;        // "jointOffset"
  std::string alias = "";  // alternative accepted name
  std::string description; // one plain sentence for users
  std::string formula;     // for users: "q_true = q_measured - o"
  PlaceKind placeKind = PlaceKind::motor;
  std::vector<Unknown> unknowns;
  std::vector<Driver> drivers = {};             // drivers at the corrected joint
  std::vector<RemoteDriver> remoteDrivers = {}; // drivers at other joints
  std::vector<Limit> limits = {};               // other effects at the ends of the plausible range of its unknowns
  bool linear = true;                           // correction is linear in the unknowns
  bool kink = false;                            // correction is not smooth in its drivers
  bool inBaseModel = false;                     // part of every model unless excluded
  bool shared = false;                          // board effect that may be common to all boards
  bool needsUrdf = false;                       // for robots that a URDF describes
  std::optional<std::size_t> onlyAtMotor = std::nullopt; // user-defined effect at one joint: its motor
  std::string definition = "";                           // user-defined effect: its JSON
  std::function<void(ModelState&, const RobotSample&, std::size_t at, std::span<const double> values)> correct;
};

/// Whether one of the effect's drivers, at its joint or another, meets a condition.
template <class Condition> bool anyDriver(const Effect& effect, const Condition& meets) {
  return std::any_of(effect.drivers.begin(), effect.drivers.end(), meets) ||
         std::any_of(effect.remoteDrivers.begin(), effect.remoteDrivers.end(),
                     [&](const RemoteDriver& other) { return meets(other.driver); });
}

/// Whether time or temperature drives the effect.
inline bool isTransient(const Effect& effect) {
  return anyDriver(effect, [](Driver driver) { return isTransient(driver); });
}

} // namespace naocal

#pragma once

#include "robot/ModelState.hpp"
#include "robot/Robot.hpp"
#include "robot/RobotSample.hpp"

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace naocal {

/// A number to be estimated.
struct Unknown {
  std::string name; // as in result files: "o"
  std::string unit; // SI: "rad", "m", "1", "px"
  double sigma =
      0; // how far from zero it plausibly lies: prior, solver's scale, step of differences, yardstick of learning
};

/// What an effect can sit at. A motor drives one joint, or both hip yaw-pitch joints. (Stances are places of unknown
/// placements only.)
enum class EffectSite { motor, joint, camera, board, sole, length, all, stance };

/// As the place of a board's effect: one set of unknowns for all boards.
constexpr std::size_t allSites = std::numeric_limits<std::size_t>::max();

/// A driver at a joint other than the effect's own.
struct RemoteDriver {
  Driver driver;
  std::size_t joint;
};

/// Another effect, which an effect becomes where one of its unknowns has this value.
struct Limit {
  std::string effect, unknown;
  double value = 0;
};

/// A physical cause of a difference between drawing and picture.
///
/// `correct` changes what is believed at an instant. It is called once per joint that the motor drives for
/// EffectSite::motor, once per board for a board's effect that sits everywhere, and on pictures of that camera, board
/// or stance, or on that sole, only for the others.
struct Effect {
  std::string name;       // "jointOffset"
  std::string alias = ""; // another name that is accepted for it
  std::string what;       // one plain sentence for people
  std::string formula;    // for people: "q_true = q_measured - o"
  EffectSite place = EffectSite::motor;
  std::vector<Unknown> unknowns;
  std::vector<Driver> needs = {};           // at the joint that is corrected
  std::vector<RemoteDriver> elsewhere = {}; // and at others
  std::vector<Limit> limits = {};           // at the ends of its unknowns' plausible range, if it has other names there
  bool linear = true;                       // the correction is linear in the unknowns
  bool kink = false;                        // not smooth in what drives it
  bool base = false;                        // in every model that is not asked to leave it out
  bool shared = false;                      // a board's effect that may be one for all boards
  std::optional<std::size_t> only = std::nullopt; // a user's effect at one joint: its motor
  std::string definition = "";                    // a user's effect: its JSON
  std::function<void(ModelState&, const RobotSample&, std::size_t at, std::span<const double> values)> correct;
};

} // namespace naocal

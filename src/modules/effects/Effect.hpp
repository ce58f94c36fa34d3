#pragma once

#include "captures/Capture.hpp"
#include "model/Belief.hpp"
#include "model/Robot.hpp"

#include <Eigen/Core>
#include <functional>
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

/// What drives effects at one instant, per joint of the robot; NaN where it was not recorded.
struct Instant {
  Seconds time{0};
  SupportFoot supportFoot = SupportFoot::none;
  Eigen::VectorXd q;           // measured - o [rad]
  Eigen::VectorXd velocity;    // [rad/s]
  Eigen::VectorXd approach;    // -1, 0, +1
  Eigen::VectorXd temperature; // [degC]
};

/// What an effect can sit at. (Stances are places of unknown placements only.)
enum class Place { motor, camera, board, stance };

/// A physical cause of a difference between drawing and picture.
///
/// `correct` changes what is believed at an instant. It is called once per joint that the motor drives for
/// Place::motor, and on pictures of that camera, board or stance only for the others.
struct Effect {
  std::string name;    // "jointOffset"
  std::string formula; // for people: "q_true = q_measured - o"
  Place place = Place::motor;
  std::vector<Unknown> unknowns;
  bool linear = true; // the correction is linear in the unknowns and depends on no other unknown
  std::function<void(Belief&, const Instant&, std::size_t at, std::span<const double> values)> correct;
};

} // namespace naocal

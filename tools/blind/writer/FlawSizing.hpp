#pragma once

#include "writer/Flaws.hpp"
#include "writer/Noncentrality.hpp"
#include "writer/RandomStream.hpp"

#include <optional>

namespace blind {

/// A flaw that was put into a robot.
struct Hidden {
  const Family* family = nullptr;
  std::string place;
  std::vector<double> values;
  double noncentrality = 0;
  double kept = 0; // of the evidence of someone who knows the rest of the robot
};

/// Gives a robot flaws of the size that makes them so visible on one session.
class Hiding {
public:
  Hiding(const Robot& robot, const Session& session, const Noncentrality& noncentrality);

  /// `shape` times the size at which the pictures' change has this noncentrality (found by iterating its square law);
  /// absent when that takes more than `most` shapes.
  std::optional<Hidden> sized(const Family& family, const std::string& place, std::vector<double> shape, double wanted,
                              double most) const;
  Hidden given(const Family& family, const std::string& place, std::vector<double> values) const;
  /// The largest canonical correlation of what two kinds of flaw do to the pictures, all unknowns free.
  double correlation(const Hidden& first, const Hidden& second) const;

private:
  Eigen::VectorXd change(const Family& family, const std::string& place, std::span<const double> values) const;
  Eigen::MatrixXd signatures(const Hidden& hidden) const;

  const Robot& robot_;
  const Session& session_;
  const Noncentrality& noncentrality_;
  Eigen::VectorXd without_;
};

/// The physical sizes in a random direction: as long as one of them.
std::vector<double> randomShape(const Family& family, Chance& chance);

/// The same of the sizes that are plausible.
std::vector<double> plausibleShape(const Family& family, Chance& chance);

void apply(const Hidden& hidden, Robot& robot);

} // namespace blind

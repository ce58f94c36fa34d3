#pragma once

#include "writer/Flaws.hpp"
#include "writer/Noncentrality.hpp"
#include "writer/RandomStream.hpp"

#include <optional>

namespace blind {

/// A flaw that was put into a robot.
struct HiddenFlaw {
  const FlawFamily* family = nullptr;
  std::string place;
  std::vector<double> values;
  double noncentrality = 0;
  double kept = 0; // of the evidence of someone who knows the rest of the robot
};

/// Gives a robot flaws of the size that makes them so visible on one session.
class FlawSizing {
public:
  FlawSizing(const Robot& robot, const Session& session, const Noncentrality& noncentrality);

  /// `shape` times the size at which the pictures' change has this noncentrality (found by iterating its square law);
  /// absent when that takes more than `most` shapes.
  std::optional<HiddenFlaw> scaleTo(const FlawFamily& family, const std::string& place, std::vector<double> shape,
                                    double wanted, double most) const;
  HiddenFlaw makeFlaw(const FlawFamily& family, const std::string& place, std::vector<double> values) const;
  /// The largest canonical correlation of what two kinds of flaw do to the pictures, all unknowns free.
  double correlation(const HiddenFlaw& first, const HiddenFlaw& second) const;

private:
  Eigen::VectorXd change(const FlawFamily& family, const std::string& place, std::span<const double> values) const;
  Eigen::MatrixXd signatures(const HiddenFlaw& hidden) const;

  const Robot& robot_;
  const Session& session_;
  const Noncentrality& noncentrality_;
  Eigen::VectorXd without_;
};

/// The physical sizes in a random direction: as long as one of them.
std::vector<double> randomShape(const FlawFamily& family, RandomStream& chance);

/// The same of the sizes that are plausible.
std::vector<double> plausibleShape(const FlawFamily& family, RandomStream& chance);

void applyFlaw(const HiddenFlaw& hidden, Robot& robot);

} // namespace blind

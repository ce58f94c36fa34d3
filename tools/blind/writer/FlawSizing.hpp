#pragma once

#include "world/Flaws.hpp"
#include "world/RandomStream.hpp"
#include "writer/Noncentrality.hpp"
#include "writer/NoncentralityScaling.hpp"

#include <optional>

namespace blind {

/// A flaw injected into a robot.
struct HiddenFlaw {
  const FlawFamily* family = nullptr;
  std::string place;
  std::vector<double> values;
  double noncentrality = 0;
  double kept = 0; // fraction of the evidence left without knowing the rest of the robot
};

/// Scales flaws to a given visibility in one session.
class FlawSizing {
public:
  FlawSizing(const Robot& robot, const Session& session, const Noncentrality& noncentrality);

  /// Scales `shape` until the change of the images has noncentrality `wanted` (iterating its square law); absent if the
  /// factor exceeds `most`.
  std::optional<HiddenFlaw> scaleTo(const FlawFamily& family, const std::string& place,
                                    const std::vector<double>& shape, double wanted, double most) const;
  /// The flaw at these values, with its noncentrality in the session.
  HiddenFlaw makeFlaw(const FlawFamily& family, const std::string& place, std::vector<double> values) const;
  /// Largest canonical correlation of two flaws' changes of the images, all unknowns free.
  double correlation(const HiddenFlaw& first, const HiddenFlaw& second) const;

private:
  MeasuredChange changeBy(const FlawFamily& family, const std::string& place) const; // keeps references
  Eigen::VectorXd change(const FlawFamily& family, const std::string& place, std::span<const double> values) const;
  Eigen::MatrixXd signatures(const HiddenFlaw& hidden) const;

  const Robot& robot_;
  const Session& session_;
  const Noncentrality& noncentrality_;
  Eigen::VectorXd without_;
};

/// Random direction in the space of unknowns, scaled to their physical sizes.
std::vector<double> randomShape(const FlawFamily& family, RandomStream& chance);

/// The same, scaled to their plausible sizes.
std::vector<double> plausibleShape(const FlawFamily& family, RandomStream& chance);

/// Adds the flaw to the robot.
void applyFlaw(const HiddenFlaw& hidden, Robot& robot);

} // namespace blind

#pragma once

#include "estimation/DriverState.hpp"
#include "estimation/Model.hpp"

#include <vector>

namespace naocal {

/// d(quantity)/d(unknown).
struct StateDerivative {
  std::size_t quantity, unknown;
  double value;
};

/// How what is believed at one picture's instant, and moves something that the picture shows, depends on the unknowns:
///
///   belief = drawn + sum of fixed slopes * unknowns + corrections of the terms that vary
///
/// A term varies if it is not linear in its unknowns, or looks at angles, torques or the centre of mass: these follow
/// the joint offsets. Which slopes there are never changes, only the values of those that vary.
class EffectJacobian {
public:
  EffectJacobian() = default;
  EffectJacobian(const Measurements& measurements, const Model& model, const ImageObservation& picture);

  /// Fixed ones first; of the others not the values.
  const std::vector<StateDerivative>& entries() const { return slopes_; }
  std::size_t fixedCount() const { return fixedCount_; }
  bool hasVarying() const { return !varying_.empty(); }

  /// Adds the fixed slopes' corrections to `belief`.
  void applyFixed(const Eigen::VectorXd& unknowns, ModelState& belief) const;

  /// What evaluations work on.
  struct Scratch {
    ModelState belief{StateLayout{0, 0, 0}};
    std::vector<double> values;
  };
  /// Adds the corrections of the terms that vary to `belief`, and writes the values of their slopes, in the list's
  /// order from `fixedCount()` on, behind `values`. Derivatives by what drives a term are central differences of that
  /// one term, joined by the chain rule with `driven`, which is left as it was.
  void applyVarying(const Model& model, const ImageObservation& picture, const Eigen::VectorXd& unknowns,
                    DriverState& driven, Scratch& scratch, ModelState& belief, double* values) const;

private:
  struct Varying {
    std::size_t term, at;                // the term, and one of the places that it corrects
    std::vector<std::size_t> quantities; // that it corrects
    std::vector<RemoteDriver> drivers;   // that it looks at and that follow offsets (com: x at 0, y at 1)
    std::vector<std::size_t> offsets;    // that these follow, among the model's
  };
  Varying correction(const Model& model, const ImageObservation& picture, std::size_t term, std::size_t place,
                     ModelState& belief, std::optional<RobotSample>& inGeneral);
  void listSlopes(const Robot& robot, const Model& model, Varying varying);

  std::vector<StateDerivative> slopes_;
  std::size_t fixedCount_ = 0;
  std::vector<Varying> varying_;
};

/// All slopes at the given unknowns.
std::vector<StateDerivative> evaluateJacobian(const Measurements& measurements, const Model& model,
                                              const ImageObservation& picture, const Eigen::VectorXd& unknowns);

} // namespace naocal

#pragma once

#include "estimation/DriverState.hpp"
#include "estimation/Model.hpp"

#include <vector>

namespace naocal {

/// d(quantity)/d(unknown): one entry of a sparse Jacobian. `quantity`: an index of `StateLayout`.
struct StateDerivative {
  std::size_t quantity, unknown;
  double value;
};

/// Derivatives of the model state at one picture's instant with respect to the unknowns, for quantities visible in the
/// picture:
///
///   state = nominal state + sum of fixed slopes * unknowns + corrections of the terms that vary
///
/// A term varies if it is nonlinear in its unknowns or uses angles, torques or the centre of mass, which depend on the
/// joint offsets. The sparsity pattern is constant; only the values of varying terms change.
class EffectJacobian {
public:
  EffectJacobian() = default;
  EffectJacobian(const Measurements& measurements, const Model& model, const ImageObservation& picture);

  /// All entries, fixed ones first; the values of the varying ones are unset.
  const std::vector<StateDerivative>& entries() const { return slopes_; }
  std::size_t fixedCount() const { return fixedCount_; }
  bool hasVarying() const { return !varying_.empty(); }

  /// Adds the corrections of the fixed slopes to `modelState`.
  void applyFixed(const Eigen::VectorXd& unknowns, ModelState& modelState) const;

  /// Drivers at the instant, and buffers reused across evaluations.
  struct Scratch {
    DriverState driven;
    ModelState modelState{StateLayout{0, 0, 0}};
    std::vector<double> values;
  };
  /// Adds the corrections of the varying terms to `modelState` and writes the values of their slopes to `values`, in
  /// the order of `entries()` from `fixedCount()` on. Derivatives with respect to a term's drivers are central
  /// differences of that term, combined with `scratch.driven` by the chain rule; that is unchanged on return.
  void applyVarying(const Model& model, const ImageObservation& picture, const Eigen::VectorXd& unknowns,
                    Scratch& scratch, ModelState& modelState, double* values) const;

private:
  struct Varying {
    std::size_t term;
    CorrectedPlace place;                // one of the term's
    std::vector<std::size_t> quantities; // quantities it corrects
    std::vector<RemoteDriver> drivers;   // its drivers that depend on offsets (com: x at 0, y at 1)
    std::vector<std::size_t> offsets;    // those offsets, as indices into the model's
  };
  Varying correction(const Model& model, const ImageObservation& picture, std::size_t term, const CorrectedPlace& place,
                     ModelState& modelState, std::optional<RobotSample>& inGeneral);
  void listSlopes(const Robot& robot, const Model& model, Varying varying);

  std::vector<StateDerivative> slopes_;
  std::size_t fixedCount_ = 0;
  std::vector<Varying> varying_;
};

/// All derivatives at the given unknowns.
std::vector<StateDerivative> evaluateJacobian(const Measurements& measurements, const Model& model,
                                              const ImageObservation& picture, const Eigen::VectorXd& unknowns);

} // namespace naocal

#include "estimation/EffectJacobian.hpp"

#include "math/LinearAlgebra.hpp"
#include "measurements/Measurements.hpp"

#include <algorithm>
#include <cstring>
#include <functional>

namespace naocal {

namespace {

/// Drivers of a correction that depend on the offsets.
std::vector<RemoteDriver> drivers(const Effect& effect, std::size_t place) {
  std::vector<RemoteDriver> looks = effect.remoteDrivers, result;
  for (const Driver driver : effect.drivers) {
    looks.push_back({driver, place});
  }
  for (const RemoteDriver& look : looks) {
    if (look.driver == Driver::com) {
      result.push_back({look.driver, 0});
      result.push_back({look.driver, 1});
    } else if (followsFromAngles(look.driver)) {
      result.push_back(look);
    }
  }
  return result;
}

/// Generic driver values, at which no correction vanishes by coincidence.
RobotSample makeGenericSample(const RobotSample& recorded) {
  RobotSample result = recorded;
  result.q = Eigen::VectorXd::LinSpaced(recorded.q.size(), 0.2, 0.4);
  result.torque = Eigen::VectorXd::LinSpaced(recorded.q.size(), 0.01, 0.02);
  result.torqueGrowth = Eigen::VectorXd::LinSpaced(recorded.q.size(), 0.1, 0.2);
  result.lateralTorque = Eigen::Matrix2Xd::Constant(2, recorded.q.size(), 0.015);
  result.com = {0.02, 0.03};
  return result;
}

/// Index of the first difference from `first` on; the size if there is none.
Eigen::Index firstDifference(const Eigen::VectorXd& one, const Eigen::VectorXd& other, Eigen::Index first) {
  constexpr Eigen::Index atOnce = 16;
  while (first + atOnce <= one.size() &&
         std::memcmp(one.data() + first, other.data() + first, atOnce * sizeof(double)) == 0) {
    first += atOnce;
  }
  return std::mismatch(one.data() + first, one.data() + one.size(), other.data() + first).first - one.data();
}

/// Whether a quantity affects something visible in the picture.
class Visible {
public:
  Visible(const Measurements& measurements, const ImageObservation& picture)
      : quantities_{measurements.quantities}, picture_{picture}, joints_(measurements.robot.joints.size(), 0) {
    for (const std::size_t joint : observedJoints(measurements.robot, picture)) {
      joints_[joint] = 1;
    }
  }
  bool operator()(std::size_t quantity) const {
    if (quantity < quantities_.axis(0)) {
      return joints_[quantity] != 0; // angle quantities have their joint's index
    }
    if (quantity < quantities_.length(0)) {
      return joints_[(quantity - quantities_.axis(0)) / 3] != 0;
    }
    if (quantity < quantities_.board(0)) {
      return true;
    }
    if (const auto board = quantities_.boardOf(quantity)) {
      return std::any_of(picture_.observations.begin(), picture_.observations.end(),
                         [&](const BoardObservation& observation) { return observation.view.board() == *board; });
    }
    if (const auto joint = quantities_.jointOfStep(quantity)) {
      return joints_[*joint] != 0;
    }
    return std::any_of(picture_.witnesses.begin(), picture_.witnesses.end(),
                       [&](const WitnessObservation& observation) {
                         const std::vector<std::size_t>& own = observation.witness->own();
                         return std::find(own.begin(), own.end(), quantity) != own.end();
                       });
  }

private:
  const StateLayout& quantities_;
  const ImageObservation& picture_;
  std::vector<char> joints_;
};

double& driverIn(RobotSample& instant, const RemoteDriver& which) {
  switch (which.driver) {
  case Driver::torque:
    return instant.torque[eigenIndex(which.joint)];
  case Driver::torqueGrowth:
    return instant.torqueGrowth[eigenIndex(which.joint)];
  case Driver::com:
    return instant.com[eigenIndex(which.joint)];
  case Driver::lateral1:
    return instant.lateralTorque(0, eigenIndex(which.joint));
  case Driver::lateral2:
    return instant.lateralTorque(1, eigenIndex(which.joint));
  default:
    return instant.q[eigenIndex(which.joint)];
  }
}

double derivativeByOffset(const DriverState& driven, const RemoteDriver& which, std::size_t offset) {
  switch (which.driver) {
  case Driver::torque:
    return driven.torqueByOffset(eigenIndex(which.joint), eigenIndex(offset));
  case Driver::torqueGrowth:
    return driven.growthByOffset(eigenIndex(which.joint), eigenIndex(offset));
  case Driver::lateral1:
    return driven.lateralByOffset[0](eigenIndex(which.joint), eigenIndex(offset));
  case Driver::lateral2:
    return driven.lateralByOffset[1](eigenIndex(which.joint), eigenIndex(offset));
  case Driver::com:
    return driven.comByOffset(eigenIndex(which.joint), eigenIndex(offset));
  default:
    return driven.angleByOffset(eigenIndex(which.joint), eigenIndex(offset));
  }
}

/// Steps of the central differences; small, because of the third derivative of tanh(tau / 0.03 Nm).
double stepOf(Driver driver) {
  return driver == Driver::torque ? 3e-6 : driver == Driver::com ? 1e-5 : 1e-4; // [Nm], [m], [rad]
}

/// Evaluates one correction: the change of each of its quantities at given values and drivers.
class Correction {
public:
  Correction(const Effect& effect, const CorrectedPlace& place, const std::vector<std::size_t>& quantities,
             const ModelState& drawn, ModelState& scratch)
      : effect_{effect}, place_{place}, quantities_{quantities}, drawn_{drawn}, scratch_{scratch} {}

  /// Calls `take(i, change)` for the i-th quantity.
  template <typename Take>
  void operator()(const RobotSample& instant, std::span<const double> values, Take take) const {
    place_.correct(scratch_, effect_, instant, values);
    for (std::size_t i = 0; i < quantities_.size(); ++i) {
      double& value = scratch_.values[eigenIndex(quantities_[i])];
      const double before = drawn_.values[eigenIndex(quantities_[i])];
      take(i, value - before);
      value = before;
    }
  }

private:
  const Effect& effect_;
  const CorrectedPlace& place_;
  const std::vector<std::size_t>& quantities_;
  const ModelState& drawn_;
  ModelState& scratch_;
};

} // namespace

EffectJacobian::EffectJacobian(const Measurements& measurements, const Model& model, const ImageObservation& picture) {
  const Visible visible{measurements, picture};
  std::optional<RobotSample> inGeneral; // created on demand
  ModelState modelState = picture.nominal;
  std::vector<Varying> varying;
  for (std::size_t term = 0; term < model.terms().size(); ++term) {
    for (const CorrectedPlace& place : placesOn(model.terms()[term], measurements, picture)) {
      Varying found = correction(model, picture, term, place, modelState, inGeneral);
      if (std::any_of(found.quantities.begin(), found.quantities.end(), std::cref(visible))) {
        varying.push_back(std::move(found));
      }
    }
  }
  std::erase_if(slopes_, [&](const StateDerivative& slope) { return !visible(slope.quantity); });
  fixedCount_ = slopes_.size();
  for (Varying& each : varying) {
    listSlopes(measurements.robot, model, std::move(each));
  }
}

/// Lists the slopes of a fixed correction; for a varying one, returns the quantities it corrects.
EffectJacobian::Varying EffectJacobian::correction(const Model& model, const ImageObservation& picture,
                                                   std::size_t term, const CorrectedPlace& place,
                                                   ModelState& modelState, std::optional<RobotSample>& inGeneral) {
  const Effect& effect = model.terms()[term].effect;
  Varying result{term, place, {}, drivers(effect, place.source), {}};
  const bool fixed = effect.linear && result.drivers.empty();
  if (!effect.definition.empty()) { // user-defined: corrects its joint, even if zero within a dead band
    result.quantities.push_back(picture.nominal.layout().angle(place.place));
    return result;
  }
  if (!fixed && !inGeneral) {
    inGeneral = makeGenericSample(picture.instant);
  }
  const RobotSample& instant = fixed ? picture.instant : *inGeneral;
  const Eigen::VectorXd& drawn = picture.nominal.values;
  const std::size_t unknowns = effect.unknowns.size();
  std::vector<double> values(unknowns, 0);
  // one after the other; then all at once, where together they may correct a quantity that none does alone
  for (std::size_t k = 0; k < unknowns + (fixed ? 0 : 1); ++k) {
    const double step = k < unknowns ? effect.unknowns[k].sigma : 1;
    for (std::size_t i = 0; i < unknowns; ++i) {
      values[i] = i == k || k == unknowns ? effect.unknowns[i].sigma : 0;
    }
    place.correct(modelState, effect, instant, values);
    for (Eigen::Index i = firstDifference(modelState.values, drawn, 0); i < drawn.size();
         i = firstDifference(modelState.values, drawn, i + 1)) {
      const auto quantity = static_cast<std::size_t>(i);
      const double slope = (modelState.values[i] - drawn[i]) / step;
      modelState.values[i] = drawn[i];
      if (fixed) {
        slopes_.push_back({quantity, model.terms()[term].first + k, slope});
      } else if (std::find(result.quantities.begin(), result.quantities.end(), quantity) == result.quantities.end()) {
        result.quantities.push_back(quantity);
      }
    }
  }
  return result;
}

void EffectJacobian::listSlopes(const Robot& robot, const Model& model, Varying varying) {
  const Term& term = model.terms()[varying.term];
  for (std::size_t i = 0; i < model.offsets().size(); ++i) {
    const std::size_t motor = model.terms()[model.offsets()[i]].placeIndex;
    if (std::any_of(varying.drivers.begin(), varying.drivers.end(), [&](const RemoteDriver& driver) {
          return driver.driver != Driver::angle || robot.joints[driver.joint].motor == motor;
        })) {
      varying.offsets.push_back(i);
    }
  }
  for (const std::size_t quantity : varying.quantities) {
    for (std::size_t k = 0; k < term.effect.unknowns.size(); ++k) {
      slopes_.push_back({quantity, term.first + k, 0});
    }
    for (const std::size_t offset : varying.offsets) {
      slopes_.push_back({quantity, model.terms()[model.offsets()[offset]].first, 0});
    }
  }
  varying_.push_back(std::move(varying));
}

void EffectJacobian::applyFixed(const Eigen::VectorXd& unknowns, ModelState& modelState) const {
  for (std::size_t i = 0; i < fixedCount_; ++i) {
    modelState.values[static_cast<Eigen::Index>(slopes_[i].quantity)] +=
        slopes_[i].value * unknowns[static_cast<Eigen::Index>(slopes_[i].unknown)];
  }
}

std::vector<StateDerivative> evaluateJacobian(const Measurements& measurements, const Model& model,
                                              const ImageObservation& picture, const Eigen::VectorXd& unknowns) {
  const EffectJacobian all{measurements, model, picture};
  std::vector<StateDerivative> result = all.entries();
  if (all.hasVarying()) {
    EffectJacobian::Scratch scratch;
    scratch.driven = computeDrivers(measurements, model, picture, unknowns);
    ModelState modelState = picture.nominal;
    std::vector<double> values(result.size() - all.fixedCount());
    all.applyVarying(model, picture, unknowns, scratch, modelState, values.data());
    for (std::size_t i = 0; i < values.size(); ++i) {
      result[all.fixedCount() + i].value = values[i];
    }
  }
  return result;
}

void EffectJacobian::applyVarying(const Model& model, const ImageObservation& picture, const Eigen::VectorXd& unknowns,
                                  Scratch& scratch, ModelState& modelState, double* values) const {
  DriverState& driven = scratch.driven;
  scratch.modelState = picture.nominal;
  for (const Varying& varying : varying_) {
    const Term& term = model.terms()[varying.term];
    const std::vector<Unknown>& own = term.effect.unknowns;
    const std::size_t width = own.size() + varying.offsets.size();
    std::fill_n(values, width * varying.quantities.size(), 0);
    const Correction correction{term.effect, varying.place, varying.quantities, picture.nominal, scratch.modelState};
    const std::span<const double> here = term.values(unknowns);
    correction(driven.instant, here,
               [&](std::size_t i, double change) { modelState.values[eigenIndex(varying.quantities[i])] += change; });
    scratch.values.assign(here.begin(), here.end());
    for (std::size_t k = 0; k < own.size(); ++k) {
      const double step = term.effect.linear ? own[k].sigma : 1e-4 * own[k].sigma;
      for (const double sign : {1.0, -1.0}) {
        scratch.values[k] = here[k] + sign * step;
        correction(driven.instant, scratch.values,
                   [&](std::size_t i, double change) { values[i * width + k] += sign * change / (2 * step); });
      }
      scratch.values[k] = here[k];
    }
    for (const RemoteDriver& which : varying.drivers) {
      double& driver = driverIn(driven.instant, which);
      const double centre = driver, step = stepOf(which.driver);
      for (const double sign : {1.0, -1.0}) {
        driver = centre + sign * step;
        correction(driven.instant, here, [&](std::size_t i, double change) {
          const double slope = sign * change / (2 * step);
          for (std::size_t j = 0; j < varying.offsets.size(); ++j) {
            values[i * width + own.size() + j] += slope * derivativeByOffset(driven, which, varying.offsets[j]);
          }
        });
      }
      driver = centre;
    }
    values += width * varying.quantities.size();
  }
}

} // namespace naocal

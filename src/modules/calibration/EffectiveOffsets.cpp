#include "calibration/EffectiveOffsets.hpp"

#include "effects/Catalogue.hpp"
#include "estimation/DriverState.hpp"
#include "estimation/EffectJacobian.hpp"
#include "math/LinearAlgebra.hpp"
#include "measurements/Measurements.hpp"

#include <cmath>
#include <map>

namespace naocal {

namespace {

/// Sum over pictures of nominal - predicted angle [rad], and its gradient with respect to the unknowns.
struct Sum {
  double value = 0;
  Eigen::VectorXd gradient;
  int count = 0;
};

} // namespace

std::vector<EffectiveOffset> effectiveOffsets(const FittedModel& fitted) {
  const Robot& robot = fitted.measurements.robot;
  std::map<std::size_t, Sum> sums; // by motor
  for (const ImageObservation& picture : fitted.measurements.pictures) {
    if (picture.observations.empty()) {
      continue;
    }
    const ModelState modelState = predictState(fitted.measurements, fitted.model, picture, fitted.fit.unknowns);
    const std::vector<StateDerivative> all =
        evaluateJacobian(fitted.measurements, fitted.model, picture, fitted.fit.unknowns);
    for (const std::size_t joint : observedJoints(robot, picture)) {
      Sum& sum =
          sums.try_emplace(robot.joints[joint].motor, Sum{0, Eigen::VectorXd::Zero(fitted.fit.unknowns.size()), 0})
              .first->second;
      sum.value += picture.nominal.angle(joint) - modelState.angle(joint);
      ++sum.count;
      for (const StateDerivative& slope : all) {
        sum.gradient[eigenIndex(slope.unknown)] -=
            slope.quantity == fitted.measurements.quantities.angle(joint) ? slope.value : 0;
      }
    }
  }
  std::vector<EffectiveOffset> offsets;
  for (const Term& term : fitted.model.terms()) {
    if (const auto found = sums.find(term.placeIndex);
        term.effect.name == effectName::jointOffset && found != sums.end()) {
      const Sum& sum = found->second;
      offsets.push_back({term.placeName, sum.value / sum.count,
                         std::sqrt(sum.gradient.dot(fitted.fit.covariance * sum.gradient)) / sum.count,
                         fitted.fit.estimates[term.first].learned});
    }
  }
  return offsets;
}

bool isLearned(const EffectiveOffset& offset) {
  constexpr double hardly = 0.5;
  return offset.learned >= hardly;
}

} // namespace naocal

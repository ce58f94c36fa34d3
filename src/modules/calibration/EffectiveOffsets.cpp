#include "calibration/EffectiveOffsets.hpp"

#include "effects/Catalogue.hpp"
#include "estimation/DriverState.hpp"
#include "estimation/EffectJacobian.hpp"
#include "inference/Thresholds.hpp"
#include "math/LinearAlgebra.hpp"
#include "measurements/Measurements.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace naocal {

namespace {

/// Sum over pictures of nominal - predicted angle [rad], and its gradient with respect to the unknowns.
struct Sum {
  double value = 0;
  Eigen::VectorXd gradient;
  int count = 0;
};

/// Mean over the pictures of each entry that was recorded, else NaN.
Eigen::VectorXd meanDriver(const Measurements& measurements, Eigen::VectorXd RobotSample::*driver) {
  const Eigen::Index joints = eigenIndex(measurements.robot.joints.size());
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(joints), count = sum;
  for (const ImageObservation& picture : measurements.pictures) {
    const Eigen::VectorXd& values = picture.instant.*driver;
    for (Eigen::Index joint = 0; joint < std::min(joints, values.size()); ++joint) {
      if (std::isfinite(values[joint])) {
        sum[joint] += values[joint];
        ++count[joint];
      }
    }
  }
  return (count.array() > 0).select(sum.cwiseQuotient(count), RobotSample::nothing);
}

/// A picture of the robot standing at a posture, for `predictState`: readings are the posture's angles plus the model's
/// offsets.
ImageObservation standingPicture(const Measurements& measurements, const Model& model, const Eigen::VectorXd& unknowns,
                                 const Eigen::VectorXd& posture) {
  ImageObservation picture = measurements.pictures.front();
  RobotSample& instant = picture.instant;
  const Eigen::Index joints = eigenIndex(measurements.robot.joints.size());
  instant.q = posture;
  for (const std::size_t index : model.offsets()) {
    const Term& offset = model.terms()[index];
    for (std::size_t joint = 0; joint < measurements.robot.joints.size(); ++joint) {
      instant.q[eigenIndex(joint)] +=
          measurements.robot.joints[joint].motor == offset.placeIndex ? unknowns[eigenIndex(offset.first)] : 0;
    }
  }
  picture.nominal.values.head(joints) = instant.q;
  instant.supportFoot = SupportFoot::both;
  instant.leftLoad = 0.5;
  instant.velocity = instant.approach = Eigen::VectorXd::Zero(joints);
  instant.temperature = meanDriver(measurements, &RobotSample::temperature);
  instant.current = meanDriver(measurements, &RobotSample::current);
  instant.imu.setZero();
  Seconds time{0};
  for (const ImageObservation& each : measurements.pictures) {
    time += each.instant.time / static_cast<double>(measurements.pictures.size());
  }
  instant.time = time;
  return picture;
}

} // namespace

std::vector<JointCompensation> jointCompensations(const Measurements& measurements, const Model& model,
                                                  const Eigen::VectorXd& unknowns, const Eigen::VectorXd& posture) {
  const ImageObservation stand = standingPicture(measurements, model, unknowns, posture);
  const ModelState atStand = predictState(measurements, model, stand, unknowns);
  std::vector<std::pair<const ImageObservation*, ModelState>> states;
  for (const ImageObservation& picture : measurements.pictures) {
    if (!picture.observations.empty()) {
      states.emplace_back(&picture, predictState(measurements, model, picture, unknowns));
    }
  }
  std::vector<JointCompensation> all;
  for (const std::size_t index : model.offsets()) {
    const Term& term = model.terms()[index];
    JointCompensation one{.joint = term.placeName, .offset = unknowns[eigenIndex(term.first)]};
    const auto deltaOf = [&](const ImageObservation& picture, const ModelState& state) {
      return state.angle(term.placeIndex) - picture.nominal.angle(term.placeIndex) + one.offset;
    };
    one.delta = deltaOf(stand, atStand);
    Eigen::VectorXd deltas(eigenIndex(states.size()));
    for (std::size_t i = 0; i < states.size(); ++i) {
      deltas[eigenIndex(i)] = deltaOf(*states[i].first, states[i].second);
    }
    one.mean = deltas.mean();
    one.spread = std::sqrt((deltas.array() - one.mean).square().mean());
    one.lowest = deltas.minCoeff();
    one.highest = deltas.maxCoeff();
    all.push_back(std::move(one));
  }
  return all;
}

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
  return offset.learned >= threshold::learned;
}

} // namespace naocal

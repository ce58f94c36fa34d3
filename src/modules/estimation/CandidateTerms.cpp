#include "estimation/CandidateTerms.hpp"

#include "effects/Catalogue.hpp"
#include "estimation/DriverState.hpp"
#include "estimation/EffectJacobian.hpp"
#include "estimation/PlacementTerms.hpp"
#include "measurements/Measurements.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>
#include <utility>

namespace naocal {

namespace {

using NamedPlaces = std::vector<std::pair<std::size_t, std::string>>;

/// Sites involved in pictures with corners.
struct Touched {
  std::set<std::size_t> motors, joints, cameras, boards, soles, lengths, trackers;
};

void touchLengths(const Robot& robot, const ObservationChain& view, std::set<std::size_t>& lengths) {
  for (std::size_t link : view.links()) {
    for (const Link::Stretch& stretch : robot.links[link].stretches) {
      lengths.insert(stretch.length);
    }
  }
}

Touched findTouched(const Measurements& measurements) {
  const Robot& robot = measurements.robot;
  Touched result;
  for (const ImageObservation& picture : measurements.pictures) {
    if (picture.measuresNothing()) {
      continue;
    }
    if (!picture.observations.empty()) {
      result.cameras.insert(picture.camera);
    }
    for (const std::size_t joint : observedJoints(robot, picture)) {
      result.joints.insert(joint);
      result.motors.insert(robot.joints[joint].motor);
    }
    for (const BoardObservation& observation : picture.observations) {
      const Target& target = measurements.targets[observation.view.board()];
      touchLengths(robot, observation.view, result.lengths);
      if (target.board.pattern) {
        result.boards.insert(observation.view.board());
      }
      for (std::size_t sole = 0; target.inWorld && sole < robot.soles.size(); ++sole) {
        if (isStanceSole(robot.soles[sole], picture.instant)) {
          result.soles.insert(sole);
        }
      }
    }
  }
  for (std::size_t tracker = 0; tracker < measurements.instruments.trackers.size(); ++tracker) {
    const std::string& name = measurements.instruments.trackers[tracker].name;
    if (std::any_of(measurements.levels.begin(), measurements.levels.end(),
                    [&](const ReadingLevel& level) { return level.name == name; })) {
      result.trackers.insert(tracker);
    }
  }
  return result;
}

/// Whether an effect makes sense at a joint: a joint that slides has no eccentric encoder.
bool isOffered(const Effect& effect, const Joint& joint) {
  return !joint.isPrismatic || effect.name != effectName::encoderEccentricity;
}

template <typename List> NamedPlaces namePlaces(const std::set<std::size_t>& numbers, const List& list) {
  NamedPlaces result;
  for (const std::size_t number : numbers) {
    result.emplace_back(number, list[number].name);
  }
  return result;
}

/// The next recorded joint from a joint towards the base.
std::optional<std::size_t> nextTowardsBase(const Measurements& measurements, std::size_t joint) {
  const Robot& robot = measurements.robot;
  for (auto link = robot.links[robot.joints[joint].link].parent; link; link = robot.links[*link].parent) {
    const auto next = robot.links[*link].joint;
    if (next && std::binary_search(measurements.recordedMotors.begin(), measurements.recordedMotors.end(),
                                   robot.joints[*next].motor)) {
      return next;
    }
  }
  return std::nullopt;
}

/// Sites where an effect can act in these captures, as (index, name): motors and joints between a camera and a target,
/// lengths on such a path, cameras with observations, observed boards with a printed pattern, soles that were stood on.
/// A shared board effect also has the place `allPlaces` ("all") with several boards.
NamedPlaces candidateSites(const Effect& effect, const Measurements& measurements, const Touched& touched) {
  const Robot& robot = measurements.robot;
  if (effect.needsUrdf && !measurements.quantities.scene().hasLinkSteps) {
    return {};
  }
  switch (effect.placeKind) {
  case PlaceKind::motor: {
    NamedPlaces result = namePlaces(touched.motors, robot.joints);
    std::erase_if(result, [&](const auto& place) {
      return (effect.onlyAtMotor && place.first != *effect.onlyAtMotor) ||
             !isOffered(effect, robot.joints[place.first]) ||
             (effect.name == effectName::motorCoupling && !nextTowardsBase(measurements, place.first));
    });
    return result;
  }
  case PlaceKind::joint:
    return namePlaces(touched.joints, robot.joints);
  case PlaceKind::camera: {
    NamedPlaces result = namePlaces(touched.cameras, robot.cameras);
    const bool movesMount = effect.name == effectName::cameraRotation || effect.name == effectName::cameraTranslation;
    std::erase_if(result, [&](const auto& place) { return movesMount && robot.cameras[place.first].inWorld; });
    return result;
  }
  case PlaceKind::board: {
    NamedPlaces result = namePlaces(touched.boards, measurements.targets);
    if (effect.shared && result.size() > 1) {
      result.emplace_back(allPlaces, "all");
    }
    return result;
  }
  case PlaceKind::sole:
    return namePlaces(touched.soles, robot.soles);
  case PlaceKind::length:
    return namePlaces(touched.lengths, robot.lengths);
  case PlaceKind::all:
    return {{0, "all"}};
  case PlaceKind::tracker:
    return namePlaces(touched.trackers, measurements.instruments.trackers);
  case PlaceKind::stance:
  case PlaceKind::marker:
  case PlaceKind::frame:
  case PlaceKind::place:
    break;
  }
  return {};
}

/// Name of a driver that an instant lacks at a joint; null if it is available.
const char* missingInput(const RobotSample& instant, Driver driver, std::size_t joint, const Robot& robot) {
  const auto at = static_cast<Eigen::Index>(joint);
  switch (driver) {
  case Driver::approach:
    return std::isnan(instant.approach[at]) ? "approach directions" : nullptr;
  case Driver::temperature:
    return std::isnan(instant.temperature[at]) ? "temperatures" : nullptr;
  case Driver::velocity:
    return std::isnan(instant.velocity[at]) ? "velocities" : nullptr;
  case Driver::current:
    return std::isnan(instant.current[at]) ? "currents" : nullptr;
  case Driver::imu:
    return std::isnan(instant.imu.x()) ? "torso angles (imu)" : nullptr;
  case Driver::torque:
  case Driver::torqueGrowth:
  case Driver::lateral1:
  case Driver::lateral2:
    return instant.supportFoot == SupportFoot::both && std::isnan(instant.leftLoad) && isOnLeg(robot, joint)
               ? "shares of the load on both feet (fsr)"
               : nullptr;
  case Driver::com:
    return instant.supportFoot == SupportFoot::none && !instant.supportLink ? "support feet" : nullptr;
  case Driver::angle:
  case Driver::time:
    break;
  }
  return nullptr;
}

/// Joints whose readings a term needs in a picture; none if the picture cannot show it.
std::vector<std::size_t> jointsToRead(const Term& term, const Measurements& measurements,
                                      const ImageObservation& picture) {
  const Effect& effect = term.effect;
  const std::vector<CorrectedPlace> places = placesOn(term, measurements, picture);
  const bool shares = effect.placeKind == PlaceKind::sole && picture.instant.supportFoot == SupportFoot::both;
  if (picture.measuresNothing() || places.empty() || shares) {
    return {};
  }
  std::vector<std::size_t> joints = observedJoints(measurements.robot, picture);
  if (effect.placeKind == PlaceKind::motor || effect.placeKind == PlaceKind::joint) {
    std::erase_if(joints, [&](std::size_t joint) {
      return std::none_of(places.begin(), places.end(), [&](const CorrectedPlace& one) { return one.place == joint; });
    });
  }
  return joints;
}

/// The first driver of an effect at these joints that a picture lacks, in words; null if it has all.
const char* missingInput(const Effect& effect, const std::vector<std::size_t>& joints, const ImageObservation& picture,
                         const Measurements& measurements) {
  const char* lacks = nullptr;
  const auto look = [&](Driver driver, std::size_t joint) {
    lacks = lacks ? lacks : missingInput(picture.instant, driver, joint, measurements.robot);
  };
  for (const std::size_t joint : joints) {
    for (const Driver driver : effect.drivers) {
      look(driver, joint);
    }
  }
  for (const RemoteDriver& other : effect.remoteDrivers) {
    look(other.driver, other.joint);
    const bool recorded = std::binary_search(measurements.recordedMotors.begin(), measurements.recordedMotors.end(),
                                             measurements.robot.joints[other.joint].motor);
    lacks = other.driver == Driver::angle && !recorded ? "angles of a joint that it looks at" : lacks;
  }
  return lacks;
}

} // namespace

bool looksAtWeight(const Term& term) {
  return anyDriver(term.effect, [](Driver driver) {
    return driver == Driver::torque || driver == Driver::com || driver == Driver::lateral1 ||
           driver == Driver::lateral2;
  });
}

std::optional<std::string> untestableReason(const Effect& effect, std::size_t at, const Measurements& measurements) {
  if (effect.drivers.empty() && effect.remoteDrivers.empty()) {
    return std::nullopt;
  }
  const Term term{effect, at, ""};
  const std::vector<Link>& links = measurements.robot.links;
  if (looksAtWeight(term) && std::none_of(links.begin(), links.end(), [](const Link& link) { return link.mass > 0; })) {
    return "the drawing has no masses";
  }
  std::size_t concerned = 0, without = 0;
  const char* what = nullptr;
  for (const ImageObservation& picture : measurements.pictures) {
    const std::vector<std::size_t> joints = jointsToRead(term, measurements, picture);
    if (!joints.empty()) {
      const char* const lacks = missingInput(effect, joints, picture, measurements);
      ++concerned;
      without += lacks != nullptr;
      what = lacks ? lacks : what;
    }
  }
  if (concerned == 0) {
    return effect.placeKind == PlaceKind::sole ? "no picture was taken on one foot" : "no picture shows it";
  }
  const bool whereRecorded = effect.name == "imuTilt"; // each reading is a separate measurement
  if (without == 0 || (whereRecorded && without < concerned)) {
    return std::nullopt;
  }
  return without == concerned ? fmt::format("no {} were recorded", what)
                              : fmt::format("{} of {} pictures have no {}", without, concerned, what);
}

namespace {

/// The largest torque that gravity exerts on each joint of a robot with a URDF, about its axis or sideways [Nm].
Eigen::VectorXd largestLoads(const Measurements& measurements) {
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(measurements.robot.joints.size()));
  if (!measurements.quantities.scene().hasLinkSteps) {
    return largest;
  }
  for (const PoseGroup& pose : measurements.poses) {
    const ImageObservation& picture = measurements.pictures[pose.readings.front().pictures.front()];
    const RobotSample sample = sampleAt(measurements, Model{}, picture, {});
    if (sample.torque.size() == largest.size()) {
      largest = largest.cwiseMax(sample.torque.cwiseAbs())
                    .cwiseMax(sample.lateralTorque.cwiseAbs().colwise().maxCoeff().transpose());
    }
  }
  return largest;
}

/// Adapts the prior of an effect to the robot: no joint yields by more than about 0.02 rad under the loads that it
/// bears, and a camera's mount is as uncertain as the set says.
void fitPrior(const Measurements& measurements, const Eigen::VectorXd& loads, Term& term) {
  constexpr double largestYield = 0.02; // [rad]
  for (Unknown& unknown : term.effect.unknowns) {
    if (unknown.unit == "rad/Nm" && loads[static_cast<Eigen::Index>(term.placeIndex)] > 0) {
      unknown.sigma = std::min(unknown.sigma, largestYield / loads[static_cast<Eigen::Index>(term.placeIndex)]);
    }
  }
  const bool isRotation = term.effect.name == effectName::cameraRotation,
             isTranslation = term.effect.name == effectName::cameraTranslation;
  if (!isRotation && !isTranslation) {
    return;
  }
  const auto& mountings = measurements.sets->front().mountings;
  const auto mounting = mountings.find(measurements.robot.cameras[term.placeIndex].name);
  if (mounting == mountings.end() || !mounting->second.sigma) {
    return;
  }
  std::vector<double> sigmas;
  for (const Unknown& unknown : term.effect.unknowns) {
    sigmas.push_back(unknown.sigma);
  }
  setGivenSigmas(*mounting->second.sigma,
                 isRotation ? std::vector<std::size_t>{3, 4, 5} : std::vector<std::size_t>{0, 1, 2}, sigmas);
  for (std::size_t i = 0; i < sigmas.size(); ++i) {
    term.effect.unknowns[i].sigma = sigmas[i];
  }
  term.effect.inBaseModel = true;
}

/// The units of an effect on the position of a joint that slides: lengths instead of angles, forces instead of torques.
void useLengths(Term& term) {
  for (Unknown& unknown : term.effect.unknowns) {
    for (const auto& [turning, sliding] : {std::pair{"rad", "m"}, std::pair{"Nm", "N"}}) {
      if (const std::size_t at = unknown.unit.find(turning); at != std::string::npos) {
        unknown.unit.replace(at, std::string_view{turning}.size(), sliding);
      }
    }
  }
}

} // namespace

std::vector<Term> candidateTerms(const Measurements& measurements, const std::vector<Effect>& effects) {
  const Touched all = findTouched(measurements);
  const Eigen::VectorXd loads = largestLoads(measurements);
  std::vector<Term> result;
  for (const Effect& effect : effects) {
    for (const auto& [at, place] : candidateSites(effect, measurements, all)) {
      result.push_back(
          {effect.name == effectName::motorCoupling ? motorCoupling(*nextTowardsBase(measurements, at)) : effect, at,
           place});
      fitPrior(measurements, loads, result.back());
      if (effect.placeKind == PlaceKind::motor && measurements.robot.joints[at].isPrismatic) {
        useLengths(result.back());
      }
    }
  }
  return result;
}

std::vector<Term> testableTerms(const Measurements& measurements, const Model& model,
                                const std::vector<Effect>& effects) {
  std::vector<Term> result = candidateTerms(measurements, effects);
  std::erase_if(result, [&](const Term& term) {
    return untestableReason(term.effect, term.placeIndex, measurements) ||
           std::any_of(model.terms().begin(), model.terms().end(),
                       [&](const Term& own) { return own.label() == term.label(); });
  });
  return result;
}

} // namespace naocal

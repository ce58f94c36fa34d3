#include "estimation/ModelBuilder.hpp"

#include "effects/Catalogue.hpp"
#include "estimation/DriverState.hpp"
#include "estimation/EffectJacobian.hpp"
#include "estimation/Model.hpp"
#include "io/InputError.hpp"
#include "measurements/Measurements.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <set>

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

/// Whether `text` matches `pattern`, where '*' stands for any run of characters.
bool matches(std::string_view pattern, std::string_view text) {
  if (pattern.empty()) {
    return text.empty();
  }
  if (pattern.front() == '*') {
    return matches(pattern.substr(1), text) || (!text.empty() && matches(pattern, text.substr(1)));
  }
  return !text.empty() && pattern.front() == text.front() && matches(pattern.substr(1), text.substr(1));
}

[[noreturn]] void refuse(const std::string& wanted, const std::vector<std::string>& known) {
  const std::string_view effect = std::string_view{wanted}.substr(0, wanted.find('@'));
  std::vector<std::string> places; // places of that effect
  std::copy_if(known.begin(), known.end(), std::back_inserter(places),
               [&](const std::string& label) { return std::string_view{label}.substr(0, label.find('@')) == effect; });
  if (places.empty()) {
    throw InputError{fmt::format("'{}' names no effect at a place of these captures; near it are {} ('naocal effects' "
                                 "lists all effects)",
                                 wanted, fmt::join(closestNames(wanted, known), ", "))};
  }
  if (wanted.find('@') == std::string::npos) {
    throw InputError{
        fmt::format("'{0}' names no place: write {0}@PLACE, such as {1}, or {0}@*", wanted, places.front())};
  }
  throw InputError{fmt::format("'{}' names no place of {} in these captures; near it are {}", wanted, effect,
                               fmt::join(closestNames(wanted, places), ", "))};
}

/// A pattern "E@P" with '*', and whether it has matched.
struct Pattern {
  std::string given;
  bool used = false;
  std::string undriven = ""; // reason, if all its matches lack their drivers

  /// A motor's effect matches under either of its joints; '*' does not match "all".
  bool names(const Term& term, const Robot& robot) const {
    const std::string motors = term.effect.placeKind == PlaceKind::motor ? labelFor(given, robot) : given;
    const bool onePlace = term.effect.placeKind == PlaceKind::board && term.placeIndex == allPlaces;
    return onePlace ? matches(motors.substr(0, motors.find('@')), term.effect.name) && motors.ends_with("@all")
                    : matches(motors, term.label());
  }
};

std::vector<Pattern> patterns(const std::vector<std::string>& given) {
  std::vector<Pattern> result;
  for (const std::string& pattern : given) {
    result.push_back({pattern});
  }
  return result;
}

/// Whether any pattern names the term.
bool anyNames(const std::vector<Pattern>& patterns, const Term& term, const Robot& robot) {
  return std::any_of(patterns.begin(), patterns.end(),
                     [&](const Pattern& pattern) { return pattern.names(term, robot); });
}

/// Marks matching patterns as used, or records why the term cannot be used.
void mark(std::vector<Pattern>& patterns, const Term& term, const Robot& robot,
          const std::optional<std::string>& undriven = std::nullopt) {
  for (Pattern& pattern : patterns) {
    if (pattern.names(term, robot)) {
      pattern.used |= !undriven;
      pattern.undriven =
          undriven ? term.label() + " cannot be estimated from these captures: " + *undriven : pattern.undriven;
    }
  }
}

/// Throws if a pattern names no term that can be estimated. `known`: labels of all candidates.
void refuseUnused(const std::vector<Pattern>& patterns, const std::vector<std::string>& known) {
  for (const Pattern& pattern : patterns) {
    if (!pattern.used && !pattern.undriven.empty()) {
      throw InputError{pattern.undriven};
    }
    if (!pattern.used) {
      refuse(pattern.given, known);
    }
  }
}

bool looksAtWeight(const Term& term) {
  const auto weighs = [](Driver driver) {
    return driver == Driver::torque || driver == Driver::com || driver == Driver::lateral1 ||
           driver == Driver::lateral2;
  };
  return std::any_of(term.effect.drivers.begin(), term.effect.drivers.end(), weighs) ||
         std::any_of(term.effect.remoteDrivers.begin(), term.effect.remoteDrivers.end(),
                     [&](const RemoteDriver& other) { return weighs(other.driver); });
}

/// Offsets of recorded joints outside all observation chains: they move only mass, but affect the torques of others.
std::vector<Term> weighingOffsets(const Measurements& measurements) {
  std::vector<Term> result;
  for (const std::size_t motor : measurements.recordedMotors) {
    if (!std::binary_search(measurements.joints.begin(), measurements.joints.end(), motor)) {
      result.push_back({jointOffset(), motor, measurements.robot.joints[motor].name, 0, false, false});
    }
  }
  return result;
}

/// Where the numbers of an unknown placement are in the state.
Eigen::Ref<Eigen::VectorXd> placementIn(ModelState& modelState, PlaceKind place, std::size_t at) {
  switch (place) {
  case PlaceKind::board:
    return modelState.boardPlacement(at);
  case PlaceKind::camera: // x, y, z, then rx, ry, rz
    return modelState.values.segment(static_cast<Eigen::Index>(modelState.layout().mountTranslation()), 6);
  case PlaceKind::tracker:
    return modelState.trackerPlacement(at);
  case PlaceKind::marker:
    return modelState.marker(at);
  case PlaceKind::frame:
    return modelState.framePlacement(at);
  case PlaceKind::place:
    return modelState.place(at);
  default:
    return modelState.worldFromSupport();
  }
}

/// Additive correction of a placement; unknowns are named after the placement's components.
Effect placementEffect(const char* name, PlaceKind place, const std::vector<std::size_t>& numbers,
                       const std::vector<double>& sigmas) {
  static const std::vector<Unknown> all{{"x", "m", 0},      {"y", "m", 0},       {"z", "m", 0},
                                        {"roll", "rad", 0}, {"pitch", "rad", 0}, {"yaw", "rad", 0}};
  Effect effect{.name = name,
                .description = "where it lies or stands",
                .formula = "placement = start + (x, y, z, roll, pitch, yaw)",
                .placeKind = place,
                .unknowns = {},
                .correct = {}};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    effect.unknowns.push_back(all[numbers[i]]);
    effect.unknowns.back().sigma = sigmas[i];
  }
  effect.correct = [place, numbers](ModelState& modelState, const RobotSample&, std::size_t at,
                                    std::span<const double> values) {
    auto placement = placementIn(modelState, place, at);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      placement[static_cast<Eigen::Index>(numbers[i])] += values[i];
    }
  };
  return effect;
}

constexpr double anywhere = 10; // [m]: placement in the world without a guess

constexpr double anyDirection = 10; // [rad]

const std::vector<std::size_t> xyzNumbers{0, 1, 2}, allNumbers{0, 1, 2, 3, 4, 5};
const std::vector<double> anyXyz(3, anywhere), anyPose{anywhere,     anywhere,     anywhere,
                                                       anyDirection, anyDirection, anyDirection};

/// Replaces the sigmas of these numbers that a set gives.
void setGivenSigmas(const Placement& given, const std::vector<std::size_t>& numbers, std::vector<double>& sigmas) {
  const double all[6] = {given.x, given.y, given.z, given.roll, given.pitch, given.yaw};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (all[numbers[i]] > 0) {
      sigmas[i] = all[numbers[i]];
    }
  }
}

void addBoardPlacement(const Measurements& measurements, std::size_t index, Model& model) {
  const Target& target = measurements.targets[index];
  std::vector<std::size_t> numbers{0, 1, 5};
  std::vector<double> sigmas{anywhere, anywhere, anyDirection};
  if (!target.isFlat) {
    const bool isReferred = measurements.quantities.scene().hasLinkSteps && !target.board.hasGuess;
    numbers = target.board.points.size() == 1 ? xyzNumbers : allNumbers;
    sigmas = target.inWorld || isReferred ? anyPose : std::vector<double>{0.05, 0.05, 0.05, 0.3, 0.3, 0.3};
  }
  if (const auto& sigma = target.board.placementSigma) {
    setGivenSigmas(*sigma, numbers, sigmas);
  }
  sigmas.resize(numbers.size());
  model.add(
      {placementEffect(effectName::boardPlacement, PlaceKind::board, numbers, sigmas), index, target.name, 0, true});
}

void addStancePlacement(const Measurements& measurements, std::size_t index, Model& model) {
  const StanceInstance& stance = measurements.stances[index];
  const Effect effect = stance.isFlat
                            ? placementEffect(effectName::stancePlacement, PlaceKind::stance, {0, 1, 5},
                                              {anywhere, anywhere, anyDirection})
                            : placementEffect(effectName::stancePlacement, PlaceKind::stance, allNumbers, anyPose);
  model.add({effect, index, stance.name, 0, true});
}

/// Adds unknown placements of cameras beside the robot.
void addCameraPlacements(const Measurements& measurements, const std::set<std::size_t>& cameras, Model& model) {
  for (const std::size_t camera : cameras) {
    if (measurements.isCameraUnknown(camera)) {
      const std::string& name = measurements.robot.cameras[camera].name;
      std::vector<double> sigmas = anyPose;
      if (const auto& sigma = measurements.sets->front().mountings.at(name).sigma) {
        setGivenSigmas(*sigma, allNumbers, sigmas);
      }
      model.add(
          {placementEffect(effectName::cameraPlacement, PlaceKind::camera, allNumbers, sigmas), camera, name, 0, true});
    }
  }
}

/// Adds unknown placements of instruments, and of what they measure, that the readings depend on.
void addInstrumentPlacements(const Measurements& measurements, Model& model) {
  std::set<std::size_t> used;
  for (const ImageObservation& picture : measurements.pictures) {
    for (const WitnessObservation& observation : picture.witnesses) {
      used.insert(observation.witness->own().begin(), observation.witness->own().end());
    }
  }
  const StateLayout& layout = measurements.quantities;
  const InstrumentList& all = measurements.instruments;
  for (std::size_t i = 0; i < all.trackers.size(); ++i) {
    if (!all.trackers[i].tracker.placement && used.contains(layout.tracker(i))) {
      model.add({placementEffect(effectName::trackerPlacement, PlaceKind::tracker, allNumbers, anyPose), i,
                 all.trackers[i].name, 0, true});
    }
  }
  for (std::size_t i = 0; i < all.markers.size(); ++i) {
    const TrackedMarker& marker = all.markers[i].marker;
    if (!marker.point && used.contains(layout.marker(i))) {
      model.add({placementEffect(effectName::markerPoint, PlaceKind::marker, xyzNumbers,
                                 std::vector<double>(3, marker.pointSigma)),
                 i, all.markers[i].name, 0, true});
    }
  }
  for (std::size_t i = 0; i < all.frames.size(); ++i) {
    if (!all.frames[i].frame.placement && used.contains(layout.frame(i))) {
      model.add({placementEffect(effectName::framePlacement, PlaceKind::frame, allNumbers, anyPose), i,
                 all.frames[i].name, 0, true});
    }
  }
  for (std::size_t i = 0; i < all.places.size(); ++i) {
    if (!all.places[i].place.point && used.contains(layout.place(i))) {
      model.add({placementEffect(effectName::placePoint, PlaceKind::place, xyzNumbers, anyXyz), i, all.places[i].name,
                 0, true});
    }
  }
}

/// Adds unknown placements that the measurements depend on. Boards and soles on the floor: x, y, yaw; elsewhere: all
/// six, or three for a single mark. Prior sigma: the set's own, else practically unconstrained.
void addPlacementTerms(const Measurements& measurements, Model& model) {
  std::set<std::size_t> seen, stood, cameras;
  for (const ImageObservation& picture : measurements.pictures) {
    for (const BoardObservation& observation : picture.observations) {
      const bool standsBeside = measurements.robot.cameras[picture.camera].inWorld;
      seen.insert(observation.view.board());
      if (measurements.targets[observation.view.board()].inWorld || standsBeside) {
        stood.insert(picture.stance);
      }
      if (standsBeside) {
        cameras.insert(picture.camera);
      }
    }
    if (!picture.witnesses.empty()) {
      stood.insert(picture.stance);
    }
  }
  for (std::size_t target : seen) {
    if (measurements.targets[target].unknown) {
      addBoardPlacement(measurements, target, model);
    }
  }
  for (std::size_t standing : stood) {
    if (measurements.stances[standing].unknown) {
      addStancePlacement(measurements, standing, model);
    }
  }
  addCameraPlacements(measurements, cameras, model);
  addInstrumentPlacements(measurements, model);
}

/// Joints whose readings a term needs in a picture; none if the picture cannot show it.
std::vector<std::size_t> jointsToRead(const Term& term, const Measurements& measurements,
                                      const ImageObservation& picture) {
  const Effect& effect = term.effect;
  const std::vector<std::size_t> places = placesOn(term, measurements, picture);
  const bool shares = effect.placeKind == PlaceKind::sole && picture.instant.supportFoot == SupportFoot::both;
  if (picture.measuresNothing() || places.empty() || shares) {
    return {};
  }
  std::vector<std::size_t> joints = observedJoints(measurements.robot, picture);
  if (effect.placeKind == PlaceKind::motor || effect.placeKind == PlaceKind::joint) {
    std::erase_if(joints,
                  [&](std::size_t joint) { return std::find(places.begin(), places.end(), joint) == places.end(); });
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

std::string labelFor(const std::string& given, const Robot& robot) {
  const std::size_t split = std::min(given.find('@'), given.size());
  std::string effect = given.substr(0, split), place = given.substr(split);
  for (const Effect& known : allEffects()) {
    effect = !known.alias.empty() && known.alias == effect ? known.name : effect;
  }
  if (const auto joint = place.empty() ? std::nullopt : robot.jointIndex(place.substr(1))) {
    place = '@' + robot.joints[robot.joints[*joint].motor].name;
  }
  return effect + place;
}

Model withWeighingOffsets(const Measurements& measurements, Model model, const std::vector<Term>& further) {
  const auto& terms = model.terms();
  if (std::any_of(terms.begin(), terms.end(), looksAtWeight) ||
      std::none_of(further.begin(), further.end(), looksAtWeight)) {
    return model;
  }
  for (Term& term : weighingOffsets(measurements)) {
    const bool there =
        std::any_of(terms.begin(), terms.end(), [&](const Term& own) { return own.label() == term.label(); });
    if (!there) {
      model.add(std::move(term));
    }
  }
  return model;
}

Model buildModel(const Measurements& measurements, const std::vector<std::string>& with,
                 const std::vector<std::string>& without, const std::vector<Effect>& effects) {
  std::vector<Pattern> added = patterns(with), removed = patterns(without);
  const Robot& robot = measurements.robot;
  std::vector<std::string> known;
  std::vector<Term> chosen;
  for (Term& term : candidateTerms(measurements, effects)) {
    known.push_back(term.label());
    if (anyNames(removed, term, robot)) {
      mark(removed, term, robot);
      mark(added, term, robot);
    } else if (term.effect.inBaseModel || anyNames(added, term, robot)) {
      const auto undriven = untestableReason(term.effect, term.placeIndex, measurements);
      mark(added, term, robot, undriven);
      if (!undriven) {
        chosen.push_back(std::move(term));
      }
    }
  }
  if (std::any_of(chosen.begin(), chosen.end(), looksAtWeight)) {
    for (Term& term : weighingOffsets(measurements)) {
      mark(removed, term, robot);
      if (!anyNames(removed, term, robot)) {
        chosen.push_back(std::move(term));
      }
    }
  }
  refuseUnused(added, known);
  refuseUnused(removed, known);
  Model model;
  for (Term& term : chosen) {
    model.add(std::move(term));
  }
  addPlacementTerms(measurements, model);
  return model;
}

} // namespace naocal

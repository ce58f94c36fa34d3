#include "measurements/Measurements.hpp"

#include "io/InputError.hpp"
#include "measurements/ApproachOrder.hpp"
#include "measurements/CaptureReading.hpp"
#include "measurements/FrameRegistry.hpp"
#include "measurements/InitialPlacements.hpp"
#include "measurements/Noise.hpp"
#include "measurements/RestGrouping.hpp"
#include "measurements/WitnessSource.hpp"
#include "robot/Kinematics.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <vector>

namespace naocal {

namespace {

void refuseOtherRobots(const std::vector<CaptureSet>& sets) {
  const CaptureSet& first = sets.front();
  for (const CaptureSet& set : sets) {
    if (set.bodyId != first.bodyId || set.headId != first.headId || set.model != first.model) {
      throw InputError{fmt::format(
          "{}: robot: expected the robot of {} (model {}, body {}, head {}), found model {}, body "
          "{}, head {}; sets given together must be of one robot",
          set.name, first.name, first.model, first.bodyId, first.headId, set.model, set.bodyId, set.headId)};
    }
  }
}

Seconds earliestTime(const CaptureSet& set) {
  Seconds first = Seconds::max();
  for (const Capture& capture : set.captures) {
    first = std::min(first, capture.time);
  }
  return first;
}

/// Sets the placements of instruments and what they measure; unknown ones count from their references.
void drawInstruments(const InstrumentList& instruments, ModelState& nominal) {
  for (std::size_t i = 0; i < instruments.trackers.size(); ++i) {
    nominal.trackerPlacement(i) = instruments.trackers[i].tracker.placement.value_or(Placement{}).numbers();
  }
  for (std::size_t i = 0; i < instruments.markers.size(); ++i) {
    const TrackedMarker& marker = instruments.markers[i].marker;
    nominal.marker(i) = marker.point.value_or(marker.pointGuess);
  }
  for (std::size_t i = 0; i < instruments.frames.size(); ++i) {
    nominal.framePlacement(i) = instruments.frames[i].frame.placement.value_or(Placement{}).numbers();
  }
  for (std::size_t i = 0; i < instruments.places.size(); ++i) {
    nominal.place(i) = instruments.places[i].place.point.value_or(Eigen::Vector3d::Zero());
  }
}

/// Estimates unknown placements of a robot with a URDF, and lets the state's numbers count from them.
void referPlacements(Measurements& measurements, const FrameRegistry& places) {
  placeInitially(measurements, [&](const CaptureSet& set, const std::string& id) { return places.scopedId(set, id); });
  for (ImageObservation& picture : measurements.pictures) {
    for (BoardObservation& observation : picture.observations) {
      observation.view.setReference(measurements.targets[observation.view.board()].reference);
    }
    drawInstruments(measurements.instruments, picture.nominal);
  }
}

/// Adds the measurements other than corners: those of each capture, and the distances, which belong to none, to the
/// first picture.
void addWitnesses(Measurements& measurements, const FrameRegistry& places) {
  for (ImageObservation& picture : measurements.pictures) {
    const CaptureSet& set = measurements.setOf(picture);
    const Capture& capture = measurements.captureOf(picture);
    const Eigen::VectorXd recorded = measuredAngles(measurements.robot, set, capture);
    WitnessSource source{.set = set,
                         .capture = capture,
                         .stance = picture.stance,
                         .recorded = recorded,
                         .measurements = measurements,
                         .nameOf = [&](const std::string& id) { return places.scopedId(set, id); },
                         .witnesses = picture.witnesses};
    for (const auto& addKind : witnessKinds()) {
      addKind(source);
    }
    measurements.witnessCount += picture.witnesses.size();
  }
  for (const CaptureSet& set : *measurements.sets) {
    for (WitnessObservation& distance :
         makePlaceDistances(measurements, set, [&](const std::string& id) { return places.scopedId(set, id); })) {
      measurements.pictures.front().witnesses.push_back(std::move(distance));
    }
  }
}

} // namespace

bool Measurements::isCameraUnknown(std::size_t camera) const {
  const auto mounting = sets->front().mountings.find(robot.cameras[camera].name);
  return robot.cameras[camera].inWorld && mounting != sets->front().mountings.end() && !mounting->second.placement;
}

bool Measurements::hasUnknownSteps() const {
  const CaptureSet& set = sets->front();
  return !set.urdf.empty() && std::any_of(joints.begin(), joints.end(), [&](std::size_t joint) {
    return !set.encoderSteps.contains(robot.joints[joint].name);
  });
}

bool Measurements::hasUnknownNoise() const {
  return std::any_of(levels.begin(), levels.end(), [](const ReadingLevel& level) { return !level.isGiven; });
}

double sigmaOf(const Measurements& measurements, const Noise& noise, std::size_t level) {
  return noise.readings.empty() ? measurements.levels[level].sigma : noise.readings[level];
}

std::vector<std::size_t> posesOfPictures(const Measurements& measurements) {
  std::vector<std::size_t> result(measurements.pictures.size());
  for (std::size_t pose = 0; pose < measurements.poses.size(); ++pose) {
    for (const EncoderSample& reading : measurements.poses[pose].readings) {
      for (const std::size_t picture : reading.pictures) {
        result[picture] = pose;
      }
    }
  }
  return result;
}

Measurements buildMeasurements(std::vector<CaptureSet> given, const Robot& robot, bool samePlace) {
  refuseOtherRobots(given);
  const FrameRegistry places{given, robot, samePlace};
  Measurements result;
  for (CaptureSet& set : given) {
    result.failedReadings.push_back(findFailedReadings(set, robot));
    removeFailedReadings(result.failedReadings.back(), set);
  }
  result.sets = std::make_shared<const std::vector<CaptureSet>>(std::move(given));
  const std::vector<CaptureSet>& sets = *result.sets;
  result.robot = robot;
  result.samePlace = samePlace;
  result.instruments = places.instruments();
  const InstrumentList& instruments = result.instruments;
  const bool isUrdf = !sets.front().urdf.empty();
  result.quantities = StateLayout{robot.joints.size(),
                                  robot.lengths.size(),
                                  places.targets().size(),
                                  {.trackers = instruments.trackers.size(),
                                   .markers = instruments.markers.size(),
                                   .frames = instruments.frames.size(),
                                   .places = instruments.places.size(),
                                   .hasLinkSteps = isUrdf}};
  result.targets = places.targets();
  result.stances = places.stances();
  result.recordedMotors = recordedMotors(sets, robot);
  for (std::size_t set = 0; set < sets.size(); ++set) {
    const Seconds first = earliestTime(sets[set]);
    for (std::size_t capture = 0; capture < sets[set].captures.size(); ++capture) {
      result.pictures.push_back(makeImageObservation(set, capture, result, places));
      result.pictures.back().instant.time -= first;
      result.pictures.back().instant.set = set;
      for (const BoardObservation& observation : result.pictures.back().observations) {
        result.cornerCount += observation.ids.size();
      }
    }
  }
  if (isUrdf || !instruments.trackers.empty() || !instruments.places.empty()) {
    referPlacements(result, places);
    addWitnesses(result, places);
  }
  groupByPose(result);
  deriveApproaches(result);
  return result;
}

std::vector<std::size_t> observedJoints(const Robot& robot, const ImageObservation& picture) {
  std::vector<char> between(robot.joints.size(), 0);
  const auto add = [&](const ObservationChain& view) {
    for (const std::size_t joint : view.joints()) {
      between[joint] = 1;
    }
  };
  for (const BoardObservation& observation : picture.observations) {
    add(observation.view);
  }
  for (const WitnessObservation& witness : picture.witnesses) {
    if (witness.view) {
      add(*witness.view);
    }
  }
  for (const ObservationChain& sole : picture.otherSoles) {
    add(sole);
  }
  std::vector<std::size_t> joints;
  for (std::size_t joint = 0; joint < between.size(); ++joint) {
    if (between[joint] != 0) {
      joints.push_back(joint);
    }
  }
  return joints;
}

} // namespace naocal

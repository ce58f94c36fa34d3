#include "estimation/PlacementTerms.hpp"

#include "effects/Catalogue.hpp"
#include "measurements/Measurements.hpp"

#include <set>
#include <span>

namespace naocal {

namespace {

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

} // namespace

void setGivenSigmas(const Placement& given, const std::vector<std::size_t>& numbers, std::vector<double>& sigmas) {
  const Eigen::Matrix<double, 6, 1> all = given.numbers();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (const double sigma = all[static_cast<Eigen::Index>(numbers[i])]; sigma > 0) {
      sigmas[i] = sigma;
    }
  }
}

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

} // namespace naocal

#include "calibration/result/PlacementFile.hpp"

#include "effects/Catalogue.hpp"
#include "estimation/DriverState.hpp"
#include "math/LinearAlgebra.hpp"
#include "robot/Kinematics.hpp"

#include <nlohmann/json.hpp>
#include <set>

namespace naocal {

using nlohmann::json;

namespace {

using SixNumbers = Eigen::Matrix<double, 6, 1>;

Placement placementFrom(const json& value) {
  return {value.value("x", 0.0),    value.value("y", 0.0),     value.value("z", 0.0),
          value.value("roll", 0.0), value.value("pitch", 0.0), value.value("yaw", 0.0)};
}

json placementJson(const SixNumbers& p, bool isFlat) {
  if (isFlat) {
    return {{"x", p[0]}, {"y", p[1]}, {"yaw", p[5]}};
  }
  return {{"x", p[0]}, {"y", p[1]}, {"z", p[2]}, {"roll", p[3]}, {"pitch", p[4]}, {"yaw", p[5]}};
}

bool isIdentity(const RigidTransform& transform) {
  return transform.rotation == Eigen::Matrix3d::Identity() && transform.translation == Eigen::Vector3d::Zero();
}

/// A placement that counts from a reference, in the frame that the reference is in.
SixNumbers fromReference(const RigidTransform& reference, const SixNumbers& p) {
  return isIdentity(reference) ? p : placementFromTransform(reference * transformFromPlacement(p));
}

/// worldFromMount of a camera beside the robot, in the axes that its set names.
SixNumbers cameraPlacement(const Measurements& measurements, std::size_t camera, const ModelState& modelState) {
  const CameraMount& mount = measurements.robot.cameras[camera];
  const bool isOptical = measurements.sets->front().mountings.at(mount.name).isOptical;
  return placementFromTransform(isOptical ? linkFromOptical(mount, modelState) : linkFromCamera(mount, modelState));
}

/// Placements of cameras beside the robot, instruments and what they measure; only what there is.
void addInstrumentPlacements(const FittedModel& fitted, json& placements) {
  const Measurements& measurements = fitted.measurements;
  const ModelState modelState =
      predictState(measurements, fitted.model, measurements.pictures.front(), fitted.fit.unknowns);
  for (const ImageObservation& picture : measurements.pictures) {
    if (picture.camera != ImageObservation::noCamera && measurements.robot.cameras[picture.camera].inWorld) {
      placements["cameras"][measurements.robot.cameras[picture.camera].name] =
          placementJson(cameraPlacement(measurements, picture.camera,
                                        predictState(measurements, fitted.model, picture, fitted.fit.unknowns)),
                        false);
    }
  }
  std::set<std::size_t> used;
  for (const ImageObservation& picture : measurements.pictures) {
    for (const WitnessObservation& observation : picture.witnesses) {
      used.insert(observation.witness->own().begin(), observation.witness->own().end());
    }
  }
  const InstrumentList& all = measurements.instruments;
  const StateLayout& layout = measurements.quantities;
  const auto add = [&](const char* key, const auto& entries, const auto& first, const auto& value) {
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (used.contains(first(i))) {
        placements[key][entries[i].name] = value(i);
      }
    }
  };
  const auto pointJson = [](const Eigen::Vector3d& point) { return json{point.x(), point.y(), point.z()}; };
  add(
      "trackers", all.trackers, [&](std::size_t i) { return layout.tracker(i); },
      [&](std::size_t i) {
        return placementJson(fromReference(all.trackers[i].reference, modelState.trackerPlacement(i)), false);
      });
  add(
      "markers", all.markers, [&](std::size_t i) { return layout.marker(i); },
      [&](std::size_t i) { return pointJson(modelState.marker(i)); });
  add(
      "frames", all.frames, [&](std::size_t i) { return layout.frame(i); },
      [&](std::size_t i) {
        return placementJson(fromReference(all.frames[i].reference, modelState.framePlacement(i)), false);
      });
  add(
      "places", all.places, [&](std::size_t i) { return layout.place(i); },
      [&](std::size_t i) { return pointJson(modelState.place(i)); });
}

/// The inverse of `fromReference`.
SixNumbers toReference(const RigidTransform& reference, const SixNumbers& p) {
  return isIdentity(reference) ? p : placementFromTransform(reference.inverse() * transformFromPlacement(p));
}

/// Shift and turn of a camera beside the robot against its mount, for a placement in the axes that its set names.
SixNumbers mountNumbers(const Measurements& measurements, std::size_t camera, const Placement& placement) {
  const CameraMount& mount = measurements.robot.cameras[camera];
  const bool isOptical = measurements.sets->front().mountings.at(mount.name).isOptical;
  RigidTransform worldFromCamera = transformFromPlacement(placement.numbers());
  if (isOptical) {
    worldFromCamera.rotation *= opticalFromCamera();
  }
  SixNumbers numbers;
  numbers << worldFromCamera.translation - mount.translation,
      turnsAboutXyz(mount.rotation.transpose() * worldFromCamera.rotation);
  return numbers;
}

template <typename Value> const Value* find(const std::map<std::string, Value>& stored, const std::string& name) {
  const auto entry = stored.find(name);
  return entry == stored.end() ? nullptr : &entry->second;
}

/// The numbers of a stored placement in the order of the term's kind of placement: six, or three of a point.
std::optional<Eigen::VectorXd> storedNumbers(const StoredPlacements& stored, const Measurements& measurements,
                                             const Term& term) {
  const InstrumentList& all = measurements.instruments;
  const std::size_t at = term.placeIndex;
  const auto placed = [&](const std::map<std::string, Placement>& list,
                          const RigidTransform& reference) -> std::optional<Eigen::VectorXd> {
    const Placement* const entry = find(list, term.placeName);
    return entry ? std::optional<Eigen::VectorXd>{toReference(reference, entry->numbers())} : std::nullopt;
  };
  switch (term.effect.placeKind) {
  case PlaceKind::board:
    return placed(stored.boards, measurements.targets[at].reference);
  case PlaceKind::camera: {
    const Placement* const entry = find(stored.cameras, term.placeName);
    return entry ? std::optional<Eigen::VectorXd>{mountNumbers(measurements, at, *entry)} : std::nullopt;
  }
  case PlaceKind::tracker:
    return placed(stored.trackers, all.trackers[at].reference);
  case PlaceKind::frame:
    return placed(stored.frames, all.frames[at].reference);
  case PlaceKind::marker: {
    const Eigen::Vector3d* const point = find(stored.markers, term.placeName);
    return point ? std::optional<Eigen::VectorXd>{*point - all.markers[at].marker.pointGuess} : std::nullopt;
  }
  case PlaceKind::place: {
    const Eigen::Vector3d* const point = find(stored.places, term.placeName);
    return point ? std::optional<Eigen::VectorXd>{*point} : std::nullopt;
  }
  default:
    return placed(stored.stances, {});
  }
}

} // namespace

json placementsJson(const FittedModel& fitted) {
  json boards = json::object(), stances = json::object();
  for (const ImageObservation& picture : fitted.measurements.pictures) {
    const ModelState modelState = predictState(fitted.measurements, fitted.model, picture, fitted.fit.unknowns);
    for (const BoardObservation& observation : picture.observations) {
      const Target& target = fitted.measurements.targets[observation.view.board()];
      boards[target.name] = placementJson(
          fromReference(target.reference, modelState.boardPlacement(observation.view.board())), target.isFlat);
      if (target.inWorld) {
        const StanceInstance& stance = fitted.measurements.stances[picture.stance];
        stances[stance.name] = placementJson(modelState.worldFromSupport(), stance.isFlat);
      }
    }
  }
  json placements{{"boards", std::move(boards)}, {"stances", std::move(stances)}};
  if (fitted.measurements.quantities.scene().hasLinkSteps || fitted.measurements.witnessCount > 0) {
    addInstrumentPlacements(fitted, placements);
  }
  return placements;
}

StoredPlacements parsePlacements(const json& placements) {
  StoredPlacements result;
  const auto read = [&](const char* key, std::map<std::string, Placement>& list) {
    const json entries = placements.value(key, json::object());
    for (const auto& [name, placement] : entries.items()) {
      list[name] = placementFrom(placement);
    }
  };
  const auto readPoints = [&](const char* key, std::map<std::string, Eigen::Vector3d>& list) {
    const json entries = placements.value(key, json::object());
    for (const auto& [name, point] : entries.items()) {
      list[name] = {point.at(0).get<double>(), point.at(1).get<double>(), point.at(2).get<double>()};
    }
  };
  placements.at("boards");
  placements.at("stances");
  read("boards", result.boards);
  read("stances", result.stances);
  read("cameras", result.cameras);
  read("trackers", result.trackers);
  read("frames", result.frames);
  readPoints("markers", result.markers);
  readPoints("places", result.places);
  return result;
}

bool placeAsStored(const StoredPlacements& stored, const Measurements& measurements, const Term& term,
                   Eigen::VectorXd& unknowns) {
  auto numbers = storedNumbers(stored, measurements, term);
  if (!numbers) {
    return false;
  }
  if (term.effect.placeKind == PlaceKind::board) {
    *numbers -= measurements.pictures.front().nominal.boardPlacement(term.placeIndex);
  }
  static const std::map<std::string, Eigen::Index> order{{"x", 0},    {"y", 1},     {"z", 2},
                                                         {"roll", 3}, {"pitch", 4}, {"yaw", 5}};
  for (std::size_t i = 0; i < term.effect.unknowns.size(); ++i) {
    unknowns[eigenIndex(term.first + i)] = (*numbers)[order.at(term.effect.unknowns[i].name)];
  }
  return true;
}

} // namespace naocal

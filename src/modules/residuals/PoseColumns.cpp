// What the residuals' sums are over: each pose's unknowns and deflections, known before any sum is taken.
#include "math/LinearAlgebra.hpp"
#include "math/Parallel.hpp"
#include "residuals/Residuals.hpp"

#include <algorithm>
#include <map>

namespace naocal {

namespace {

/// How the torso sees the floor, where the inertial unit's tilt is an unknown and its reading was recorded.
std::optional<View> torsoOverFloor(const Measurements& measurements, const Model& model, const Picture& picture) {
  const bool wanted = std::any_of(model.terms().begin(), model.terms().end(),
                                  [](const Term& term) { return term.effect.name == "imuTilt"; });
  const bool onFloor = std::any_of(picture.sightings.begin(), picture.sightings.end(), [&](const Sighting& sighting) {
    return measurements.targets[sighting.view.board()].onFloor;
  });
  if (!wanted || !onFloor || picture.instant.imu.hasNaN()) {
    return std::nullopt;
  }
  const bool right = picture.instant.supportFoot == SupportFoot::right;
  return View::betweenLinks(measurements.robot, measurements.quantities, 0,
                            measurements.robot.sole(right ? "right" : "left")->link);
}

} // namespace

Residuals::Residuals(const Measurements& measurements, const Model& model, const Noise& noise, const Loss& loss)
    : measurements_{measurements}, model_{model}, noise_{noise}, loss_{loss}, sigmas_{model.sigmas()},
      free_(model.unknownCount(), true), prepared_(measurements.pictures.size()), columns_(measurements.poses.size()),
      roots_(measurements.poses.size()) {
  inParallel(prepared_.size(), [&](std::size_t i) {
    prepared_[i].slopes = PictureSlopes{measurements, model, measurements.pictures[i]};
    prepared_[i].torso = torsoOverFloor(measurements, model, measurements.pictures[i]);
  });
  inParallel(columns_.size(), [&](std::size_t pose) {
    columns_[pose] = columnsOf(measurements.poses[pose]);
    roots_[pose] = deflectionRoot(columns_[pose], noise_);
    for (const Reading& reading : measurements.poses[pose].readings) {
      for (std::size_t index : reading.pictures) {
        prepare(measurements, measurements.pictures[index], columns_[pose].unknowns, prepared_[index]);
      }
    }
  });
}

/// The unknowns that a pose depends on, and a deflection per joint on its paths and encoder error.
PosePart Residuals::columnsOf(const PoseGroup& pose) {
  PosePart part;
  std::vector<bool> moves(model_.unknownCount(), false);
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> deflections; // of motor and encoder error
  const bool latent = noise_.encoder > 0 || noise_.pose > 0 || noise_.stance > 0 || noise_.reapproach > 0;
  for (const Reading& reading : pose.readings) {
    for (std::size_t index : reading.pictures) {
      PreparedPicture& picture = prepared_[index];
      for (const Slope& slope : picture.slopes.list()) {
        moves[slope.unknown] = true;
      }
      if (latent) {
        picture.joints = jointsBetween(measurements_.robot, measurements_.pictures[index]);
      }
      for (std::size_t joint : picture.joints) {
        deflections[{measurements_.robot.joints[joint].motor, reading.encoderError[joint]}];
      }
    }
  }
  for (auto& [joint, number] : deflections) {
    number = part.joints.size();
    part.joints.push_back(joint.first);
    part.errors.push_back(joint.second);
    part.errorScales.push_back(pose.encoderErrors[joint.second].scale);
    part.stances.push_back(pose.encoderErrors[joint.second].stance);
  }
  for (const Reading& reading : pose.readings) {
    for (std::size_t index : reading.pictures) {
      for (std::size_t joint : prepared_[index].joints) {
        prepared_[index].deflections.push_back(
            deflections.at({measurements_.robot.joints[joint].motor, reading.encoderError[joint]}));
      }
    }
  }
  for (std::size_t unknown = 0; unknown < moves.size(); ++unknown) {
    if (moves[unknown]) {
      part.unknowns.push_back(unknown);
    }
  }
  return part;
}

} // namespace naocal

#include "setups/CaptureSelection.hpp"

#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace naocal {

namespace {

/// Angles of the joints in use, each relative to the range in which it moves; the camera as one more.
Eigen::MatrixXd describePictures(const Measurements& measurements) {
  const Eigen::Index joints = eigenIndex(measurements.joints.size());
  Eigen::MatrixXd places(joints + 1, eigenIndex(measurements.pictures.size()));
  for (std::size_t i = 0; i < measurements.pictures.size(); ++i) {
    const ImageObservation& picture = measurements.pictures[i];
    for (Eigen::Index joint = 0; joint < joints; ++joint) {
      places(joint, eigenIndex(i)) =
          picture.instant.q[eigenIndex(measurements.joints[static_cast<std::size_t>(joint)])];
    }
    places(joints, eigenIndex(i)) =
        picture.camera == ImageObservation::noCamera ? 0 : static_cast<double>(picture.camera) + 1;
  }
  for (Eigen::Index row = 0; row <= joints; ++row) {
    const double low = places.row(row).minCoeff(), range = places.row(row).maxCoeff() - low;
    places.row(row) =
        range > 0 ? ((places.row(row).array() - low) / range).matrix().eval() : Eigen::RowVectorXd::Zero(places.cols());
  }
  return places;
}

/// Independent numbers that a picture measures.
double numbersOf(const ImageObservation& picture) {
  constexpr double most = 6; // degrees of freedom of a board before a camera
  double numbers = 0;
  for (const BoardObservation& observation : picture.observations) {
    numbers += std::min(most, 2 * static_cast<double>(observation.ids.size()));
  }
  for (const WitnessObservation& observation : picture.witnesses) {
    for (const Witness::Part& part : observation.witness->parts()) {
      numbers += static_cast<double>(part.count);
    }
  }
  return numbers;
}

} // namespace

Recording CaptureSelection::of(const Recording& recording) const {
  Recording part = recording;
  for (std::size_t i = 0; i < part.sets.size(); ++i) {
    std::erase_if(part.sets[i].captures, [&](const Capture& capture) { return !captures.contains({i, capture.id}); });
  }
  return part;
}

CaptureSelection selectCaptures(const Measurements& measurements, std::size_t unknowns) {
  constexpr double perUnknown = 5; // numbers
  constexpr std::size_t fewest = 12;
  const Eigen::MatrixXd places = describePictures(measurements);
  Eigen::VectorXd distances = Eigen::VectorXd::Constant(places.cols(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < measurements.pictures.size(); ++i) {
    if (measurements.pictures[i].measuresNothing()) {
      distances[eigenIndex(i)] = -1;
    }
  }
  CaptureSelection selection;
  double numbers = 0;
  while (selection.captures.size() < measurements.pictures.size()) {
    Eigen::Index next = 0;
    const double farthest = distances.maxCoeff(&next);
    const bool isEnough = numbers >= perUnknown * static_cast<double>(unknowns) && selection.captures.size() >= fewest;
    if (farthest < 0 || isEnough) {
      break;
    }
    const ImageObservation& picture = measurements.pictures[static_cast<std::size_t>(next)];
    selection.captures.insert({picture.set, measurements.captureOf(picture).id});
    numbers += numbersOf(picture);
    distances = distances.cwiseMin((places.colwise() - places.col(next)).colwise().norm().transpose());
    distances[next] = -1;
  }
  return selection;
}

} // namespace naocal

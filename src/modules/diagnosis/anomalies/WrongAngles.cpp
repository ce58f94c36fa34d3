#include "diagnosis/anomalies/WrongAngles.hpp"

#include "calibration/ReadingErrors.hpp"
#include "measurements/Measurements.hpp"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>

namespace naocal {

namespace {

/// Pictures of one approach or pose.
struct Together {
  std::size_t set = 0;
  std::string pose;
  std::set<double> times;
  std::vector<int> captures; // ids
  double squares = 0; // sum over pictures of the corners' mean error squared, times the number of corners [px^2],
                      // and of readings' squares in these units
  double counted = 0; // corners, or readings

  double error() const { return counted > 0 ? squares / counted : 0; }
  Together& operator+=(const Together& other) {
    set = other.set;
    pose = other.pose;
    times.insert(other.times.begin(), other.times.end());
    captures.insert(captures.end(), other.captures.begin(), other.captures.end());
    squares += other.squares;
    counted += other.counted;
    return *this;
  }
};

/// Displacement of the floor under the robot at these times only: x, y, z [m], roll, pitch, yaw [rad].
Effect makeDisplacement(std::size_t set, std::set<double> times) {
  constexpr double distance = 0.02, angle = 0.03;
  Effect effect{.name = "wrongAngles",
                .description = {},
                .formula = {},
                .placeKind = PlaceKind::all,
                .unknowns = {{"x", "m", distance},
                             {"y", "m", distance},
                             {"z", "m", distance},
                             {"roll", "rad", angle},
                             {"pitch", "rad", angle},
                             {"yaw", "rad", angle}},
                .correct = {}};
  effect.correct = [set, times = std::move(times)](ModelState& modelState, const RobotSample& instant, std::size_t,
                                                   std::span<const double> values) {
    if (instant.set == set && times.contains(instant.time.count())) {
      modelState.worldFromSupport() += Eigen::Map<const Eigen::Matrix<double, 6, 1>>{values.data()};
    }
  };
  return effect;
}

/// Errors by picture: of corners of boards on the floor, and of other readings.
struct PictureErrors {
  std::map<std::size_t, std::vector<const BoardResidual*>> boards;
  std::map<std::size_t, std::vector<double>> readings; // distances as `scaledDistances` [px]
};

Together alone(const Measurements& measurements, std::size_t index, const PictureErrors& errors) {
  const ImageObservation& picture = measurements.pictures[index];
  const Capture& capture = measurements.captureOf(picture);
  Together together{picture.set, capture.pose, {picture.instant.time.count()}, {capture.id}};
  if (const auto seen = errors.boards.find(index); seen != errors.boards.end()) {
    for (const BoardResidual* observation : seen->second) {
      const auto count = static_cast<double>(observation->residual.cols());
      together.squares += count * observation->residual.rowwise().mean().squaredNorm();
      together.counted += count;
    }
  }
  if (const auto read = errors.readings.find(index); read != errors.readings.end()) {
    for (const double distance : read->second) {
      together.squares += distance * distance;
      together.counted += 1;
    }
  }
  return together;
}

/// The `most` groups with the largest errors, largest first.
std::vector<Together> selectWorst(std::vector<Together> all, std::size_t most) {
  std::stable_sort(all.begin(), all.end(), [](const Together& a, const Together& b) { return a.error() > b.error(); });
  all.resize(std::min(most, all.size()));
  return all;
}

/// With joint angles as read.
PictureErrors collectErrors(const FittedModel& fitted) {
  const Measurements& measurements = fitted.measurements;
  PictureErrors result;
  for (const BoardResidual& observation : fitted.fit.withReportedAngles) {
    const ObservationChain& view =
        measurements.pictures[observation.picture].observations[observation.observation].view;
    if (measurements.targets[view.board()].inWorld) {
      result.boards[observation.picture].push_back(&observation);
    }
  }
  if (measurements.witnessCount > 0) {
    const Residuals residuals{measurements, fitted.model, fitted.fit.noise};
    for (const WitnessResidual& one : residuals.witnessResiduals(residuals.startState(fitted.fit.unknowns))) {
      const std::vector<double> distances = scaledDistances(measurements, {one}, fitted.fit.noise);
      auto& ofPicture = result.readings[one.picture];
      ofPicture.insert(ofPicture.end(), distances.begin(), distances.end());
    }
  }
  return result;
}

/// All approaches, and all poses.
struct Groups {
  std::vector<Together> approaches, poses;
};

Groups groupPictures(const Measurements& measurements, const PictureErrors& errors) {
  Groups result;
  for (const PoseGroup& pose : measurements.poses) {
    std::map<std::vector<std::size_t>, Together> rests; // readings with equal encoder errors belong to one approach
    for (const EncoderSample& reading : pose.readings) {
      for (const std::size_t index : reading.pictures) {
        rests[reading.encoderError] += alone(measurements, index, errors);
      }
    }
    Together& whole = result.poses.emplace_back();
    for (const auto& [encoderErrors, rest] : rests) {
      result.approaches.push_back(rest);
      whole += rest;
    }
  }
  return result;
}

/// `cause`: "somebody touched the robot".
TransientEvent makeWrongAngles(const Together& together, const std::string& cause, const Measurements& measurements) {
  const bool single = together.captures.size() == 1;
  const std::string which = fmt::format("{} {}", single ? "capture" : "captures", fmt::join(together.captures, ", "));
  return {.term = {makeDisplacement(together.set, together.times), 0,
                   fmt::format("{} of {}", which, (*measurements.sets)[together.set].name)},
          .who = which,
          .where = " of pose " + together.pose,
          .set = together.set,
          .captures = together.captures,
          .what = fmt::format("{} not belong to the rest: {}", single ? "does" : "do", cause)};
}

} // namespace

std::vector<TransientEvent> enumerateWrongAngles(const FittedModel& fitted) {
  constexpr std::size_t mostApproaches = 6, mostPoses = 3;
  const Measurements& measurements = fitted.measurements;
  const Groups groups = groupPictures(measurements, collectErrors(fitted));
  const char* const cause = measurements.cornerCount > 0 ? "somebody touched the robot, or its angles are wrong there"
                                                         : "a bad reading, or its angles are wrong there";
  std::vector<TransientEvent> result;
  for (const Together& approach : selectWorst(groups.approaches, mostApproaches)) {
    result.push_back(makeWrongAngles(approach, cause, measurements));
  }
  for (const Together& pose : selectWorst(groups.poses, mostPoses)) {
    result.push_back(makeWrongAngles(pose, "somebody touched the robot, or a joint slipped there", measurements));
  }
  return result;
}

} // namespace naocal

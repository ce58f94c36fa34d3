#include "diagnosis/WrongAngles.hpp"

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
  double squares = 0;        // sum over pictures of the corners' mean error squared, times the number of corners [px^2]
  double corners = 0;

  double error() const { return corners > 0 ? squares / corners : 0; }
  Together& operator+=(const Together& other) {
    set = other.set;
    pose = other.pose;
    times.insert(other.times.begin(), other.times.end());
    captures.insert(captures.end(), other.captures.begin(), other.captures.end());
    squares += other.squares;
    corners += other.corners;
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

Together alone(const ImageObservation& picture, const Capture& capture, const std::vector<const BoardResidual*>& seen) {
  Together together{picture.set, capture.pose, {picture.instant.time.count()}, {capture.id}};
  for (const BoardResidual* observation : seen) {
    const auto count = static_cast<double>(observation->residual.cols());
    together.squares += count * observation->residual.rowwise().mean().squaredNorm();
    together.corners += count;
  }
  return together;
}

/// The `most` groups with the largest errors, largest first.
std::vector<Together> selectWorst(std::vector<Together> all, std::size_t most) {
  std::stable_sort(all.begin(), all.end(), [](const Together& a, const Together& b) { return a.error() > b.error(); });
  all.resize(std::min(most, all.size()));
  return all;
}

/// Corner errors of boards on the floor, per picture.
using FloorResiduals = std::map<std::size_t, std::vector<const BoardResidual*>>;

FloorResiduals collectFloorResiduals(const Measurements& measurements, const CalibrationResult& fit) {
  FloorResiduals result;
  for (const BoardResidual& observation : fit.withReportedAngles) {
    const ObservationChain& view =
        measurements.pictures[observation.picture].observations[observation.observation].view;
    if (measurements.targets[view.board()].inWorld) {
      result[observation.picture].push_back(&observation);
    }
  }
  return result;
}

/// All approaches, and all poses.
struct Groups {
  std::vector<Together> approaches, poses;
};

Groups groupPictures(const Measurements& measurements, FloorResiduals residuals) {
  Groups result;
  for (const PoseGroup& pose : measurements.poses) {
    std::map<std::vector<std::size_t>, Together> rests; // readings with equal encoder errors belong to one approach
    for (const EncoderSample& reading : pose.readings) {
      for (const std::size_t index : reading.pictures) {
        const ImageObservation& picture = measurements.pictures[index];
        rests[reading.encoderError] += alone(picture, measurements.captureOf(picture), residuals[index]);
      }
    }
    Together& whole = result.poses.emplace_back();
    for (const auto& [errors, rest] : rests) {
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

std::vector<TransientEvent> enumerateWrongAngles(const Measurements& measurements, const CalibrationResult& fit) {
  constexpr std::size_t mostApproaches = 6, mostPoses = 3;
  const Groups groups = groupPictures(measurements, collectFloorResiduals(measurements, fit));
  std::vector<TransientEvent> result;
  for (const Together& approach : selectWorst(groups.approaches, mostApproaches)) {
    result.push_back(
        makeWrongAngles(approach, "somebody touched the robot, or its angles are wrong there", measurements));
  }
  for (const Together& pose : selectWorst(groups.poses, mostPoses)) {
    result.push_back(makeWrongAngles(pose, "somebody touched the robot, or a joint slipped there", measurements));
  }
  return result;
}

} // namespace naocal

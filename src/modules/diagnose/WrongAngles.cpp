#include "diagnose/WrongAngles.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <set>

namespace naocal {

namespace {

constexpr std::size_t mostApproaches = 6, mostPoses = 3; // that are worth a look

/// Pictures that were taken together.
struct Together {
  std::size_t set = 0;
  std::string pose;
  std::set<double> times;
  std::vector<int> captures; // ids
  double squares = 0;        // of corners' common errors, times the corners [px^2]
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

/// Placement of the floor under the robot, at these moments only: x, y, z [m], roll, pitch, yaw [rad].
Effect displaced(std::size_t set, std::set<double> times) {
  constexpr double distance = 0.02, angle = 0.03;
  Effect effect{.name = "wrongAngles",
                .what = {},
                .formula = {},
                .place = Place::all,
                .unknowns = {{"x", "m", distance},
                             {"y", "m", distance},
                             {"z", "m", distance},
                             {"roll", "rad", angle},
                             {"pitch", "rad", angle},
                             {"yaw", "rad", angle}},
                .correct = {}};
  effect.correct = [set, times = std::move(times)](Belief& belief, const Instant& instant, std::size_t,
                                                   std::span<const double> values) {
    if (instant.set == set && times.contains(instant.time.count())) {
      belief.ground() += Eigen::Map<const Eigen::Matrix<double, 6, 1>>{values.data()};
    }
  };
  return effect;
}

Together alone(const Picture& picture, const Capture& capture, const std::vector<const SightingResidual*>& seen) {
  Together together{picture.set, capture.pose, {picture.instant.time.count()}, {capture.id}};
  for (const SightingResidual* sighting : seen) {
    const auto count = static_cast<double>(sighting->residual.cols());
    together.squares += count * sighting->residual.rowwise().mean().squaredNorm();
    together.corners += count;
  }
  return together;
}

/// Those with the largest errors, the worst first.
std::vector<Together> worst(std::vector<Together> all, std::size_t most) {
  std::stable_sort(all.begin(), all.end(), [](const Together& a, const Together& b) { return a.error() > b.error(); });
  all.resize(std::min(most, all.size()));
  return all;
}

} // namespace

std::vector<Event> wrongAngles(const std::vector<CaptureSet>& sets, const Measurements& measurements,
                               const CalibrationResult& fit) {
  std::map<std::size_t, std::vector<const SightingResidual*>> byPicture;
  for (const SightingResidual& sighting : fit.asReported) {
    const View& view = measurements.pictures[sighting.picture].sightings[sighting.sighting].view;
    if (measurements.targets[view.board()].onFloor) {
      byPicture[sighting.picture].push_back(&sighting);
    }
  }
  std::vector<Together> poses, approaches;
  for (const PoseGroup& pose : measurements.poses) {
    std::map<std::vector<std::size_t>, Together> rests; // readings with the same errors are of one approach
    for (const Reading& reading : pose.readings) {
      for (const std::size_t index : reading.pictures) {
        const Picture& picture = measurements.pictures[index];
        rests[reading.encoderError] += alone(picture, sets[picture.set].captures[picture.capture], byPicture[index]);
      }
    }
    poses.emplace_back();
    for (const auto& [errors, rest] : rests) {
      approaches.push_back(rest);
      poses.back() += rest;
    }
  }
  std::vector<Event> result;
  const auto offer = [&](const std::vector<Together>& several, const char* what) {
    for (const Together& one : several) {
      const std::string ids = fmt::format("{}", fmt::join(one.captures, ", "));
      const std::string which = one.captures.size() == 1 ? "capture " + ids : "captures " + ids;
      result.push_back(
          {.term = {displaced(one.set, one.times), 0, fmt::format("{} of {}", which, sets[one.set].name)},
           .who = which,
           .where = " of pose " + one.pose,
           .set = one.set,
           .captures = one.captures,
           .what = fmt::format("{} not belong to the rest: {}", one.captures.size() == 1 ? "does" : "do", what)});
    }
  };
  offer(worst(approaches, mostApproaches), "somebody touched the robot, or its angles are wrong there");
  offer(worst(poses, mostPoses), "somebody touched the robot, or a joint slipped there");
  return result;
}

} // namespace naocal

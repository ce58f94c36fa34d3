#include "setups/Catalogue.hpp"
#include "setups/ReadingChanges.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <fmt/format.h>

namespace naocal {

namespace {

struct Mirror {
  std::string said;
  Eigen::Matrix3d matrix;
};

/// Where the tracker's place is unknown, all mirrors are one, but for a rotation.
std::vector<Mirror> listMirrors(bool isPlaced) {
  std::vector<Mirror> mirrors;
  const std::string axes = "xyz";
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const Eigen::Index one = (axis + 1) % 3, other = (axis + 2) % 3;
    Eigen::Matrix3d exchanged = Eigen::Matrix3d::Identity(), flipped = exchanged;
    exchanged.col(one).swap(exchanged.col(other));
    flipped(axis, axis) = -1;
    const auto letter = [&](Eigen::Index i) { return axes[static_cast<std::size_t>(i)]; };
    mirrors.push_back(
        {fmt::format("{} and {} are exchanged", letter(std::min(one, other)), letter(std::max(one, other))),
         exchanged});
    mirrors.push_back({fmt::format("{} has the wrong sign", letter(axis)), flipped});
  }
  if (!isPlaced) {
    mirrors.resize(1);
    mirrors.front().said = "two axes are exchanged, or one has the wrong sign";
  }
  return mirrors;
}

} // namespace

/// A tracker's coordinates are left-handed: two axes exchanged, or the sign of one.
SetUp mirroredTracker() {
  return {.name = "mirroredTracker",
          .description = "the tracker's coordinates are mirrored",
          .question = "Are the axes of {} right-handed, and in the order x, y, z?",
          .listPlaces = [](const Measurements& measurements) { return trackerIds(*measurements.sets); },
          .listMendings =
              [](const Measurements& measurements, const std::string& tracker) {
                const std::vector<Tracker>& trackers = measurements.sets->front().instruments.trackers;
                const bool isPlaced = std::any_of(trackers.begin(), trackers.end(), [&](const Tracker& one) {
                  return one.id == tracker && one.placement;
                });
                std::vector<Mending> ways;
                for (const auto& [said, matrix] : listMirrors(isPlaced)) {
                  for (const bool turnsFrames : {true, false}) {
                    if (!turnsFrames && trackersOfFrames(measurements).empty()) {
                      continue;
                    }
                    ways.push_back({fmt::format("the coordinates of {} are mirrored: {}", tracker, said),
                                    [tracker, mirror = matrix, turnsFrames](Recording& recording) {
                                      const auto reflect = [&](Eigen::Vector3d& point) { point = mirror * point; };
                                      changePoints(recording.sets, tracker, reflect);
                                      changeFrames(recording.sets, tracker, [&](FrameReading& reading) {
                                        reflect(reading.xyz);
                                        if (turnsFrames) {
                                          reading.rotation = Eigen::Quaterniond{Eigen::Matrix3d{
                                              mirror * reading.rotation.normalized().toRotationMatrix() * mirror}};
                                        }
                                      });
                                    }});
                  }
                }
                return ways;
              }};
}

} // namespace naocal

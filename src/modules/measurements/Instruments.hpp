#pragma once

#include "data/Capture.hpp"
#include "math/RigidTransform.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace naocal {

/// A tracker of one of the sets. worldFromTracker = reference * T(its placement in the state).
struct TrackerInstance {
  std::string name; // "vicon", or "<set>/vicon" with several sets
  Tracker tracker;
  RigidTransform reference;
};

/// A marker of one of the sets. `start`: where the search starts, in the link [m].
struct MarkerInstance {
  std::string name;
  std::size_t link = 0;
  TrackedMarker marker;
  Eigen::Vector3d start = Eigen::Vector3d::Zero();
};

/// A measured frame of one of the sets. linkFromFrame = reference * T(its placement in the state).
struct FrameInstance {
  std::string name;
  std::size_t link = 0;
  TrackedFrame frame;
  RigidTransform reference;
};

/// A place of one of the sets. `start`: where the search starts, in the world [m].
struct PlaceInstance {
  std::string name;
  ContactPlace place;
  Eigen::Vector3d start = Eigen::Vector3d::Zero();
};

/// Instruments of all sets and what they measure. Placements that the sets do not give are unknown.
struct InstrumentList {
  std::vector<TrackerInstance> trackers;
  std::vector<MarkerInstance> markers;
  std::vector<FrameInstance> frames;
  std::vector<PlaceInstance> places;
};

/// Index of the entry of this name, which exists.
template <typename Entry> std::size_t indexOf(const std::vector<Entry>& entries, const std::string& name) {
  std::size_t index = 0;
  while (entries[index].name != name) {
    ++index;
  }
  return index;
}

} // namespace naocal

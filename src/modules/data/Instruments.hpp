#pragma once

#include "data/Board.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// A measuring system outside the robot: laser tracker, motion capture, a camera that reports poses. Its readings are
/// in its own frame.
struct Tracker {
  std::string id;
  std::optional<double> sigma;         // of a point per axis, as its maker says [m]; absent: to be estimated
  std::optional<double> sigmaRotation; // of a frame per axis [rad]; absent: to be estimated
  std::optional<Placement> placement;  // worldFromTracker; absent: to be estimated
};

/// A point on a link that trackers measure, and that touches places.
struct TrackedMarker {
  std::string id, link;
  std::optional<Eigen::Vector3d> point;                 // known pointInLink [m]; absent: to be estimated
  Eigen::Vector3d pointGuess = Eigen::Vector3d::Zero(); // [m]
  double pointSigma = 0.1;                              // 1 sigma of the guess per axis [m]
};

/// A frame on a link that trackers measure in 6-D.
struct TrackedFrame {
  std::string id, link;
  std::optional<Placement> placement; // known linkFromFrame; absent: to be estimated
};

/// A point fixed in the world that markers are brought into contact with.
struct ContactPlace {
  std::string id;
  std::optional<Eigen::Vector3d> point; // known pointInWorld [m]; absent: to be estimated
};

/// A measured distance between two places.
struct PlaceDistance {
  std::array<std::string, 2> between;
  double metres = 0, sigma = 0; // [m]
};

/// What measures the robot besides cameras, and what it measures.
struct Instruments {
  std::vector<Tracker> trackers;
  std::vector<TrackedMarker> markers;
  std::vector<TrackedFrame> frames;
  std::vector<ContactPlace> places;
  std::vector<PlaceDistance> distances;
  std::optional<double> contactSigma; // of a contact per axis [m]; absent: to be estimated
};

/// A tracker's reading of a marker.
struct PointReading {
  std::string tracker, marker;
  Eigen::Vector3d xyz = Eigen::Vector3d::Zero(); // in the tracker's frame [m]
};

/// A tracker's reading of a frame: trackerFromFrame.
struct FrameReading {
  std::string tracker, frame;
  Eigen::Vector3d xyz = Eigen::Vector3d::Zero(); // [m]
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
};

/// A marker that is at a place.
struct ContactReading {
  std::string marker, place;
};

} // namespace naocal

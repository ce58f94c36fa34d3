#pragma once

#include "measurements/Measurements.hpp"

#include <functional>

namespace naocal {

/// What a kind of measurement makes its witnesses of: one capture, and everything that it may refer to.
struct WitnessSource {
  const CaptureSet& set;
  const Capture& capture;
  std::size_t stance = 0;
  const Eigen::VectorXd& recorded;                       // angle per joint of the robot, NaN where not recorded [rad]
  Measurements& measurements;                            // robot, layout and instruments; takes new noise levels
  std::function<std::string(const std::string&)> nameOf; // of an id within the set
  std::vector<WitnessObservation>& witnesses;

  /// Index of a noise level, added where it is new. `sigma`: as given; absent: to be estimated, from `start`.
  std::size_t level(const std::string& name, ReadingLevel::Unit unit, std::optional<double> sigma, double start);
  /// The chain from a link to the world. Throws InputError where a joint along it was not recorded.
  ObservationChain viewOf(std::size_t link, const std::string& what) const;
};

/// The kinds. Each adds its witnesses of the capture.
void addTrackerPoints(WitnessSource& source); // a marker's position in a tracker's frame
void addTrackerFrames(WitnessSource& source); // a frame's pose in a tracker's frame
void addContacts(WitnessSource& source);      // a marker that is at a place

/// All of them.
const std::vector<void (*)(WitnessSource&)>& witnessKinds();

/// Distances between places, which belong to no capture.
std::vector<WitnessObservation> makePlaceDistances(Measurements& measurements, const CaptureSet& set,
                                                   const std::function<std::string(const std::string&)>& nameOf);

} // namespace naocal

#pragma once

#include "measurements/FrameRegistry.hpp"
#include "measurements/Measurements.hpp"

#include <cstddef>
#include <vector>

namespace naocal {

/// Motors recorded in every capture, each by the index of one of its joints, in ascending order.
std::vector<std::size_t> recordedMotors(const std::vector<CaptureSet>& sets, const Robot& robot);

/// Measured angles [rad] per joint of the robot, or NaN. Joints of one motor follow it; where only another of its
/// joints was recorded, that joint's ratio tells the motor's.
Eigen::VectorXd measuredAngles(const Robot& robot, const CaptureSet& set, const Capture& capture);

/// Converts one capture to the robot's joints, cameras and targets. Requires robot, quantities, targets and stances in
/// `measurements`. Throws InputError for captures that do not fit the robot (unknown camera, no corners, required joint
/// not recorded).
ImageObservation makeImageObservation(std::size_t setIndex, std::size_t index, const Measurements& measurements,
                                      const FrameRegistry& places);

} // namespace naocal

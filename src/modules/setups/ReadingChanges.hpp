#pragma once

#include "measurements/Measurements.hpp"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace naocal {

/// Names of the joints whose angles matter to these captures.
std::vector<std::string> namesOfJoints(const Measurements& measurements);

/// Those that move in these captures: a joint that stands still may be off by any angle, whatever the mistake.
std::vector<std::string> namesOfMovingJoints(const Measurements& measurements);

/// Ids of the trackers of all sets, each once.
std::vector<std::string> trackerIds(const std::vector<CaptureSet>& sets);

/// Ids of the trackers that read frames.
std::vector<std::string> trackersOfFrames(const Measurements& measurements);

/// "a,b" of every two of these names; and the two of such a pair.
std::vector<std::string> listPairs(const std::vector<std::string>& names);
std::pair<std::string, std::string> splitPair(const std::string& pair);

/// Whether at most one joint lies between two on the way from one to the other: only such drives run through each
/// other.
bool areNearOnChain(const Robot& robot, const std::string& joint, const std::string& other);

/// Multiplies what a joint reads, its direction of motion by the sign alone.
void scaleJoint(std::vector<CaptureSet>& sets, const std::string& joint, double factor);

/// Adds an angle to all readings of a joint [rad].
void shiftJoint(std::vector<CaptureSet>& sets, const std::string& joint, double shift);

/// Adds `factor` times what `other` reads, and an angle [rad], to all readings of a joint. Its directions of motion
/// stay what they are.
void addOtherJoint(std::vector<CaptureSet>& sets, const std::string& joint, const std::string& other, double factor,
                   double shift);

/// Changes every reading of a tracker.
void changePoints(std::vector<CaptureSet>& sets, const std::string& tracker,
                  const std::function<void(Eigen::Vector3d&)>& change);
void changeFrames(std::vector<CaptureSet>& sets, const std::string& tracker,
                  const std::function<void(FrameReading&)>& change);

} // namespace naocal

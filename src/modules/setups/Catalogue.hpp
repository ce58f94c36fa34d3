#pragma once

#include "setups/SetUp.hpp"

#include <string>
#include <vector>

namespace naocal {

/// Names of set-ups that code elsewhere singles out.
namespace setUpName {
inline constexpr char reversedJoint[] = "reversedJoint";
inline constexpr char countSlip[] = "countSlip";
} // namespace setUpName

/// One function per mistake of the catalogue; each describes itself in its file in setups/catalogue/.
SetUp reversedJoint();
SetUp swappedJoints();
SetUp columnUnit();
SetUp squareSize();
SetUp cameraAxes();
SetUp mirroredTracker();
SetUp quaternionOrder();
SetUp inverseFrames();
SetUp countedFrom();
SetUp timeShift();
SetUp countSlip();
SetUp swappedCameras();
SetUp otherLink();

/// All mistakes, the most common first.
const std::vector<SetUp>& allSetUps();

} // namespace naocal

#include "setups/Catalogue.hpp"

namespace naocal {

const std::vector<SetUp>& allSetUps() {
  static const std::vector<SetUp> all{reversedJoint(), swappedJoints(),   columnUnit(),      squareSize(),
                                      cameraAxes(),    mirroredTracker(), quaternionOrder(), inverseFrames(),
                                      countedFrom(),   timeShift(),       countSlip(),       swappedCameras(),
                                      otherLink()};
  return all;
}

} // namespace naocal

#pragma once

#include "world/Pictures.hpp"
#include "writer/ProjectedProduct.hpp"
#include "writer/SessionPlanner.hpp"
#include "writer/SetFile.hpp"

namespace blind {

/// RMS error [px] of an ideal prediction that knows the robot with all its flaws and fits placements of boards and feet
/// by plain least squares (as a comparison does), but uses encoder readings with their errors and does not know
/// frictional deflections.
double noiseFloor(const Robot& robot, const Session& session, const ObservedCorners& seen);

/// Visibility of a change of the images to an observer who knows the noise but not the robot. Unknown are the offsets
/// of the joints in use, the camera rotations and the placements of all boards (except the first) and stances, with
/// prior information on offsets and cameras; derivatives are finite differences. Random are pixels, image shifts,
/// encoder error and stiction per approach, and stiction common to all approaches of a pose.
class Noncentrality : public ProjectedProduct {
public:
  Noncentrality(const Robot& robot, const Session& session, const NoiseRegime& noise);

  /// All corners of all sights in one vector.
  static Eigen::VectorXd stacked(const TruePictures& pictures, const Session& session);
};

} // namespace blind

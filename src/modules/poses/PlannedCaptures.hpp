#pragma once

#include "poses/PoseGenerator.hpp"
#include "poses/Surroundings.hpp"

#include <string>
#include <vector>

namespace naocal {

/// A pose to be taken next.
struct ProposedPose {
  PlannedPose pose;         // its sights: as the fitted model predicts them
  Eigen::VectorXd approach; // per joint: the motion that ends in the pose, -1 from above, +1 from below
};

/// The sets with captures of planned poses behind the last one's, as if they had been taken after it: the boards lie
/// where they lay, the robot stands anew on each foot; every camera takes one picture a pose, and joints read what they
/// were sent to. Corners' ids are those in sight, their pixels nothing: slopes do not depend on what was measured.
std::vector<CaptureSet> withPlanned(const std::vector<CaptureSet>& sets, const Robot& robot,
                                    const std::vector<ProposedPose>& poses);

/// What a camera sees, corners' pixels nothing.
std::vector<BoardCorners> seenBy(const std::string& camera, const std::vector<Sight>& sights);

/// The name of a planned pose's captures.
std::string plannedName(std::size_t pose);

/// The stance that poses on this foot get: numbers above those of all sets, the left foot's first.
int plannedStance(const std::vector<CaptureSet>& sets, SupportFoot foot);

/// Those poses in which the robot stands and sees a board when its joints are where the fitted model has them, not
/// where they were sent; their sights so.
std::vector<ProposedPose> feasibleByFit(const std::vector<CaptureSet>& sets, const Measurements& measurements,
                                        const Model& model, const Eigen::VectorXd& unknowns,
                                        const std::vector<Surroundings>& around, std::vector<ProposedPose> poses);

} // namespace naocal

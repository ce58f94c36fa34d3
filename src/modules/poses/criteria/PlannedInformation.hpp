#pragma once

#include "calibration/result/CalibrationResult.hpp"
#include "estimation/Model.hpp"
#include "estimation/Residuals.hpp"
#include "poses/candidates/PoseSampler.hpp"
#include "poses/criteria/Discrimination.hpp"

#include <random>
#include <string>
#include <vector>

namespace naocal {

/// Random approach per joint: -1 from above, +1 from below; equal for joints of one motor.
Eigen::VectorXd drawApproach(const Robot& robot, std::mt19937_64& random);

/// Whether an effect of the model depends on the approach.
bool dependsOnApproach(const Model& model);

/// The robot's last stance and the boards around it, from a fit; further poses are taken there.
struct LocalScene {
  SupportFoot supportFoot = SupportFoot::left;
  Placement sole;            // in the world of the fit
  std::vector<Board> boards; // on the floor and seen in the last set; placements in the sole's frame
};

/// One per foot used in the last set (for both feet, the left one); empty if no board lies on the floor.
std::vector<LocalScene> findLocalScenes(const FittedModel& fitted);

/// Appends captures of planned poses to the last set, as if taken after it: boards in place, a new stance on each foot,
/// one image per camera and pose, encoders equal to the commands. Corners have the ids of the visible ones and pixel
/// coordinates 0, since derivatives do not depend on the measured values.
std::vector<CaptureSet> appendPlannedCaptures(const std::vector<CaptureSet>& sets, const Robot& robot,
                                              const std::vector<ProposedPose>& poses);

/// A set's last capture, changed to a planned pose: what it reads at other than the joints stays. `angles`: what the
/// encoders read [rad].
Capture plannedCapture(const CaptureSet& set, const Robot& robot, const Eigen::VectorXd& angles,
                       const Eigen::VectorXd& approach);

/// Corners visible to a camera, with pixel coordinates 0.
std::vector<BoardCorners> cornersSeenBy(const std::string& camera, const std::vector<VisibleBoard>& sights);

/// Name of a planned pose's captures.
std::string plannedPoseName(std::size_t pose);

/// Stance id of planned poses on a foot: above those of all sets, the left foot's first.
int plannedStanceId(const std::vector<CaptureSet>& sets, SupportFoot foot);

/// Keeps poses in which the robot is balanced and sees a board at the joint angles predicted by the fitted model;
/// updates their sights accordingly.
std::vector<ProposedPose> filterFeasible(const FittedModel& fitted, const std::vector<LocalScene>& around,
                                         std::vector<ProposedPose> poses);

/// A pose's information about the unknowns it depends on, with joint deflections marginalised.
struct PoseInformation {
  std::vector<std::size_t> unknowns;
  Eigen::MatrixXd hessian;

  void addTo(Eigen::MatrixXd& sum) const;
};

/// `samples`: images taken without moving, hence with the same encoder errors.
PoseInformation marginalInformation(PoseSystem pose, const Noise& noise, double samples = 1);

/// Information about the unknowns, of existing captures and of planned poses.
struct PlannedInformation {
  Model own;                             // model of the question, for all captures; the suspects' unknowns follow
  Eigen::MatrixXd known;                 // priors plus captures
  std::vector<PoseInformation> promised; // per planned pose
};

/// Information of a measurement model linearised at `unknowns`, for measurements that hold captures and `planned` poses
/// (plannedPoseName). `samples`: images of each planned pose. Does not fill `own`. Throws InputError if a corner is
/// behind its camera there.
PlannedInformation linearizePlans(const Measurements& extended, const Model& model, const Noise& noise,
                                  const Eigen::VectorXd& unknowns, std::size_t planned, double samples = 1);

/// Information of the measurement model linearised at the fit, for captures and planned poses (appendPlannedCaptures);
/// the suspects' unknowns are zero. Throws InputError if the fit puts a corner behind the camera.
PlannedInformation predictInformation(const FittedModel& fitted, const ModelAmbiguity& question,
                                      const std::vector<LocalScene>& around, const std::vector<ProposedPose>& poses);

/// Mean number of images per pose and camera, rounded.
double samplesPerPose(const Measurements& measurements);

/// Appends the suspects' terms to the model. Throws InputError if a suspect cannot be placed in the captures.
Model addHypotheses(const Measurements& measurements, const Model& model, const ModelAmbiguity& question);

} // namespace naocal

#pragma once

#include "calibration/CalibrationResult.hpp"
#include "estimation/Model.hpp"
#include "estimation/Residuals.hpp"
#include "poses/candidates/PoseSampler.hpp"
#include "poses/criteria/Discrimination.hpp"

#include <random>
#include <string>
#include <vector>

namespace naocal {

/// Per joint the motion that ends in a pose, at random: -1 from above, +1 from below; as one for joints of one motor.
Eigen::VectorXd drawApproach(const Robot& robot, std::mt19937_64& random);

/// Whether an effect of the model depends on it.
bool dependsOnApproach(const Model& model);

/// Where a robot stood last and what lies around it, by a fit: where it would take further poses.
struct LocalScene {
  SupportFoot supportFoot = SupportFoot::left;
  Placement sole;            // in the fit's world
  std::vector<Board> boards; // on the floor, seen in the last set; placements in the sole's frame
};

/// One for each foot that the last set stands on (of both feet, the left one); none where no board lies on the floor.
std::vector<LocalScene> findLocalScenes(const FittedModel& fitted);

/// The sets with captures of planned poses behind the last one's, as if they had been taken after it: the boards lie
/// where they lay, the robot stands anew on each foot; every camera takes one picture a pose, and joints read what they
/// were sent to. Corners' ids are those in sight, their pixels nothing: slopes do not depend on what was measured.
std::vector<CaptureSet> appendPlannedCaptures(const std::vector<CaptureSet>& sets, const Robot& robot,
                                              const std::vector<ProposedPose>& poses);

/// What a camera sees, corners' pixels nothing.
std::vector<BoardCorners> cornersSeenBy(const std::string& camera, const std::vector<VisibleBoard>& sights);

/// The name of a planned pose's captures.
std::string plannedPoseName(std::size_t pose);

/// The stance that poses on this foot get: numbers above those of all sets, the left foot's first.
int plannedStanceId(const std::vector<CaptureSet>& sets, SupportFoot foot);

/// Those poses in which the robot stands and sees a board when its joints are where the fitted model has them, not
/// where they were sent; their sights so.
std::vector<ProposedPose> filterFeasible(const FittedModel& fitted, const std::vector<LocalScene>& around,
                                         std::vector<ProposedPose> poses);

/// A pose's information about the unknowns that it depends on, its joints' deflections eliminated.
struct PoseInformation {
  std::vector<std::size_t> unknowns;
  Eigen::MatrixXd hessian;

  void addTo(Eigen::MatrixXd& sum) const;
};

/// `samples`: pictures taken without moving, that is, with the same encoder errors.
PoseInformation marginalInformation(PoseSystem pose, const Noise& noise, double samples = 1);

/// What captures tell about the unknowns, and what planned ones would.
struct PlannedInformation {
  Model own;                             // the question's model for all of them; the suspects' unknowns come behind
  Eigen::MatrixXd known;                 // priors and captures
  std::vector<PoseInformation> promised; // per planned pose
};

/// The measurement model linearised at the fit, for captures and planned poses (appendPlannedCaptures); suspects
/// absent.
PlannedInformation predictInformation(const FittedModel& fitted, const ModelAmbiguity& question,
                                      const std::vector<LocalScene>& around, const std::vector<ProposedPose>& poses);

/// Pictures per pose and camera.
double samplesPerPose(const Measurements& measurements);

/// The model with the suspects behind its own unknowns.
Model addHypotheses(const Measurements& measurements, const Model& model, const ModelAmbiguity& question);

} // namespace naocal

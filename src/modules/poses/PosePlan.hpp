#pragma once

#include "poses/PlanOptimizer.hpp"
#include "poses/candidates/Transitions.hpp"
#include "poses/criteria/PlanOptions.hpp"
#include "poses/criteria/PlannedInformation.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// How far a board may be off its place, the others at theirs, before a pose sees no board any more or the worst
/// offset's sigma grows by a tenth.
struct BoardTolerance {
  double shift = 0; // in any of eight directions [m], at most 0.3
  double turn = 0;  // either way [rad], at most 45 degrees
};

/// Per board.
std::vector<BoardTolerance> computeBoardTolerances(const Robot& robot, const std::vector<Board>& boards,
                                                   const std::map<std::string, CameraIntrinsics>& cameras,
                                                   const PlanOptions& options, const std::vector<ValidPose>& poses);

/// What a criterion's selection of poses is worth.
struct CriterionResult {
  Criterion criterion = Criterion::worst;
  std::size_t poses = 0;
  double worst = 0,
         mean = 0;       // sigma of a joint's offset, cameras and boards unknown; mean: root of the mean square [rad]
  double worstKnown = 0; // the same with cameras and boards known [rad]
  Interaction interaction;
  std::optional<double> misfit; // by which they tell PlanOptions::effects apart (chi2)
};

/// Every criterion's (`discriminate` where there are effects to tell apart) selection of 3, 5 and 8 poses among the
/// same candidates, with the boards where they are; nothing is refined. Fewer where there are not as many candidates,
/// or the thesis's chain ends.
std::vector<CriterionResult> compareCriteria(const Robot& robot, const std::vector<Board>& boards,
                                             const std::map<std::string, CameraIntrinsics>& cameras,
                                             const PlanOptions& options, const std::vector<ValidPose>& candidates);

/// Poses to take, and where to lay the boards.
struct PosePlan {
  SupportFoot supportFoot = SupportFoot::left;
  PassCounts sieve;                            // of the candidates
  std::vector<ProposedPose> poses;             // in the order to take them
  std::vector<std::optional<Transition>> ways; // per pose: from the one before it; absent: the first, or none is safe
  std::vector<double> standing;                // per pose: the share of robots with joint errors that stand so
  std::vector<Board> boards;                   // placements in the support sole's frame
  std::vector<BoardTolerance> tolerances;      // per board
  std::size_t kept = 0;                        // of the poses, in front: taken besides, in an order of their own
  std::map<std::string, double> sigma, sigmaKnown; // per joint's offset; with cameras and boards known [rad]
  std::map<std::string, double> sigmaOfRobots;     // of robots with joint errors, root of the mean square [rad]
  Interaction interaction;                         // that the poses leave, by the thesis's measure
  std::optional<double> misfit;                    // by which the poses tell PlanOptions::effects apart (chi2)
  std::vector<CriterionResult> comparison;         // with PlanOptions::compare
  PlanOptions options;
};

/// Plans poses on one foot or both that tell the joint offsets of its leg or both and the head best: candidates are
/// sieved, the best are selected, then poses and boards are moved a little as long as that helps; again from the
/// boards' new places.
///
/// `boards`: with placements in the support sole's frame to begin with. Throws InputError when there are too few
/// candidates. `tell`: what is being done, for people.
PosePlan planPoses(const Robot& robot, std::vector<Board> boards,
                   const std::map<std::string, CameraIntrinsics>& cameras, const PlanOptions& options,
                   const std::function<void(const std::string&)>& tell = {});

} // namespace naocal

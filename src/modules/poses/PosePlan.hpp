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

/// Tolerance of a board's placement, the other boards in place: beyond it a pose sees no board, or the worst offset's
/// sigma grows by more than 10 %.
struct BoardTolerance {
  double shift = 0; // in each of eight directions [m], at most 0.3
  double turn = 0;  // in both directions [rad], at most 45 degrees
};

/// Quality of a criterion's selection of poses.
struct CriterionResult {
  Criterion criterion = Criterion::worst;
  std::size_t poses = 0;
  double worst = 0,
         mean = 0;       // sigma of the joint offsets, cameras and boards unknown; mean: root mean square [rad]
  double worstKnown = 0; // like `worst`, cameras and boards known [rad]
  Interaction interaction;
  std::optional<double> misfit; // of PlanOptions::effects (chi2)
};

/// Selections of 3, 5 and 8 poses by every criterion except `time` (`discriminate` only with effects) among the same
/// candidates, with fixed boards and without refinement. Fewer poses if there are fewer candidates, or if the thesis's
/// chain ends.
std::vector<CriterionResult> compareCriteria(const Robot& robot, const PlanInputs& inputs, const PlanOptions& options,
                                             const std::vector<ValidPose>& candidates);

/// Poses and board placements.
struct PosePlan {
  SupportFoot supportFoot = SupportFoot::left;
  PassCounts sieve;                            // of the candidates
  std::vector<ProposedPose> poses;             // in playing order
  std::vector<std::optional<Transition>> ways; // per pose: transition from the previous one; absent: first pose, or no
                                               // safe transition
  std::vector<double> standing;                // per pose: fraction of robots with joint errors that stay balanced
  std::vector<Board> boards;                   // placements in the support sole's frame
  std::vector<BoardTolerance> tolerances;      // per board
  std::size_t kept = 0;                        // number of leading poses that were kept, in their own order
  std::map<std::string, double> sigma, sigmaKnown; // per joint offset; with cameras and boards known [rad]
  std::map<std::string, double> sigmaOfRobots;     // rms over robots with joint errors [rad]
  Interaction interaction;                         // after these poses, by the thesis's measure
  std::optional<double> misfit;                    // misfit of the wrong one of PlanOptions::effects (chi2)
  std::vector<CriterionResult> comparison;         // with PlanOptions::compare
  PlanOptions options;
};

/// Plans poses, on one foot or both, that determine the joint offsets of the legs involved and the head best: filters
/// candidates, selects the best, then refines poses and boards alternately.
///
/// `inputs.boards`: initial placements. `tell`: receives progress messages for display. Throws
/// InputError if there are too few candidates.
PosePlan planPoses(const Robot& robot, PlanInputs inputs, const PlanOptions& options,
                   const std::function<void(const std::string&)>& tell = {});

} // namespace naocal

#pragma once

#include "poses/BoardTolerance.hpp"
#include "poses/CriteriaComparison.hpp"
#include "poses/PlannedCaptures.hpp"
#include "poses/PoseWays.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// Poses to take, and where to lay the boards.
struct PosePlan {
  SupportFoot supportFoot = SupportFoot::left;
  Sieve sieve;                              // of the candidates
  std::vector<ProposedPose> poses;          // in the order to take them
  std::vector<std::optional<PoseWay>> ways; // per pose: from the one before it; absent: the first, or none is safe
  std::vector<double> standing;             // per pose: the share of robots with joint errors that stand so
  std::vector<Board> boards;                // placements in the support sole's frame
  std::vector<BoardTolerance> tolerances;   // per board
  std::size_t kept = 0;                     // of the poses, in front: taken besides, in an order of their own
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
PosePlan posePlan(const Robot& robot, std::vector<Board> boards, const std::map<std::string, CameraIntrinsics>& cameras,
                  const PlanOptions& options, const std::function<void(const std::string&)>& tell = {});

} // namespace naocal

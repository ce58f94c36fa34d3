#pragma once

#include "data/Capture.hpp"
#include "math/Angles.hpp"
#include "measurements/Noise.hpp"
#include "poses/candidates/PoseOptions.hpp"
#include "poses/criteria/PoseCriterion.hpp"

#include <map>
#include <string>
#include <vector>

namespace naocal {

/// Boards and cameras to plan with.
struct PlanInputs {
  std::vector<Board> boards; // placements in the support sole's frame
  std::map<std::string, CameraIntrinsics> cameras;
};

/// Settings of pose planning.
struct PlanOptions {
  PoseOptions poses; // count: poses to select; maxAttempts: samples
  Criterion criterion = Criterion::worst;
  std::map<std::string, double> weights; // of joints and cameras in the thesis's criterion; default 1
  bool compare = false;                  // evaluates all criteria on the same candidates
  Noise noise;
  std::vector<std::string> effects; // two labels, for `discriminate`
  std::size_t perturbedRobots = 0;  // robots with joint errors included in the objective
  bool known = false;               // camera mounts and board placements are known
  bool moveBoards = true;           // optimises board placements
  bool mirrored = false;       // boards symmetric about the midline between the feet, for poses on both feet in turn
  double sigma = radians(0.2); // target of `time` [rad]
  double secondsPerPose = 1;   // rest and imaging [s]
  std::vector<Eigen::VectorXd> kept = {}; // angles of poses taken in addition [rad]
  double farthestBoard = 1.3;             // distance of a board's centre from the support sole [m]
  double gap = 0.02;                      // between boards, and between boards and feet [m]
  std::size_t maxCandidates = 2000;       // limit of candidates for selection, evenly spaced among those found
  std::size_t starts = 4;                 // initial selections that are refined; the best one continues
  std::size_t rounds = 3;                 // refinement rounds of poses and boards; the first applies to every start
  std::size_t refinements = 1000;         // attempts per pose and per board in a round
};

} // namespace naocal

#pragma once

#include "math/Angles.hpp"
#include "measurements/Noise.hpp"
#include "poses/candidates/PoseOptions.hpp"
#include "poses/criteria/PoseCriterion.hpp"

#include <map>
#include <string>
#include <vector>

namespace naocal {

/// What to plan poses and boards for.
struct PlanOptions {
  PoseOptions poses; // count: to select; tries: candidates
  Criterion criterion = Criterion::worst;
  std::map<std::string, double> weights; // of joints and cameras in the thesis's criterion, 1 where it has none
  bool compare = false;                  // all criteria on the same candidates
  Noise noise;
  std::vector<std::string> effects; // two labels, that `discriminate` tells apart
  std::size_t perturbedRobots = 0;  // with joint errors, for which poses and boards are judged besides
  bool known = false;               // cameras and boards: their places are not to be estimated
  bool moveBoards = true;           // else they lie where they are given
  bool mirrored = false;            // boards lie symmetrically to the middle between the feet, for both feet's poses
  double sigma = radians(0.2);      // that `time` must reach [rad]
  double secondsPerPose = 1;        // to come to rest and take pictures [s]
  std::vector<Eigen::VectorXd> kept = {}; // angles of poses that are taken besides [rad]
  double farthestBoard = 1.3;             // middle of a board from the support sole [m]
  double gap = 0.02;                      // between boards, and from the robot's feet [m]
  std::size_t maxCandidates = 2000;       // candidates at most that are selected from, evenly among those found
  std::size_t starts = 4;                 // plans that are begun in different ways and refined; the best goes on
  std::size_t rounds = 3;                 // of refining poses and boards twice, the first for every start
  std::size_t refinements = 1000;         // tries per pose and per board in a round
};

} // namespace naocal

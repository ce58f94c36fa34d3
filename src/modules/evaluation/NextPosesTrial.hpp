#pragma once

#include "data/Capture.hpp"
#include "robot/Robot.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

struct NextPosesTrialOptions {
  std::size_t start = 12;  // random stable poses before the first diagnosis
  std::size_t batch = 4;   // poses taken between two selections
  std::size_t most = 24;   // limit of further poses
  double flawScale = 0.15; // size of the hidden effect relative to a worn NAO's
  double certainty = 0.95; // required probability of one class member
};

/// Number of further poses until one class member is certain, and whether it is the hidden effect.
struct TrialArm {
  std::optional<std::size_t> poses; // absent: more than `most`
  bool right = false;
};

/// One simulated robot with a hidden effect, and the effects that its first captures cannot distinguish.
struct NextPosesTrial {
  std::uint64_t seed = 0;
  std::string hidden;                // "elasticity@LKneePitch"
  std::vector<std::string> suspects; // empty: nothing was open
  TrialArm proposed, random;
};

/// Diagnoses the first captures, then takes further poses: proposed ones and, separately, random stable ones; each
/// batch in a new stance with fixed boards. After each pose the class is weighed: probabilities proportional to
/// exp(evidence / 2), evidence = 2 ln of the Bayes factor, sum 1.
NextPosesTrial runNextPosesTrial(const Robot& robot, std::uint64_t seed, const NextPosesTrialOptions& options = {});

} // namespace naocal

#pragma once

#include "data/Capture.hpp"
#include "robot/Robot.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

struct NextPosesTrialOptions {
  std::size_t start = 12;  // random stable poses, before the first question
  std::size_t batch = 4;   // poses taken before the next question
  std::size_t most = 24;   // further poses, until it is given up
  double flawScale = 0.15; // of the hidden effect, against that of a worn NAO
  double certainty = 0.95; // of one member of the class
};

/// How many further poses it took until one member of the class was certain, and whether it is the hidden effect.
struct TrialArm {
  std::optional<std::size_t> poses; // absent: not with `most`
  bool right = false;
};

/// One simulated robot with a hidden effect, and what its first captures cannot tell apart.
struct NextPosesTrial {
  std::uint64_t seed = 0;
  std::string hidden;                // "elasticity@LKneePitch"
  std::vector<std::string> suspects; // fewer than two: nothing was open
  TrialArm proposed, random;
};

/// Asks what is open after the first captures, then takes further poses, proposed ones and, apart from them, random
/// stable ones; every batch in a stance of its own, the boards where they lie. After each pose the class is weighed:
/// exp(evidence / 2), evidence = 2 ln of the Bayes factor, all of the class's members together 1.
NextPosesTrial runNextPosesTrial(const Robot& robot, std::uint64_t seed, const NextPosesTrialOptions& options = {});

} // namespace naocal

#pragma once

#include "poses/criteria/PlannedInformation.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace naocal {

struct NextPosesOptions {
  std::size_t count = 4;        // poses to propose
  std::size_t candidates = 300; // stable candidate poses
  std::uint64_t seed = 1;
  double jointError = radians(1.5); // joint error tolerated by the poses; small, as offsets are known by then
                                    // (BalanceRequirement) [rad]
};

/// Poses that best resolve a ModelAmbiguity.
struct NextPoses {
  std::vector<ProposedPose> poses; // in playing order: random, so that drifts do not correlate with them
  std::string why;                 // ModelAmbiguity::why; empty: nothing is open
  std::string whyNone;             // reason, if no poses can be proposed; for display
  double growth = 1;               // growth of the suspects' misfits with these poses (Discrimination::growthFactor)
  std::map<std::string, double> predictedSigma; // of joint offsets, with these poses, 1 sigma [rad]

  // Assumptions.
  std::vector<LocalScene> around; // of a NAO; angles of other robots are what their encoders read
  std::size_t stable = 0;         // stable poses of the drawn robot
  std::size_t seeing = 0;         // those of them in which the fitted robot is balanced and is measured
  Noise noise;                    // estimated by the fit
  double samples = 1;             // images per pose and camera, as in the captures
  int firstStance = 0;            // stance id of the poses
  double jointError = 0;          // joint error tolerated in the poses and on the ways to them [rad]
};

/// Selects greedily among planned poses: each maximises Discrimination::expectedGain given the captures and the
/// previous poses. Fills `poses`, in random order, `growth` and `predictedSigma`. `isReachable` is asked for the best
/// ones only.
void selectNextPoses(const ModelAmbiguity& question, const PlannedInformation& information,
                     const std::vector<ProposedPose>& planned,
                     const std::function<bool(const ProposedPose&)>& isReachable, const NextPosesOptions& options,
                     NextPoses& result);

/// Selects among stable poses in sight of the boards (PoseSampler), on the captures' support feet; where the approach
/// matters, from above and from below (selectNextPoses). The measurement model is linearised at the fit, with the fit's
/// noise. Reproducible by seed.
NextPoses proposeNextPoses(const FittedModel& fitted, const ModelAmbiguity& question,
                           const NextPosesOptions& options = {});

/// Whether they are worth taking: "With them the evidence for or against becomes 2.1 times stronger." Below
/// `worthTaking` it says that they hardly help.
std::string whatTheyTell(const NextPoses& next);

/// Growth of the evidence below which poses hardly help: a prediction of the growth is true to 15 % (tests).
inline constexpr double worthTaking = 1.15;

/// What a person does with them: "Leave the boards where they lie, record the poses as a new set with ..".
std::string howToTake(const NextPoses& next);

} // namespace naocal

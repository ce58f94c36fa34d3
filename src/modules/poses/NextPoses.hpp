#pragma once

#include "poses/criteria/PlannedInformation.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace naocal {

struct NextPosesOptions {
  std::size_t count = 4;        // poses to propose
  std::size_t candidates = 300; // stable attitudes to choose from
  std::uint64_t seed = 1;
  double jointError = radians(1.5); // of robots that will take them, whose offsets are known by then (Stability) [rad]
};

/// Poses that would best answer what captures leave open.
struct NextPoses {
  std::vector<ProposedPose> poses; // in the order to take them: drawn at random, so that nothing drifts with them
  std::string why;                 // as the question's; empty: nothing is open
  std::string whyNone;             // in words, where poses were asked for and there are none to propose
  double growth = 1;               // of what tells the suspects apart, with these poses (Discrimination)
  std::map<std::string, double> predictedSigma; // of joint offsets, with these poses [rad]

  // What that assumes.
  std::vector<LocalScene> around;
  std::size_t stable = 0; // attitudes of the drawn robot
  std::size_t seeing = 0; // those that stand and see a board by the fit, to choose from
  Noise noise;            // of the fit
  double samples = 1;     // per pose and camera, as in the captures
  int firstStance = 0;    // that they are taken in
  double jointError = 0;  // of robots that stand in them and reach them [rad]
};

/// Chooses among stable poses in sight of the boards (PoseGenerator), on the captures' feet, each approached from above
/// and from below where that matters: greedily the one with the largest Discrimination::gain beside the captures and
/// those before it. The measurement model is linearised at the fit, noise as there. The same seed proposes the same.
NextPoses proposeNextPoses(const FittedModel& fitted, const ModelAmbiguity& question,
                           const NextPosesOptions& options = {});

/// After a diagnosis: of its last model and what it leaves open.
NextPoses proposeNextPoses(const Measurements& measurements, const Diagnosis& diagnosis, const DiagnosisOptions& asked,
                           const NextPosesOptions& options = {});

} // namespace naocal

#pragma once

#include "poses/criteria/PlannedInformation.hpp"
#include "poses/criteria/PoseCriterion.hpp"

#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// Candidate poses of any robot, as the captures that would be taken in them.
struct CandidateCaptures {
  CaptureSet set;                       // captures of pose i are named by plannedPoseName(i); readings without noise
  std::vector<ProposedPose> poses = {}; // angles: what the encoders read [rad]
  bool isOnSole = false;                // else its base stands
  std::vector<Board> boards = {};       // of a robot on its sole: those on the floor, placed as seen from the sole
  PassCounts sieve = {};
  Noise noise; // assumed of the captures
};

/// Settings of a plan among candidates.
struct CapturePlanOptions {
  std::size_t count = 8;                  // poses to select
  Criterion criterion = Criterion::worst; // D, A, E or worst
  std::vector<std::string> effects;       // told besides the base model: "elasticity@elbow"
};

/// What planned poses tell of one unknown.
struct PlannedSigma {
  std::string name;            // of an offset its joint's, else "elasticity@elbow c"
  std::string unit;            // SI
  double sigma = 0;            // 1 sigma
  std::optional<double> known; // the same with cameras, and where everything stands, known; absent: of a camera itself
};

/// An unknown that no candidate tells, or an offset that nothing depends on.
struct UntoldUnknown {
  std::string name, why; // "cannot be told from where tracker laser stands"
};

/// Poses that were selected among candidates.
struct CapturePlan {
  PassCounts sieve;
  std::vector<ProposedPose> poses;
  std::vector<PlannedSigma> offsets, mounts, effects; // of joints, of cameras on links, and of the options' effects
  std::vector<UntoldUnknown> untold;
  std::vector<std::string> estimated; // what is estimated along: "boardPlacement@plate"
  bool isOnSole = false;              // as of the candidates; boards too
  std::vector<Board> boards;
  CapturePlanOptions options;
  Noise noise;
};

/// Selects the poses that tell joint offsets, the mounts of cameras on links and the options' effects best; everything
/// whose place the set does not give is estimated along. Information is that of `solve`: the candidates' captures are
/// its measurements, linearised where it fits them (linearizePlans). Unknowns that all candidates together leave with
/// more than a quarter of their plausible size are no targets but listed. Lengths and effects count by their plausible
/// sizes: as much of them as of an offset's.
///
/// Throws InputError if there are fewer candidates than `count`, for unknown effects, for effects that the candidates
/// cannot tell, and for criteria of NAOs.
CapturePlan planCaptures(const CandidateCaptures& candidates, const CapturePlanOptions& options);

} // namespace naocal

#include "RobotV6.hpp"
#include "evaluation/NextPosesTrial.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

namespace naocal {

TEST_CASE("proposed poses tell the hidden effect from its twins sooner than random ones", "[slow]") {
  // Proves that trials finish, and that proposed poses need fewer poses in total, on the first three robots with
  // several suspects. Three robots are no statistics: `naocal evaluate next` measures the median over many.
  const NextPosesTrialOptions options;
  std::size_t open = 0, proposed = 0, random = 0, right = 0;
  for (std::uint64_t seed = 1; open < 3; ++seed) {
    REQUIRE(seed < 60);
    const NextPosesTrial trial = runNextPosesTrial(v6(), seed, options);
    if (trial.suspects.size() < 2) {
      continue;
    }
    ++open;
    CHECK(std::count(trial.suspects.begin(), trial.suspects.end(), trial.hidden) <= 1);
    proposed += trial.proposed.poses.value_or(options.most);
    random += trial.random.poses.value_or(options.most);
    right += trial.proposed.right;
  }
  CHECK(proposed < random);
  CHECK(right >= 2);
}

TEST_CASE("a robot whose effect is plain leaves nothing to tell apart", "[slow]") {
  // Proves that a robot without open suspects counts for neither method: its hidden effect has the size of a worn
  // NAO's.
  NextPosesTrialOptions options;
  options.flawScale = 1;
  const NextPosesTrial trial = runNextPosesTrial(v6(), 3, options);
  CHECK(trial.suspects.empty());
  CHECK_FALSE(trial.proposed.poses);
  CHECK_FALSE(trial.random.poses);
}

} // namespace naocal

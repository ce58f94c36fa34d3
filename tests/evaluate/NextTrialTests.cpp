#include "RobotV6.hpp"
#include "evaluate/NextTrial.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

namespace naocal {

TEST_CASE("proposed poses tell the hidden effect from its twins sooner than random ones") {
  // Proves that a trial runs to its end, names the truth both ways, and is won on one robot whose first captures leave
  // several effects open. One robot proves no median: `naocal evaluate next` measures it over many.
  const NextTrial trial = nextTrial(v6(), 9);
  CHECK(trial.hidden == "elasticity@LKneePitch");
  REQUIRE(trial.suspects.size() >= 2);
  CHECK(std::count(trial.suspects.begin(), trial.suspects.end(), trial.hidden) == 1);
  REQUIRE(trial.proposed.poses.has_value());
  CHECK(trial.proposed.right);
  CHECK((!trial.random.poses || *trial.proposed.poses < *trial.random.poses));
}

TEST_CASE("a robot whose effect is plain leaves nothing to tell apart") {
  // Proves that such a robot counts for neither way: its hidden effect is as large as a worn NAO's.
  NextTrialOptions options;
  options.flawScale = 1;
  const NextTrial trial = nextTrial(v6(), 2, options);
  CHECK(trial.suspects.empty());
  CHECK_FALSE(trial.proposed.poses);
  CHECK_FALSE(trial.random.poses);
}

} // namespace naocal

#include "diagnosis/Questioned.hpp"
#include "inference/PoseMisfit.hpp"

#include <catch2/catch.hpp>
#include <utility>

namespace naocal {

TEST_CASE("poses of a robot that lacks nothing miss its model by as much as their freedom says", "[slow]") {
  // Proves that chi2 / freedom has mean 1 where model and noise are right, also with few poses, whose unknowns absorb
  // most of the information; at the simulated noise, for twelve robots with 8 poses and six with 16. The mean of twelve
  // ratios has a standard deviation of 0.07 with 8 poses.
  for (const auto& [poses, robots] : {std::pair{8, 12}, std::pair{16, 6}}) {
    double mean = 0;
    for (int seed = 1; seed <= robots; ++seed) {
      const Questioned asked{simulatedSet(static_cast<std::size_t>(poses), static_cast<std::uint64_t>(seed)), false};
      const PoseMisfit misfit = testPoseMisfit(asked.candidateTests.problem(), asked.fit.noise);
      mean += misfit.chi2 / misfit.freedom / robots;
    }
    INFO(poses << " poses: " << mean);
    CHECK(mean == Approx(1).margin(0.15));
  }
}

} // namespace naocal

#include "V6Twin.hpp"

#include <catch2/catch.hpp>

namespace naocal {

TEST_CASE("a V6 calibrates neck and cameras over LoLA's socket and V4L2") {
  // Proves that drivers, threads and calibration work together at the robot's own pace: bytes on a UNIX socket as a V6
  // sends them, pictures in V4L2's buffers with the kernel's stamps, everything else as shipped.
  SimulatedPlan plan = simulatedPlan(1);
  plan.offsetRange = radians(1);
  V6Process v6{plan};
  const auto began = Clock::now();
  const auto state = v6.calibrated("head");
  INFO(state.dump());
  REQUIRE(state["phase"] == "finished");
  CHECK(state["errorAfter"] < 0.3 * state["errorBefore"].get<double>());
  CHECK(v6.saved("simulated/head/P0000074A05S93M00061/Projection.json").size() == 2);
  WARN(v6.twin.commands << " commands in " << seconds(Clock::now() - began) << " s");
}

} // namespace naocal

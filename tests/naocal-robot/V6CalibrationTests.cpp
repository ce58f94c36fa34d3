#include "LegCalibrationTruth.hpp"
#include "V6Twin.hpp"

#include "dialects/SavedCalibration.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>

namespace naocal {

TEST_CASE("a V6 calibrates neck and cameras over LoLA's socket and V4L2", "[robot]") {
  // Proves that drivers, threads and calibration work together: states on a UNIX socket in a V6's format, pictures in
  // V4L2 buffers with their time stamps, everything else as shipped. The robot's clock is simulated, so the machine's
  // load has no influence; PaceMeasurements.cpp measures real time.
  SimulatedPlan plan = simulatedPlan(1);
  plan.pace = Pace::quick;
  plan.offsetRange = radians(1);
  V6Process v6{plan};
  const auto state = v6.calibrated("head");
  INFO(state.dump());
  REQUIRE(state["phase"] == "finished");
  CHECK(state["errorAfter"] < 0.3 * state["errorBefore"].get<double>());
  CHECK(v6.saved("simulated/head/P0000074A05S93M00061/Projection.json").size() == 2);
  CHECK(v6.twin.commands > 0.9 * v6.twin.states);
  const std::filesystem::path recording = v6.recording().parent_path();
  CHECK(DrivenProcess::replayed(recording, v6.folder.path() / "again")
            .find("estimates are the recorded ones, bit for bit.") != std::string::npos);
}

// The same measurement for a leg (1.5 minutes), with gear play; proves nothing.
TEST_CASE("how well a V6 calibrates a leg over LoLA's socket and V4L2", "[.measure]") {
  SimulatedPlan plan = simulatedPlan(1);
  plan.playRange = radians(0.5);
  V6Process v6{plan};
  const auto began = Clock::now();
  const auto state = v6.calibrated("left leg");
  const LegCalibrationTruth truth{v6.drawing, v6.twin.world.errors(), plan.servos};
  WARN(state["phase"] << ": " << state["sentence"] << "\nfloor point at 2 m: from "
                      << 100 * truth.floorError(SupportFoot::left, {}) << " to "
                      << 100 *
                             truth.floorError(SupportFoot::left, readConfiguredCalibration(v6.process->configuration()))
                      << " cm, " << toSeconds(Clock::now() - began) << " s, " << v6.twin.commands << " commands to "
                      << v6.twin.states << " states; "
                      << DrivenProcess::replayed(v6.recording().parent_path(), v6.folder.path() / "again"));
}

// Tool, proves nothing: a simulated V6 at /tmp/robocup for SECONDS, to try programs on this computer as on a robot.
TEST_CASE("a V6 stands here", "[.twin]") {
  const char* wanted = std::getenv("SECONDS");
  const Robot drawing = loadRobot(configurationDirectory(), "V6");
  const V6Twin twin{drawing, simulatedPlan(1), "/tmp/robocup"};
  std::this_thread::sleep_for(std::chrono::seconds{wanted ? std::atoi(wanted) : 60});
  WARN(twin.states << " states, " << twin.commands << " commands");
}

} // namespace naocal

#include "detect/BoardDetector.hpp"
#include "io/GreyImage.hpp"
#include "simulation/SimulatedPictures.hpp"
#include "simulation/StandingPoses.hpp"

#include "TemporaryFolder.hpp"
#include "simulation/CornersByName.hpp"
#include "simulation/HandMadePoses.hpp"

#include <catch2/catch.hpp>

using namespace naocal;

TEST_CASE("corners found in the rendered pictures are those that the simulation would have given", "[slow]") {
  // Proves that pictures and corners show the same scene: the same boards, positions to 0.25 px, and that the simulated
  // detector finds about what the real one does (each finds 80 % of the other's corners). The detector's accuracy is
  // tested in detect.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  SimulationPlan plan;
  plan.poses = planStandingPoses(robot, plan, SupportFoot::left, 12, 1);
  plan.samples = 1;
  plan.corners.pixel = 0;
  const Simulation corners = simulate(robot, plan, 1);
  plan.images = true;
  const Simulation pictures = simulate(robot, plan, 1);
  const TemporaryFolder folder;
  REQUIRE(renderPictures(picturesOf(pictures), {}, 1, folder.path(), 2, [](std::size_t) { return true; }) == 24);
  std::size_t found = 0, given = 0, common = 0;
  for (std::size_t i = 0; i < pictures.set.captures.size(); ++i) {
    const Capture& capture = pictures.set.captures[i];
    REQUIRE_FALSE(capture.corners);
    const Detection detection = detectBoards(readImage(folder.path() / capture.image), pictures.set.boards,
                                             pictures.set.cameras.at(capture.camera));
    const auto detected = byName(detection.boards), expected = byName(*corners.set.captures[i].corners);
    found += detected.size();
    given += expected.size();
    for (const auto& [name, uv] : detected) {
      if (expected.count(name) == 1) {
        ++common;
        CHECK((uv - expected.at(name)).norm() < 0.25);
      }
    }
  }
  CAPTURE(found, given, common);
  CHECK(5 * common > 4 * found);
  CHECK(5 * common > 4 * given);
}

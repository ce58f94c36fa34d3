#include "detect/BoardDetector.hpp"
#include "io/GreyImage.hpp"
#include "io/InputError.hpp"
#include "scenes/SceneSimulation.hpp"
#include "simulation/SimulatedPictures.hpp"

#include "TemporaryFolder.hpp"
#include "simulation/CornersByName.hpp"

#include <catch2/catch.hpp>

using namespace naocal;

namespace {

RobotScene k1BeforeBoards() {
  RobotScene scene = makeDefaultScene(makeRobotOnly("K1", SupportFoot::left), 1);
  scene.noise.pixel = 0;
  return scene;
}

ScenePlan pictures(std::vector<std::string> flaws) {
  return {.poses = 5, .samples = 1, .offsetRange = 0.05, .mountRange = 0.02, .flaws = std::move(flaws), .images = true};
}

std::string refusal(const RobotScene& scene, const std::string& flaw) {
  try {
    (void)simulateScene(scene, pictures({flaw}));
  } catch (const InputError& error) {
    return error.what();
  }
  return "not refused";
}

} // namespace

TEST_CASE("pictures of a robot with a hidden flaw show the corners that the simulation would have given") {
  // Proves to 0.3 px, on a K1 whose shank is 20 mm longer and whose lens is off, that a picture has what its corners
  // would have had, and that the same poses are taken; the renderer projects by itself.
  const RobotScene scene = k1BeforeBoards();
  ScenePlan plan = pictures({"linkLength@shank", "focalLength@left"});
  plan.flawScale = 5;
  const SceneSimulation rendered = simulateScene(scene, plan);
  plan.images = false;
  const SceneSimulation given = simulateScene(scene, plan);
  REQUIRE(rendered.set.captures.size() == given.set.captures.size());
  REQUIRE(rendered.scenes.size() == given.set.captures.size());
  const TemporaryFolder folder;
  const PictureSource source{rendered.set, rendered.lenses, [&](std::size_t i) { return rendered.scenes[i]; }};
  renderPictures(source, {}, 1, folder.path(), 2, [](std::size_t) { return true; });
  std::size_t common = 0, expectedInAll = 0;
  for (std::size_t i = 0; i < rendered.set.captures.size(); ++i) {
    const Capture& capture = rendered.set.captures[i];
    REQUIRE_FALSE(capture.corners);
    const Detection detection = detectBoards(readImage(folder.path() / capture.image), rendered.set.boards,
                                             rendered.set.cameras.at(capture.camera));
    const auto expected = byName(*given.set.captures[i].corners);
    expectedInAll += expected.size();
    for (const auto& [name, uv] : byName(detection.boards)) {
      if (expected.count(name) == 1) {
        ++common;
        CHECK((uv - expected.at(name)).norm() < 0.3);
      }
    }
  }
  CAPTURE(common, expectedInAll);
  CHECK(5 * common > 4 * expectedInAll);
}

TEST_CASE("what pictures cannot show is refused") {
  RobotScene scene = k1BeforeBoards();
  const std::string board = scene.set.boards.front().id;
  CHECK_THAT(refusal(scene, "boardBow@" + board), Catch::Contains("is not rendered"));
  CHECK_THAT(refusal(scene, "boardScale@" + board), Catch::Contains("true to size"));
  scene.set.boards.front().pattern.reset();
  CHECK_THAT(refusal(scene, "elasticity@Head_pitch"), Catch::Contains("expected a ChArUco board"));
  scene.set.cameras.clear();
  scene.set.instruments.trackers.push_back({.id = "laser", .placement = Placement{2, 0, 1, 0, 0, 3}});
  scene.set.instruments.markers.push_back({.id = "ball", .link = "Head_2", .point = Eigen::Vector3d{0.1, 0, 0}});
  CHECK_THAT(refusal(scene, "elasticity@Head_pitch"), Catch::Contains("found none; simulate without --images"));
}

#include "Scenes.hpp"

#include <catch2/catch.hpp>
#include <random>

namespace naocal {

// Proves that boards of one dictionary are identified by their marker ids, at both image sizes, and that an absent
// board is not reported.
TEST_CASE("several boards in one picture are each found under their own name") {
  for (const int width : {640, 1280}) {
    CharucoPattern patternA, patternB, patternC;
    patternB.firstMarkerId = 17;
    patternC.firstMarkerId = 34;
    RenderedBoard a = boardOnFloor(patternA, 1, 10, 0, -0.33), b = boardOnFloor(patternB, 1, -20, 0, 0.33);
    b.id = std::string{"B"};
    const CameraIntrinsics camera = plainCamera(width);
    const Detection detection =
        detectBoards(Renderer{camera}.render({{a, b}, {}}, {}, 1),
                     {described("A", patternA), described("C", patternC), described("B", patternB)}, camera);
    REQUIRE(detection.boards.size() == 2);
    CHECK(detection.boards[0].board == "A");
    CHECK(detection.boards[1].board == "B");
    CHECK(detection.boards[0].ids == trueCorners(a, camera).ids);
    CHECK(largest(errors(detection.boards[0], trueCorners(a, camera))) < 0.2);
    CHECK(largest(errors(detection.boards[1], trueCorners(b, camera))) < 0.2);
  }
}

// Proves that hidden corners are listed as issues, and that no corner is invented or shifted by the cover's edge.
TEST_CASE("a partly hidden board gives the corners that can be seen and names the others") {
  const RenderedBoard board = boardOnFloor({}, 0.8, 15);
  const CameraIntrinsics camera = plainCamera();
  const BoardCorners truth = trueCorners(board, camera);
  for (const double brightness : {0., 0.5, 1.}) {
    const Patch cover = patchOn(board, 0.15, -0.2, {0.2, 0.5}, brightness); // hides corner columns 0 to 2
    const Detection detection =
        detectBoards(Renderer{camera}.render({{board}, {cover}}, {}, 1), {described("A", board.pattern)}, camera);
    REQUIRE(detection.boards.size() == 1);
    const BoardCorners& found = detection.boards[0];
    CHECK(largest(errors(found, truth)) < 0.2);
    for (const int id : truth.ids) {
      const bool hidden = id % 6 < 3;
      CHECK((std::find(found.ids.begin(), found.ids.end(), id) == found.ids.end()) == hidden);
      CHECK((findingAbout(detection, id) != nullptr) == hidden);
    }
  }
}

// Proves that a corner-like crossing 4 mm off is rejected by geometry and reported with its position.
TEST_CASE("a false corner is reported and not taken") {
  const RenderedBoard board = boardOnFloor({}, 0.7, 10);
  const double s = board.pattern.squareLength, shift = 0.004;
  const int id = 6 * 2 + 3; // column 3, row 2
  const double x = 4 * s + shift, y = -3 * s + shift;
  // Four small squares around the shifted crossing: black if (column + row) is even.
  const Eigen::Vector2d size{0.03, 0.03};
  std::vector<Patch> fake;
  for (const int right : {0, 1}) {
    for (const int up : {0, 1}) {
      const bool black = (3 + right + 2 + (1 - up)) % 2 == 0;
      fake.push_back(patchOn(board, x + (right - 0.5) * size.x(), y + (up - 0.5) * size.y(), size, black ? 0 : 1));
    }
  }
  const CameraIntrinsics camera = plainCamera();
  const Detection detection =
      detectBoards(Renderer{camera}.render({{board}, fake}, {}, 1), {described("A", board.pattern)}, camera);
  REQUIRE(detection.boards.size() == 1);
  CHECK(detection.boards[0].ids.size() == 23);
  CHECK(largest(errors(detection.boards[0], trueCorners(board, camera))) < 0.2);
  const DetectionIssue* finding = findingAbout(detection, id);
  REQUIRE(finding != nullptr);
  CHECK(finding->kind == IssueKind::falseCorner);
  const auto fakePlace = projectOptical(board.cameraOpticalFromBoard * Eigen::Vector3d{x, y, 0}, camera);
  CHECK((*finding->place - *fakePlace).norm() < 0.3);
}

// Proves that a dark square patch on a corner does not shift it: the corner is reported instead. Other sizes are not
// covered.
TEST_CASE("a dark thing on a corner takes that corner away and no other") {
  const RenderedBoard board = boardOnFloor({}, 0.7, 10);
  const double s = board.pattern.squareLength;
  const Patch blob = patchOn(board, 3 * s + 0.006, -2 * s - 0.003, {0.02, 0.02}, 0.1);
  const CameraIntrinsics camera = plainCamera();
  const Detection detection =
      detectBoards(Renderer{camera}.render({{board}, {blob}}, {}, 1), {described("A", board.pattern)}, camera);
  REQUIRE(detection.boards.size() == 1);
  CHECK(detection.boards[0].ids.size() == 23);
  CHECK(largest(errors(detection.boards[0], trueCorners(board, camera))) < 0.2);
  CHECK(findingAbout(detection, 6 * 1 + 2) != nullptr);
}

// Proves that edges of objects next to corners shift no accepted corner by 0.5 px or more: six objects on each board.
// Smaller shifts may pass.
TEST_CASE("things lying about on a board do not draw its corners aside") {
  const CameraIntrinsics camera = plainCamera();
  std::mt19937 random{1};
  std::uniform_real_distribution<double> unit{-1, 1};
  std::size_t found = 0;
  for (int frame = 0; frame < 15; ++frame) {
    const RenderedBoard board = boardOnFloor({}, 0.7 + 0.04 * frame, 40 * unit(random));
    std::vector<Patch> things;
    for (int i = 0; i < 6; ++i) {
      const double s = board.pattern.squareLength, x = (3.5 + 2.9 * unit(random)) * s,
                   y = -(2.5 + 1.9 * unit(random)) * s;
      things.push_back(
          patchOn(board, x, y, {0.02 + 0.015 * unit(random), 0.02 + 0.015 * unit(random)}, 0.5 + 0.5 * unit(random)));
      things.back().cameraOpticalFromPatch.rotation *= rotationZ(3 * unit(random));
    }
    const Detection detection = detectBoards(Renderer{camera}.render({{board}, things}, {}, std::uint64_t(frame)),
                                             {described("A", board.pattern)}, camera);
    REQUIRE(detection.boards.size() == 1);
    found += detection.boards[0].ids.size();
    CHECK(largest(errors(detection.boards[0], trueCorners(board, camera))) < 0.5);
  }
  CHECK(found > 15 * 24 * 3 / 4);
}

// Proves that the two patterns for even row counts are distinguished in both directions, at two distances and partly
// hidden, and that the correct description is measured accurately.
TEST_CASE("a board in the other pattern is named and not measured") {
  const CameraIntrinsics camera = plainCamera();
  for (const bool legacy : {false, true}) {
    CharucoPattern printed;
    printed.squaresX = 6;
    printed.squaresY = 4;
    printed.legacyPattern = legacy;
    CharucoPattern stated = printed;
    stated.legacyPattern = !legacy;
    for (const double distance : {0.6, 1.2}) {
      const RenderedBoard board = boardOnFloor(printed, distance, 20);
      const Patch cover = patchOn(board, 0.4, -0.16, {0.2, 0.4}, 0.5);
      for (const std::vector<Patch>& patches : {std::vector<Patch>{}, std::vector<Patch>{cover}}) {
        const GreyPicture picture = Renderer{camera}.render({{board}, patches}, {}, 1);
        const Detection wrong = detectBoards(picture, {described("A", stated)}, camera);
        CHECK(wrong.boards.empty());
        REQUIRE(wrong.findings.size() == 1);
        CHECK(wrong.findings[0].kind == IssueKind::wrongPattern);
        CHECK_THAT(wrong.findings[0].sentence, Catch::Contains(legacy ? "legacy" : "current"));
        const Detection right = detectBoards(picture, {described("A", printed)}, camera);
        REQUIRE(right.boards.size() == 1);
        CHECK(right.boards[0].ids.size() >= (patches.empty() ? 15 : 6));
        CHECK(largest(errors(right.boards[0], trueCorners(board, camera))) < 0.3);
      }
    }
  }
}

// Proves that with an odd number of columns, where the other layout fits nearly all markers one column aside, the
// layout that fits all of them is found, from any side.
TEST_CASE("the layout of a board with even rows and odd columns is not confused") {
  const CameraIntrinsics camera = plainCamera(1280);
  for (const bool legacy : {false, true}) {
    CharucoPattern printed;
    printed.squaresX = 9;
    printed.squaresY = 6;
    printed.squareLength = 0.05;
    printed.markerLength = 0.037;
    printed.legacyPattern = legacy;
    CharucoPattern stated = printed;
    stated.legacyPattern = !legacy;
    for (int view = 0; view < 12; ++view) {
      CAPTURE(legacy, view);
      const RenderedBoard board = boardOnFloor(printed, 0.6, 30. * view);
      const GreyPicture picture = Renderer{camera}.render({{board}, {}}, {}, std::uint64_t(view));
      CHECK(contains(detectBoards(picture, {described("A", stated)}, camera), IssueKind::wrongPattern));
      const Detection right = detectBoards(picture, {described("A", printed)}, camera);
      REQUIRE(right.boards.size() == 1);
      CHECK(right.boards[0].ids.size() == 40);
    }
  }
}

// Proves that for odd row counts, where both patterns are identical, the `legacyPattern` flag has no effect.
TEST_CASE("a board with an odd number of rows has only one pattern") {
  CharucoPattern stated;
  stated.legacyPattern = true;
  const CameraIntrinsics camera = plainCamera();
  const RenderedBoard board = boardOnFloor({}, 0.7, 0);
  const Detection detection =
      detectBoards(Renderer{camera}.render({{board}, {}}, {}, 1), {described("A", stated)}, camera);
  REQUIRE(detection.boards.size() == 1);
  CHECK(detection.findings.empty());
}

// Proves that a description with a different number of columns is rejected.
TEST_CASE("a board that is printed otherwise than described gives no corners and says so") {
  CharucoPattern stated;
  stated.squaresX = 6;
  const CameraIntrinsics camera = plainCamera();
  const RenderedBoard board = boardOnFloor({}, 0.7, 0);
  const Detection detection =
      detectBoards(Renderer{camera}.render({{board}, {}}, {}, 1), {described("A", stated)}, camera);
  CHECK(detection.boards.empty());
  CHECK(contains(detection, IssueKind::otherBoard));
}

// Proves three simple cases: no board, an unlisted board, a wrong image size.
TEST_CASE("an empty picture, a stranger's board and a wrong size are each said plainly") {
  const CameraIntrinsics camera = plainCamera();
  const Renderer renderer{camera};
  const Detection empty = detectBoards(renderer.render({}, {}, 1), {described("A", {})}, camera);
  CHECK(empty.boards.empty());
  CHECK(empty.findings.empty());

  CharucoPattern stranger;
  stranger.firstMarkerId = 50;
  const GreyPicture picture = renderer.render({{boardOnFloor(stranger, 0.7, 0)}, {}}, {}, 1);
  const Detection unknown = detectBoards(picture, {described("A", {})}, camera);
  CHECK(unknown.boards.empty());
  CHECK(contains(unknown, IssueKind::unknownMarkers));

  const Detection wrongSize = detectBoards(picture, {described("A", stranger)}, plainCamera(1280));
  CHECK(wrongSize.boards.empty());
  REQUIRE(wrongSize.findings.size() == 1);
  CHECK_THAT(wrongSize.findings[0].sentence, Catch::Contains("640 x 480") && Catch::Contains("1280 x 960"));
}

} // namespace naocal

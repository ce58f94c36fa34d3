#include "Scenes.hpp"

#include "detect/BoardDetector.hpp"
#include "io/GreyImage.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>

namespace naocal {
namespace {

/// Three images of one board in a temporary folder, a capture without an image, and a mark without a pattern.
struct Recorded {
  std::filesystem::path folder = std::filesystem::temp_directory_path() / ("naocal-set-" + std::to_string(getpid()));
  CaptureSet set;

  Recorded() {
    std::filesystem::create_directories(folder);
    const CameraIntrinsics camera = plainCamera();
    set.cameras["bottom"] = camera;
    set.boards = {described("A", {}), described("mark", {})};
    set.boards[1].pattern.reset();
    for (int i = 0; i < 4; ++i) {
      Capture capture;
      capture.id = i;
      capture.camera = "bottom";
      capture.corners = {{"A", {0}, {{1, 1}}}, {"mark", {0}, {{2, 2}}}};
      if (i < 3) {
        capture.image = std::to_string(i) + ".png";
        writeImage(Renderer{camera}.render({{boardOnFloor({}, 0.7, 20. * i)}, {}}, {}, std::uint64_t(i)),
                   folder / capture.image);
      }
      set.captures.push_back(capture);
    }
  }
  ~Recorded() { std::filesystem::remove_all(folder); }
};

bool always(std::size_t, std::size_t) {
  return true;
}

} // namespace

// Proves which corners are replaced and kept, and that the result is independent of the number of threads. The file
// format is not tested.
TEST_CASE("corners of a set are found anew where a picture was kept") {
  Recorded one, several;
  const SetDetection detection = detectInSet(one.set, one.folder, 1, always);
  detectInSet(several.set, several.folder, 3, always);
  CHECK(detection.pictures == 3);
  CHECK(detection.unreadable.empty());
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& corners = *one.set.captures[i].corners;
    REQUIRE(corners.size() == 2);
    CHECK(corners[0].board == "mark");
    CHECK(corners[1].board == "A");
    CHECK(corners[1].ids.size() == 24);
    CHECK(corners[1].uv == (*several.set.captures[i].corners)[1].uv);
  }
  CHECK(one.set.captures[3].corners->front().ids.size() == 1);
}

// Proves that each unusable image is reported and its capture unchanged.
TEST_CASE("a missing, a broken and a wrongly sized picture are named and touch nothing") {
  Recorded recorded;
  std::filesystem::remove(recorded.folder / "0.png");
  std::filesystem::resize_file(recorded.folder / "1.png", 10);
  writeImage(Renderer{plainCamera(320)}.render({}, {}, 1), recorded.folder / "2.png");
  const SetDetection detection = detectInSet(recorded.set, recorded.folder, 2, always);
  CHECK(detection.pictures == 0);
  REQUIRE(detection.unreadable.size() == 3);
  CHECK(detection.unreadableCaptures == std::vector<int>{0, 1, 2});
  CHECK_THAT(detection.unreadable[0], Catch::Contains("capture 0") && Catch::Contains("no such file"));
  CHECK_THAT(detection.unreadable[1], Catch::Contains("capture 1") && Catch::Contains("could not be read"));
  CHECK_THAT(detection.unreadable[2], Catch::Contains("capture 2") && Catch::Contains("320 x 240"));
  for (const Capture& capture : recorded.set.captures) {
    CHECK(capture.corners->size() == 2);
  }
}

// Proves that no picture outside the set's folder is read, and none that is a pipe, which would never end.
TEST_CASE("links out of a set and pipes are named and not read") {
  Recorded recorded;
  const std::filesystem::path outside = recorded.folder.string() + "-outside.png";
  std::filesystem::rename(recorded.folder / "0.png", outside);
  std::filesystem::create_symlink(outside, recorded.folder / "0.png");
  std::filesystem::remove(recorded.folder / "1.png");
  REQUIRE(::mkfifo((recorded.folder / "1.png").c_str(), 0600) == 0);
  const SetDetection detection = detectInSet(recorded.set, recorded.folder, 1, always);
  std::filesystem::remove(outside);
  CHECK(detection.pictures == 1);
  REQUIRE(detection.unreadable.size() == 2);
  CHECK_THAT(detection.unreadable[0], Catch::Contains("capture 0") && Catch::Contains("found a path out of it"));
  CHECK_THAT(detection.unreadable[1], Catch::Contains("capture 1") && Catch::Contains("found a pipe"));
}

// Proves that a set's pictures of another size are told from their headers: their content could not be decoded.
TEST_CASE("a picture of another size than its camera's is not decoded") {
  Recorded recorded;
  for (int i = 0; i < 3; ++i) {
    const std::filesystem::path file = recorded.folder / (std::to_string(i) + ".png");
    writeImage(Renderer{plainCamera(320)}.render({}, {}, 1), file);
    std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  }
  const SetDetection detection = detectInSet(recorded.set, recorded.folder, 1, always);
  REQUIRE(detection.unreadable.size() == 3);
  for (const std::string& sentence : detection.unreadable) {
    CHECK_THAT(sentence, Catch::Contains("the picture has 320 x 240 pixels, but its camera is described with"));
  }
}

// Proves that cancelling keeps the results so far and leaves the remaining captures unchanged.
TEST_CASE("a search that is stopped leaves later captures as they were") {
  Recorded recorded;
  detectInSet(recorded.set, recorded.folder, 1, [](std::size_t, std::size_t) { return false; });
  CHECK((*recorded.set.captures[0].corners)[1].ids.size() == 24);
  CHECK((*recorded.set.captures[1].corners)[0].ids.size() == 1);
}

} // namespace naocal

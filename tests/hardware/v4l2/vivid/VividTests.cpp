#include "VividDriver.hpp"

#include "detect/BoardDetector.hpp"
#include "hardware/v4l2/VideoCameras.hpp"
#include "simulation/Renderer.hpp"
#include "simulation/SimulationPlan.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <fmt/format.h>

using namespace naocal;
using namespace std::chrono_literals;

namespace {

constexpr const char *topCapture = "/dev/video0", *topOutput = "/dev/video1", *bottomCapture = "/dev/video2";

std::vector<VideoOptions> cameras(int input = vivid::webcam) {
  std::vector<VideoOptions> options(2);
  options[0].path = topCapture;
  options[1].path = bottomCapture;
  options[1].camera = CameraName::bottom;
  options[0].input = options[1].input = input;
  return options;
}

void inject(const char* control, int value = 1) {
  vivid::Node{topCapture}.set(control, value);
}

/// The `count`-th next frame of the top camera; absent after a minute.
std::optional<CameraFrame> top(VideoCameras& video, int count = 1) {
  std::optional<CameraFrame> last;
  const TimePoint deadline = Clock::now() + 60s;
  while (count > 0 && Clock::now() < deadline) {
    if (auto frame = video.waitForFrame(1s); frame && frame->camera == CameraName::top) {
      last = std::move(frame);
      --count;
    }
  }
  return count == 0 ? last : std::nullopt;
}

/// Duration: $NAOCAL_VIVID_SECONDS, or 5 s by default.
int streamingSeconds() {
  const char* wanted = std::getenv("NAOCAL_VIVID_SECONDS");
  return wanted ? std::atoi(wanted) : 5;
}

} // namespace

// Proves that with two real streams at the driver's full rate (25 Hz for webcams of 640 x 480) every image is
// delivered, skipped or counted as lost. NAOCAL_VIVID_SECONDS=30 runs half a minute.
TEST_CASE("two cameras stream at full rate and every picture is accounted for") {
  for (const char* path : {topCapture, bottomCapture}) {
    vivid::Node{path}.set("Timestamp Source", 1); // start of exposure, as with NAO's cameras
  }
  VideoCameras video{cameras()};
  std::array<std::uint64_t, 2> first{~0ull, ~0ull}, last{}, given{};
  std::array<TimePoint, 2> begin, end;
  const TimePoint until = Clock::now() + std::chrono::seconds{streamingSeconds()};
  while (Clock::now() < until) {
    const auto frame = video.waitForFrame(60s);
    REQUIRE(frame);
    const auto camera = std::size_t(frame->camera);
    if (first[camera] == ~0ull) {
      first[camera] = frame->sequence;
      begin[camera] = frame->time;
    } else {
      CHECK(frame->sequence > last[camera]);
      CHECK(frame->time > end[camera]);
    }
    CHECK(frame->picture->bytes().size() == 2 * 640 * 480);
    last[camera] = frame->sequence;
    end[camera] = frame->time;
    ++given[camera];
  }
  for (const CameraName camera : {CameraName::top, CameraName::bottom}) {
    const CameraStatus link = video.status(camera);
    const auto i = std::size_t(camera);
    CHECK(link.frames == given[i]);
    CHECK(link.frames + link.skipped + link.broken + link.lost >= last[i] + 1);
    const double since = 25 * toSeconds(Clock::now() - end[i]); // exposed since the last frame given
    CHECK(double(link.frames + link.skipped + link.broken + link.lost) <= double(last[i]) + 1 + 4 + since);
    CHECK(link.problem == "");
    const double rate = double(last[i] - first[i]) / toSeconds(end[i] - begin[i]);
    CHECK(rate == Approx(25).margin(0.5));
    fmt::print("{} camera: {} exposed, {} given, {} skipped, {} lost, {} broken, {:.2f} a second\n", toString(camera),
               last[i] + 1, link.frames, link.skipped, link.lost, link.broken, rate);
  }
}

// Proves that no byte changes between the driver's buffer and a frame, and that a board is detected in it.
TEST_CASE("a known picture is captured byte for byte and its board is found") {
  const CameraIntrinsics lens = nominalCameras(640, 480).at("top");
  Board board = defaultBoards().front();
  RenderedScene scene;
  scene.boards.push_back({board.id, *board.pattern, {rotationX(3.0), {-0.28, -0.2, 1.0}}});
  const GreyPicture grey = Renderer{lens}.render(scene, Appearance{}, 1);
  std::vector<std::uint8_t> picture(2 * grey.pixels.size(), 128);
  for (std::size_t pixel = 0; pixel < grey.pixels.size(); ++pixel) {
    picture[2 * pixel] = grey.pixels[pixel];
  }
  const vivid::Feeder feeder{topCapture, topOutput, picture};
  VideoCameras video{{cameras(vivid::hdmi)[0]}};
  REQUIRE(top(video, 5)); // the loop-back has started
  int same = 0;
  std::optional<CameraFrame> frame;
  for (int i = 0; i < 30; ++i) {
    frame = top(video);
    REQUIRE(frame);
    const auto bytes = frame->picture->bytes();
    same += std::equal(bytes.begin(), bytes.end(), picture.begin(), picture.end());
  }
  CHECK(same == 30);
  const Detection detection = detectBoards(toGreyImage(*frame).value(), {board}, lens);
  REQUIRE(detection.boards.size() == 1);
  CHECK(detection.boards.front().ids.size() == board.points.size());
  fmt::print("{} of 30 captured pictures are the known one, {} of {} corners found\n", same,
             detection.boards.front().ids.size(), board.points.size());
}

// Proves read-back and limits with a real driver.
TEST_CASE("a real driver takes settings, reads them back and refuses what it has not") {
  auto options = cameras();
  options[0].controls = {
      {"brightness", V4L2_CID_BRIGHTNESS, 100}, {"automatic gain", V4L2_CID_AUTOGAIN, 0}, {"gain", V4L2_CID_GAIN, 33}};
  VideoCameras video{options};
  REQUIRE(top(video));
  CHECK(video.status(CameraName::top).problem == "");
  v4l2_control now{V4L2_CID_BRIGHTNESS, 0};
  vivid::Node{topCapture}.call(VIDIOC_G_CTRL, &now, "G_CTRL");
  CHECK(now.value == 100);
  video.setControls(CameraName::top, {{"exposure", V4L2_CID_EXPOSURE_ABSOLUTE, 100}});
  CHECK(video.status(CameraName::top).problem == "/dev/video0 (top camera): it has no exposure");
  video.setControls(CameraName::top, {{"brightness", V4L2_CID_BRIGHTNESS, 128}});
  CHECK(video.status(CameraName::top).problem == "");
}

// Proves that dropped and damaged images are counted and not delivered.
TEST_CASE("pictures that a real driver drops or damages are counted") {
  VideoCameras video{cameras()};
  REQUIRE(top(video, 3));
  inject("Percentage of Dropped Buffers", 50);
  REQUIRE(top(video, 20));
  inject("Percentage of Dropped Buffers", 0);
  const std::uint64_t lost = video.status(CameraName::top).lost;
  CHECK(lost > 3);
  inject("Inject V4L2_BUF_FLAG_ERROR");
  REQUIRE(top(video, 5));
  CHECK(video.status(CameraName::top).broken == 1);
  CHECK(video.status(CameraName::top).reopened == 0);
}

// Proves recovery from every failure that the driver can inject, while the other camera continues.
TEST_CASE("queue errors, a dead stream and an unplugged camera end in a stream again") {
  VideoCameras video{cameras()};
  REQUIRE(top(video, 3));
  std::uint64_t reopened = 0;
  for (const char* failure : {"Inject VIDIOC_QBUF Error", "Inject Fatal Streaming Error", "Disconnect",
                              "Inject Fatal Streaming Error", "Disconnect"}) {
    const std::uint64_t before = video.status(CameraName::top).frames, others = video.status(CameraName::bottom).frames;
    inject(failure);
    const TimePoint since = Clock::now();
    std::uint64_t sequence = 0;
    for (int i = 0; i < 10; ++i) {
      const auto frame = top(video);
      REQUIRE(frame);
      CHECK(frame->sequence > sequence);
      sequence = frame->sequence;
    }
    CHECK(video.status(CameraName::top).frames >= before + 10);
    CHECK(video.status(CameraName::bottom).frames > others);
    CHECK(video.status(CameraName::bottom).reopened == 0);
    reopened += failure != std::string_view{"Inject VIDIOC_QBUF Error"};
    CHECK(video.status(CameraName::top).reopened == reopened);
    fmt::print("{}: ten pictures later after {:.2f} s\n", failure, toSeconds(Clock::now() - since));
  }
}

// Proves that opening is retried if the driver refuses at first.
TEST_CASE("a camera whose buffers or stream a real driver refuses at first is opened in the end") {
  for (const char* failure : {"Inject VIDIOC_REQBUFS Error", "Inject VIDIOC_STREAMON Error"}) {
    inject(failure);
    VideoCameras video{cameras()};
    video.waitForFrame(0ms);
    CHECK(video.status(CameraName::top).problem.find("Invalid argument") != std::string::npos);
    CHECK(top(video, 3));
    CHECK(video.status(CameraName::top).problem == "");
  }
}

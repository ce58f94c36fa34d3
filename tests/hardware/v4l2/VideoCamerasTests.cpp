#include "FakeVideo.hpp"
#include "hardware/v4l2/VideoCameras.hpp"

#include <catch2/catch.hpp>

using namespace naocal;
using namespace std::chrono_literals;

namespace {

/// Two cameras on a fake kernel, open and without images.
struct Scene {
  Scene() {
    for (std::size_t i = 0; i < 2; ++i) {
      options[i].path = i == 0 ? "/dev/top" : "/dev/bottom";
      options[i].camera = CameraName(i);
      video.cameras[options[i].path];
    }
  }
  FakeVideo::Camera& top() { return video.cameras.at("/dev/top"); }
  FakeVideo::Camera& bottom() { return video.cameras.at("/dev/bottom"); }
  VideoCameras& cameras() {
    if (!opened) {
      opened.emplace(options, video);
      CHECK(!opened->waitForFrame(0ms));
    }
    return *opened;
  }
  /// Waits for a frame, at most 5 s; reopening takes 0.1 s.
  std::optional<CameraFrame> next() { return cameras().waitForFrame(5s); }

  FakeVideo video;
  std::vector<VideoOptions> options{2};
  std::optional<VideoCameras> opened;
};

} // namespace

// Proves the order of calls that drivers require.
TEST_CASE("a camera is told its format, gets buffers and settings, and then streams") {
  Scene scene;
  scene.options[0].controls = {{"gain", V4L2_CID_GAIN, 33}};
  scene.top().controls[V4L2_CID_GAIN];
  scene.cameras();
  const auto& order = scene.top().order;
  const auto place = [&](unsigned long request) {
    return std::find(order.begin(), order.end(), std::uint32_t(request)) - order.begin();
  };
  CHECK(place(VIDIOC_S_FMT) < place(VIDIOC_S_PARM));
  CHECK(place(VIDIOC_S_PARM) < place(VIDIOC_REQBUFS));
  CHECK(place(VIDIOC_QBUF) < place(VIDIOC_S_CTRL));
  CHECK(place(VIDIOC_S_CTRL) < place(VIDIOC_STREAMON));
  CHECK(scene.top().streaming);
  CHECK(scene.top().controls.at(V4L2_CID_GAIN).value == 33);
  CHECK(scene.video.mapped == 8);
  scene.opened.reset();
  CHECK(scene.video.mapped == 0);
  CHECK(scene.top().file == -1);
}

// Proves which image is delivered: the newest of each camera, the older one of both cameras first.
TEST_CASE("of several pictures the newest is given, of two cameras' pictures the older") {
  Scene scene;
  scene.cameras();
  scene.video.expose(scene.top(), 1, 10s);
  scene.video.expose(scene.top(), 2, 12s);
  scene.video.expose(scene.bottom(), 3, 11s);
  const auto first = scene.next(), second = scene.next();
  REQUIRE(second);
  CHECK(first->camera == CameraName::bottom);
  CHECK(first->picture->bytes().front() == 3);
  CHECK(first->time == TimePoint{11s});
  CHECK(second->picture->bytes().front() == 2);
  CHECK(second->picture->bytes().size() == 2 * 640 * 480);
  CHECK(second->sequence == 1);
  CHECK(scene.cameras().status(CameraName::top).skipped == 1);
  CHECK(scene.top().free.size() == 4); // all buffers are queued again
  CHECK(!scene.cameras().waitForFrame(0ms));
}

// Proves the counts: delivered + skipped + damaged + lost = exposed, also when the driver's sequence number wraps.
TEST_CASE("every exposed picture is accounted for, also when the driver's count starts at its end") {
  Scene scene;
  scene.cameras();
  scene.top().sequence = 0xfffffff0;
  std::uint64_t last = 0;
  for (int i = 0; i < 200; ++i) {
    scene.video.expose(scene.top(), std::uint8_t(i), 1ms * i, i % 7 == 4 ? V4L2_BUF_FLAG_ERROR : 0);
    if (i % 50 > 6) { // otherwise it runs out of buffers
      while (const auto frame = scene.cameras().waitForFrame(0ms)) {
        CHECK(frame->picture->bytes().front() == std::uint8_t(frame->sequence));
        last = frame->sequence;
      }
    }
  }
  const CameraStatus link = scene.cameras().status(CameraName::top);
  CHECK(link.lost >= 4 * 3);
  CHECK(link.broken > 10);
  CHECK(link.frames + link.skipped + link.broken + link.lost == 200);
  CHECK(last == 199);
}

// Proves recovery from a buffer that is refused once or twice and from a failed stream.
TEST_CASE("a camera whose stream fails is opened anew, and its pictures go on counting") {
  Scene scene;
  scene.cameras();
  scene.video.expose(scene.top(), 1, 1s);
  CHECK(scene.next()->sequence == 0);

  scene.top().failures[VIDIOC_QBUF] = 1; // once: retried
  scene.video.expose(scene.top(), 2, 2s);
  CHECK(scene.next()->sequence == 1);
  CHECK(scene.top().opened == 1);

  scene.top().failures[VIDIOC_QBUF] = 2;
  scene.video.expose(scene.top(), 3, 3s);
  CHECK(scene.next()->sequence == 2); // received completely before the failure
  CHECK(scene.cameras().status(CameraName::top).problem ==
        "/dev/top (top camera): it does not take its buffers back: Invalid argument");

  for (int round = 1; round <= 3; ++round) {
    while (!scene.top().streaming) {
      scene.cameras().waitForFrame(10ms);
    }
    CHECK(scene.cameras().status(CameraName::top).problem.empty());
    scene.video.expose(scene.top(), 4, 4s);
    CHECK(scene.next()->sequence == std::uint64_t(2 + round));
    scene.top().broken = true;
    CHECK(!scene.cameras().waitForFrame(5ms));
    CHECK(scene.cameras().status(CameraName::top).reopened == std::uint64_t(round));
  }
}

// Proves that a missing camera gives a message and does not affect the other one.
TEST_CASE("a camera that is unplugged is waited for while the other one goes on") {
  Scene scene;
  scene.cameras();
  scene.top().present = false;
  for (std::uint8_t i = 0; i < 20; ++i) {
    scene.video.expose(scene.bottom(), i, 1ms * i);
    const auto frame = scene.next();
    REQUIRE(frame);
    CHECK(frame->camera == CameraName::bottom);
    CHECK(frame->picture->bytes().front() == i);
  }
  while (scene.top().file >= 0) {
    scene.cameras().waitForFrame(1ms);
  }
  CHECK(scene.cameras().status(CameraName::top).problem.find("/dev/top (top camera): ") == 0);
  CHECK(scene.video.mapped == 4);
  scene.top().present = true;
  while (!scene.top().streaming) {
    scene.cameras().waitForFrame(1ms);
  }
  scene.video.expose(scene.top(), 9, 9s);
  CHECK(scene.next()->picture->bytes().front() == 9);
}

// Proves that a camera whose buffers fill up meanwhile is not taken for hanging, and that attempts are at least 100 ms
// apart. The images' delay is not tested.
TEST_CASE("a camera whose opening takes over a second is not the other one's trouble", "[slow]") {
  Scene scene;
  scene.bottom().present = false;
  scene.cameras();
  std::vector<TimePoint> begins, ends;
  scene.bottom().opening = [&] {
    begins.push_back(Clock::now());
    for (int i = 0; i < 10; ++i) {
      scene.video.expose(scene.top(), 1, 1s);
    }
    std::this_thread::sleep_for(1100ms);
    ends.push_back(Clock::now());
  };
  while (ends.size() < 2) {
    scene.video.expose(scene.top(), 2, 2s);
    const auto frame = scene.cameras().waitForFrame(0ms);
    REQUIRE(frame);
    CHECK(frame->camera == CameraName::top);
  }
  scene.video.expose(scene.top(), 3, 3s);
  CHECK(scene.next());
  CHECK(scene.top().opened == 1);
  CHECK(scene.cameras().status(CameraName::top).problem.empty());
  CHECK(begins[1] - ends[0] >= 100ms);
}

// Proves that an open but silent camera is closed and reopened; the time this takes is not measured.
TEST_CASE("a camera that gives no picture for a second is opened anew", "[slow]") {
  Scene scene;
  scene.cameras();
  while (scene.top().opened == 1 || !scene.top().streaming) {
    scene.video.expose(scene.bottom(), 1, 1s);
    scene.cameras().waitForFrame(1ms);
    scene.cameras().waitForFrame(1ms);
  }
  CHECK(scene.cameras().status(CameraName::top).reopened == 1);
  CHECK(scene.bottom().opened == 1);
}

// Proves that a failure at each step of opening is handled, and that opening succeeds later.
TEST_CASE("a camera that fails while it is opened is closed and tried again") {
  for (const unsigned long request : {VIDIOC_S_FMT, VIDIOC_REQBUFS, VIDIOC_QUERYBUF, VIDIOC_STREAMON}) {
    Scene scene;
    scene.top().failures[request] = 1;
    scene.cameras();
    CHECK(scene.top().file == -1);
    CHECK(scene.video.mapped == 4);
    CHECK(scene.opened->status(CameraName::top).problem.find("Invalid argument") != std::string::npos);
    while (!scene.top().streaming) {
      scene.cameras().waitForFrame(1ms);
    }
    CHECK(scene.opened->status(CameraName::top).problem.empty());
    CHECK(scene.opened->status(CameraName::top).reopened == 0);
  }
  Scene scene;
  scene.top().width = 320;
  scene.cameras();
  CHECK(scene.opened->status(CameraName::top).problem ==
        "/dev/top (top camera): it offers 320 x 480 pixels in 640 bytes a row instead of 640 x 480 in YUYV");
}

// Proves read-back and retry, limits, the flips of both models, and that images are still delivered.
TEST_CASE("a setting is read back, tried again, and said when it is refused") {
  Scene scene;
  scene.options[0].controls = {{"exposure", V4L2_CID_EXPOSURE_ABSOLUTE, 100}};
  scene.options[0].extensions = {{"vertical flip", 3, 0x0d, 1}};
  scene.top().controls[V4L2_CID_EXPOSURE_ABSOLUTE].stubborn = 2;
  scene.cameras();
  CHECK(scene.top().controls[V4L2_CID_EXPOSURE_ABSOLUTE].value == 100);
  CHECK(scene.top().extensions[0x0d] == 1);
  CHECK(scene.cameras().status(CameraName::top).problem.empty());

  const auto refusal = [&](VideoControl control) {
    scene.cameras().setControls(CameraName::top, {control});
    return scene.cameras().status(CameraName::top).problem;
  };
  scene.top().controls[V4L2_CID_EXPOSURE_ABSOLUTE].stubborn = 1000;
  CHECK(refusal({"exposure", V4L2_CID_EXPOSURE_ABSOLUTE, 50}) ==
        "/dev/top (top camera): its exposure does not take the value 50: it stays at 100");
  CHECK(refusal({"exposure", V4L2_CID_EXPOSURE_ABSOLUTE, 999}) ==
        "/dev/top (top camera): its exposure can be 0 to 255, not 999");
  CHECK(refusal({"hue", V4L2_CID_HUE, 0}) == "/dev/top (top camera): it has no hue");
  scene.top().controls[V4L2_CID_EXPOSURE_ABSOLUTE].stubborn = 0;
  scene.cameras().configure(CameraName::top, {{"exposure", 70}});
  CHECK(scene.top().controls[V4L2_CID_EXPOSURE_ABSOLUTE].value == 70);
  scene.cameras().configure(CameraName::top, {}); // the model's defaults
  CHECK(scene.top().controls[V4L2_CID_EXPOSURE_ABSOLUTE].value == 100);
  scene.video.expose(scene.top(), 1, 1s);
  CHECK(scene.next());

  CHECK(videoOptionsForModel("V6")[0].extensions.size() == 2);
  CHECK(videoOptionsForModel("V5")[0].controls[1].value == 1);
  CHECK(videoOptionsForModel("V5")[1].controls[1].value == 0);
  CHECK_THROWS_AS(videoOptionsForModel("V7"), std::invalid_argument);
  CHECK(videoControlId("exposure") == V4L2_CID_EXPOSURE_ABSOLUTE);
  CHECK(!videoControlId("zoom"));
}

// Proves that wall-clock time stamps, as of a V5's driver, are converted to the clock of the joints.
TEST_CASE("a picture that is stamped with the wall clock is placed among the joints") {
  Scene scene;
  scene.top().wallClock = true;
  scene.cameras();
  const TimePoint before = Clock::now();
  scene.video.expose(scene.top(), 1, std::chrono::system_clock::now().time_since_epoch());
  const TimePoint after = Clock::now();
  const auto frame = scene.next();
  REQUIRE(frame);
  CHECK(frame->time >= before - 1ms); // microsecond resolution, and reading two clocks
  CHECK(frame->time <= after + 1ms);
}

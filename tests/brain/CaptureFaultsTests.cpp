#include "brain/CaptureFaults.hpp"

#include <catch2/catch.hpp>

namespace naocal {
namespace {

struct Grey : ImageBytes {
  explicit Grey(std::vector<std::uint8_t> given) : all{std::move(given)} {}
  std::span<const std::uint8_t> bytes() const override { return all; }
  std::vector<std::uint8_t> all;
};

/// A picture of one grey but for one pixel.
CameraFrame frameOf(CameraName camera, std::uint8_t grey, std::uint8_t pixel) {
  std::vector<std::uint8_t> pixels(64 * 48, grey);
  pixels[1000] = pixel;
  return {camera, PixelFormat::grey, 64, 48, {}, 0, std::make_shared<Grey>(std::move(pixels))};
}

Capture captureOf(const std::string& pose, std::optional<double> load) {
  Capture capture;
  capture.pose = pose;
  if (load) {
    capture.fsr.emplace();
    capture.fsr->fill(*load / 8);
  }
  return capture;
}

} // namespace

TEST_CASE("a picture that repeats one of another pose bit by bit is no new one") {
  // Proves it for each camera by itself; one pixel of noise, or the same pose, makes it no repetition.
  CaptureFaults faults;
  const CameraFrame seen = frameOf(CameraName::top, 100, 90);
  CHECK(faults.findCameraFault(seen, "P1").empty());
  faults.note(seen, captureOf("P1", 5));
  CHECK(faults.findCameraFault(frameOf(CameraName::top, 100, 90), "P1").empty());
  CHECK(faults.findCameraFault(frameOf(CameraName::top, 100, 90), "P2") ==
        "the top camera takes new pictures: it repeats one, so restart the robot");
  CHECK(faults.findCameraFault(frameOf(CameraName::top, 100, 91), "P2").empty());
  CHECK(faults.findCameraFault(frameOf(CameraName::bottom, 100, 90), "P2").empty());
  faults.startRound();
  CHECK(faults.findCameraFault(seen, "P2").empty());
}

TEST_CASE("a black picture is that of a covered camera") {
  // Proves the boundary of the mean; an incomplete picture is left to others.
  CaptureFaults faults;
  CHECK(faults.findCameraFault(frameOf(CameraName::bottom, 4, 255), "P1") ==
        "the bottom camera sees something: its pictures are black, so uncover it or make light");
  CHECK(faults.findCameraFault(frameOf(CameraName::bottom, 5, 5), "P1").empty());
  CameraFrame broken = frameOf(CameraName::bottom, 0, 0);
  broken.width = 32;
  CHECK(faults.findCameraFault(broken, "P1").empty());
}

TEST_CASE("a robot whose feet carry nothing any more was lifted") {
  // Proves the load at its boundary, that dead sensors, with which nothing was ever felt, are told instead, and that a
  // new round starts anew.
  const CameraFrame frame = frameOf(CameraName::top, 100, 90);
  CaptureFaults faults;
  CHECK_FALSE(faults.feltNoLoad());
  faults.note(frame, captureOf("P1", 0.9));
  CHECK(faults.feltNoLoad());
  CHECK_FALSE(faults.isLifted(captureOf("P2", 0)));
  faults.note(frame, captureOf("P2", 1));
  CHECK_FALSE(faults.feltNoLoad());
  CHECK_FALSE(faults.isLifted(captureOf("P3", 1)));
  CHECK(faults.isLifted(captureOf("P3", 0.9)));
  CHECK(faults.isLifted(captureOf("P3", std::nullopt)));
  faults.startRound();
  CHECK_FALSE(faults.isLifted(captureOf("P3", 0)));
}

} // namespace naocal

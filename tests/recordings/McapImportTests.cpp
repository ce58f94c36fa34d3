#include "recordings/mcap/McapImport.hpp"

#include "data/CaptureSetFile.hpp"
#include "io/Files.hpp"
#include "io/GreyImage.hpp"
#include "io/InputError.hpp"

#include "recordings/McapWriter.hpp"
#include "recordings/TestArm.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>

using namespace naocal;
using namespace naocal::testing;

namespace {

/// Three rests of two seconds, the third as the first; a picture each 0.5 s whose first pixel is its number.
std::string ride(const std::string& imageEncoding = "mono8", const std::string& compression = "zstd") {
  McapWriter writer{compression};
  const int joints = writer.addChannel("/joint_states", "sensor_msgs/msg/JointState");
  const int images = writer.addChannel("/wrist/image_raw", "sensor_msgs/msg/Image");
  const int info = writer.addChannel("/wrist/camera_info", "sensor_msgs/msg/CameraInfo");
  const std::array<double, 4> stops{0.1, 0.9, 0.1, 0.1};
  for (int i = 0; i < 900; ++i) {
    const double time = 100 + i * 0.01, phase = std::fmod(i * 0.01, 3.0);
    const auto stop = static_cast<std::size_t>(i / 300);
    const double pan = stops[stop] + (stops[stop + 1] - stops[stop]) * std::max(0.0, phase - 2);
    writer.addMessage(joints, time,
                      jointStateMessage(time, {"shoulder_lift", "shoulder_pan", "unknown"}, {0.5, pan, 7}));
    if (i % 50 == 0) {
      std::vector<std::uint8_t> pixels(640 * 480, 9);
      pixels[0] = static_cast<std::uint8_t>(i / 50);
      writer.addMessage(images, time, imageMessage(time, "eye", 640, 480, imageEncoding, 640, pixels));
      writer.addMessage(info, time,
                        cdr(std::int32_t{100}, std::uint32_t{0}, std::string{"eye"}, std::uint32_t{480},
                            std::uint32_t{640}, std::string{"plumb_bob"}, std::vector<double>(5, 0.0),
                            std::array<double, 9>{600, 0, 320, 0, 600, 240, 0, 0, 1}));
      writer.endChunk();
    }
  }
  return writer.finish();
}

McapImport import(const std::string& bytes, const TemporaryDirectory& folder, McapTopics topics = {}) {
  if (topics.images.empty()) {
    topics.images = "/wrist/image_raw";
  }
  writeAtomically(folder.path() / "ride.mcap", bytes);
  return importMcap(folder.path() / "ride.mcap", armScene(), topics, {});
}

} // namespace

TEST_CASE("a recording becomes one capture for each rest, with its picture, lens and link") {
  const TemporaryDirectory folder;
  const McapImport result = import(ride(), folder);
  CHECK(result.pictures == 18);
  CHECK(result.rests == 3);
  CHECK(result.poses == 2);
  writeImport(result.imported, folder.path() / "set");
  const CaptureSet set = readCaptureSet(folder.path() / "set").set;
  CHECK(set.jointNames == std::vector<std::string>{"shoulder_pan", "shoulder_lift"});
  REQUIRE(set.captures.size() == 3);
  CHECK(set.captures[1].joints.measured[0] == Approx(0.9));
  CHECK(set.captures[1].joints.measured[1] == 0.5);
  CHECK(set.captures[2].pose == set.captures[0].pose);
  CHECK(set.captures[2].repeat == 1);
  CHECK(set.mountings.at("wrist").link == "eye");
  CHECK(set.cameras.at("wrist").fx == 600);
  for (const Capture& capture : set.captures) {
    const GreyPicture picture = readImage(pictureFile(capture, folder.path() / "set"));
    CHECK(picture.pixels[0] == std::lround(capture.time.count() / 0.5)); // the picture of that time
  }
}

TEST_CASE("a recording without what is asked for is refused, and says what it holds") {
  const TemporaryDirectory folder;
  CHECK_THROWS_WITH(import(ride(), folder, {"/joints", "", ""}),
                    Catch::Contains("--joints") && Catch::Contains("/joint_states (sensor_msgs/msg/JointState)"));
  CHECK_THROWS_WITH(import(ride(), folder, {"/joint_states", "/eye", ""}), Catch::Contains("--images"));
  CHECK_THROWS_WITH(
      import(ride(), folder, {"/wrist/image_raw", "", ""}),
      Catch::Contains("expected messages of the type sensor_msgs/msg/JointState, found sensor_msgs/msg/Image"));
  CHECK_THROWS_WITH(import(ride("bayer_rggb8"), folder), Catch::Contains("bayer_rggb8"));
  CHECK_THROWS_WITH(import(ride(), folder, {"/joint_states", "", "/none"}), Catch::Contains("--camera-model"));
  McapWriter moving;
  const int joints = moving.addChannel("/joint_states", "sensor_msgs/msg/JointState");
  const int images = moving.addChannel("/wrist/image_raw", "sensor_msgs/msg/Image");
  for (int i = 0; i < 100; ++i) {
    moving.addMessage(joints, i, jointStateMessage(i * 0.01, {"shoulder_pan"}, {i * 0.01}));
  }
  moving.addMessage(images, 0, imageMessage(0.5, "eye", 1, 1, "mono8", 1, {1}));
  CHECK_THROWS_WITH(import(moving.finish(), folder), Catch::Contains("expected pictures during which all joints rest"));
  McapWriter other;
  other.addMessage(other.addChannel("/joint_states", "sensor_msgs/JointState", "ros1"), 0, "abc");
  CHECK_THROWS_WITH(import(other.finish(), folder), Catch::Contains("sensor_msgs/JointState"));
  CHECK_THROWS_WITH(importMcap(folder.path(), armScene(), {}, {}), Catch::Contains("found no regular file"));
}

#include "recordings/mcap/RosMessages.hpp"

#include "io/InputError.hpp"

#include "recordings/McapWriter.hpp"

#include <array>
#include <catch2/catch.hpp>

using namespace naocal;
using namespace naocal::testing;

namespace {

std::string infoMessage(const std::string& model, const std::vector<double>& distortion, double fx = 600) {
  return cdr(std::int32_t{3}, std::uint32_t{500'000'000}, std::string{"optical"}, std::uint32_t{480},
             std::uint32_t{640}, model, distortion, std::array<double, 9>{fx, 0, 320, 0, 601, 240, 0, 0, 1});
}

} // namespace

TEST_CASE("joint states are read from CDR") {
  const RosJointState state = parseJointState(jointStateMessage(12.25, {"a", "elbow"}, {0.5, -1.25}), "x");
  CHECK(std::chrono::duration<double>{state.stamp}.count() == 12.25);
  CHECK(state.names == std::vector<std::string>{"a", "elbow"});
  CHECK(state.positions == std::vector<double>{0.5, -1.25});
  CHECK(std::chrono::duration<double>{parseStamp(jointStateMessage(12.25, {}, {}), "x")}.count() == 12.25);
}

TEST_CASE("pictures in usual encodings become their luma") {
  // Proves the order of colours, padding at the ends of rows, and the place of luma in YUV 4:2:2.
  struct Case {
    std::string encoding;
    std::uint32_t step;
    std::vector<std::uint8_t> pixels; // 2 x 2, the second row begins at `step`
    std::vector<std::uint8_t> grey;
  };
  const std::array<std::uint8_t, 3> red{255, 0, 0}, blue{0, 0, 255};
  const std::vector<Case> all{
      {"mono8", 3, {1, 2, 99, 3, 4, 99}, {1, 2, 3, 4}},
      {"rgb8", 6, {255, 0, 0, 0, 0, 255, 7, 7, 7, 8, 8, 8}, {luma(red.data()), luma(blue.data()), 7, 8}},
      {"bgr8", 6, {255, 0, 0, 0, 0, 255, 7, 7, 7, 8, 8, 8}, {luma(blue.data()), luma(red.data()), 7, 8}},
      {"rgba8", 8, {255, 0, 0, 9, 0, 0, 255, 9, 7, 7, 7, 9, 8, 8, 8, 9}, {luma(red.data()), luma(blue.data()), 7, 8}},
      {"yuv422_yuy2", 4, {1, 100, 2, 100, 3, 100, 4, 100}, {1, 2, 3, 4}},
      {"uyvy", 4, {100, 1, 100, 2, 100, 3, 100, 4}, {1, 2, 3, 4}},
  };
  for (const Case& each : all) {
    CAPTURE(each.encoding);
    const RosImage image = parseImage(imageMessage(1, "eye", 2, 2, each.encoding, each.step, each.pixels), "x");
    CHECK(image.frame == "eye");
    CHECK(std::get<GreyPicture>(image.content).pixels == each.grey);
  }
}

TEST_CASE("a compressed picture keeps its file, and a camera info its lens") {
  const std::string png = encodePng({2, 1, {3, 4}});
  const std::string message = cdr(std::int32_t{1}, std::uint32_t{0}, std::string{"eye"}, std::string{"png"},
                                  std::vector<std::uint8_t>{png.begin(), png.end()});
  CHECK(std::get<std::string>(parseCompressedImage(message, "x").content) == png);
  const RosCameraLens info = parseCameraInfo(infoMessage("plumb_bob", {0.1, 0.2, 0.3, 0.4, 0.5}), "x");
  CHECK(info.frame == "optical");
  CHECK(info.lens.width == 640);
  CHECK(info.lens.height == 480);
  CHECK(info.lens.fx == 600);
  CHECK(info.lens.fy == 601);
  CHECK(info.lens.cx == 320);
  CHECK(info.lens.cy == 240);
  CHECK(info.lens.distortion == std::array<double, 5>{0.1, 0.2, 0.3, 0.4, 0.5});
}

TEST_CASE("messages that are none are refused with one sentence") {
  const std::string joints = jointStateMessage(1, {"a"}, {2});
  for (std::size_t size = 0; size < 40; ++size) { // up to the end of the positions
    CAPTURE(size);
    CHECK_THROWS_WITH(parseJointState(joints.substr(0, size), "topic"), Catch::StartsWith("topic: expected"));
  }
  std::string impossible = joints;
  impossible.replace(24, 4, "\xff\xff\xff\x7f"); // number of names
  CHECK_THROWS_AS(parseJointState(impossible, "topic"), InputError);
  CHECK_THROWS_WITH(parseJointState(jointStateMessage(1, {"a", "b"}, {2}), "topic"),
                    Catch::Contains("expected a position for each of 2 joints, found 1"));
  CHECK_THROWS_WITH(parseImage(imageMessage(1, "eye", 2, 2, "bayer_rggb8", 2, {1, 2, 3, 4}), "topic"),
                    Catch::Contains("found \"bayer_rggb8\""));
  CHECK_THROWS_WITH(parseImage(imageMessage(1, "eye", 2, 2, "mono8", 2, {1, 2, 3}), "topic"),
                    Catch::Contains("expected 2 x 2 pixels in rows of 2 bytes, found 3 bytes"));
  CHECK_THROWS_WITH(parseImage(imageMessage(1, "eye", 200'000, 200'000, "mono8", 200'000, {}), "topic"),
                    Catch::StartsWith("topic: expected"));
  CHECK_THROWS_WITH(parseCameraInfo(infoMessage("equidistant", {0, 0, 0, 0}), "topic"),
                    Catch::Contains("found \"equidistant\""));
  CHECK_THROWS_WITH(parseCameraInfo(infoMessage("plumb_bob", {}, 0), "topic"),
                    Catch::Contains("expected a calibrated camera"));
  const std::string text = cdr(std::int32_t{1}, std::uint32_t{0}, std::string{"eye"}, std::string{"png"},
                               std::vector<std::uint8_t>{1, 2, 3});
  CHECK_THROWS_AS(parseCompressedImage(text, "topic"), InputError);
}

#include "protocol/Frames.hpp"

#include <catch2/catch.hpp>

namespace naocal {
namespace {

std::string headerOf(const FrameFormat& format, const std::string& frame) {
  return frame.substr(0, format.headerSize);
}

} // namespace

TEST_CASE("a frame's header has HULKs' bytes, and is understood") {
  // Pins the bytes of both formats, written by hand from the release named in Frames.hpp.
  using namespace std::string_literals;
  CHECK(encodeDebugFrame(DebugType::requestList, "ab") == "DMSG\x01\x03\0\0\x02\0\0\0\0\0\0\0ab"s);
  const std::string large = encodeConfigFrame(ConfigType::getKeys, std::string(0x10203, 'x'));
  CHECK(headerOf(configFormat, large) == "CONF\x02\x02\0\0\x03\x02\x01\0"s);
  const FrameHeader header = parseHeader(configFormat, headerOf(configFormat, large), 1 << 20);
  CHECK(header.problem == FrameProblem::none);
  CHECK(header.type == 2);
  CHECK(header.bodySize == 0x10203);
  CHECK(describeProblem(header, configFormat, 1 << 20).empty());
}

TEST_CASE("a header says what is wrong with it, the magic number first") {
  // Proves each problem, that the reader sets the maximum size, and that unknown message types are only reported by
  // describeProblem, as servers use it.
  const std::string good = headerOf(debugFormat, encodeFrame(debugFormat, 2, std::string(100, 'x')));
  const auto with = [&](std::size_t index, char value) {
    std::string header = good;
    header[index] = value;
    return header;
  };
  CHECK(parseHeader(debugFormat, with(0, 'X'), 100).problem == FrameProblem::magic);
  const FrameHeader newer = parseHeader(debugFormat, with(4, 9), 10);
  CHECK(newer.problem == FrameProblem::version);
  CHECK(newer.version == 9);
  CHECK(parseHeader(debugFormat, good, 100).problem == FrameProblem::none);
  const FrameHeader large = parseHeader(debugFormat, good, 99);
  CHECK(large.problem == FrameProblem::size);
  CHECK(describeProblem(large, debugFormat, 99) == "expected at most 99 bytes in a frame, found 100 announced");
  const FrameHeader unknown = parseHeader(debugFormat, with(5, 7), 100);
  CHECK(unknown.problem == FrameProblem::none);
  CHECK(describeProblem(unknown, debugFormat, 100) == "expected a message type from 0 to 6, found 7");
}

TEST_CASE("an image's body is understood as it was written, and refused where it ends early") {
  // Proves all fields, with values that use all their bytes, and every truncated header.
  const std::string body = encodeImageBody({0x0102030405060708, 640, 480, "Brain.image", "file"});
  const auto image = parseImageBody(body);
  REQUIRE(image);
  CHECK(image->timestamp == 0x0102030405060708);
  CHECK(image->width == 640);
  CHECK(image->height == 480);
  CHECK(image->key == "Brain.image");
  CHECK(image->file == "file");
  for (std::size_t size = 0; size < body.size() - 4; ++size) {
    CHECK_FALSE(parseImageBody(std::string_view{body}.substr(0, size)));
  }
}

} // namespace naocal

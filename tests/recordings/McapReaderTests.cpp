#include "recordings/mcap/McapReader.hpp"

#include "io/InputError.hpp"

#include "recordings/McapWriter.hpp"

#include <catch2/catch.hpp>
#include <sstream>

using namespace naocal;
using naocal::testing::McapWriter;

namespace {

struct Kept {
  std::string topic, schema, encoding, data;
  double seconds;
};

std::vector<Kept> readAll(const std::string& bytes) {
  std::istringstream stream{bytes};
  std::vector<Kept> all;
  visitMcapMessages(stream, "ride.mcap", [&](const McapMessage& message) {
    all.push_back({std::string{message.topic}, std::string{message.schema}, std::string{message.encoding},
                   std::string{message.data}, std::chrono::duration<double>{message.time}.count()});
    return true;
  });
  return all;
}

std::string recording(const std::string& compression, std::uint32_t checksumError = 0) {
  McapWriter writer{compression};
  const int joints = writer.addChannel("/joint_states", "sensor_msgs/msg/JointState");
  writer.addMessage(joints, 1.5, "first");
  writer.endChunk(checksumError);
  const int other = writer.addChannel("/note", "std_msgs/msg/String", "json");
  writer.addMessage(other, 2, std::string(5000, 'x'));
  writer.addMessage(joints, 2.5, "");
  return writer.finish();
}

} // namespace

TEST_CASE("messages of an MCAP recording are visited in order, whatever compresses its chunks") {
  // Proves records with and without chunks, channels of earlier chunks, and that indices are passed over.
  const std::string compression = GENERATE("none", "", "zstd", "lz4");
  CAPTURE(compression);
  const std::vector<Kept> all = readAll(recording(compression));
  REQUIRE(all.size() == 3);
  CHECK(all[0].topic == "/joint_states");
  CHECK(all[0].schema == "sensor_msgs/msg/JointState");
  CHECK(all[0].encoding == "cdr");
  CHECK(all[0].data == "first");
  CHECK(all[0].seconds == Approx(1.5));
  CHECK(all[1].data == std::string(5000, 'x'));
  CHECK(all[1].encoding == "json");
  CHECK(all[2].topic == "/joint_states");
  CHECK(all[2].data.empty());
}

TEST_CASE("a visit of an MCAP recording ends when it has seen enough") {
  std::istringstream stream{recording("zstd")};
  int count = 0;
  visitMcapMessages(stream, "ride.mcap", [&](const McapMessage&) { return ++count < 2; });
  CHECK(count == 2);
}

TEST_CASE("an MCAP recording that is cut off anywhere is refused with one sentence") {
  // Proves every length: a cut within the last records of the index may leave all messages.
  const std::string compression = GENERATE("none", "zstd", "lz4");
  const std::string whole = recording(compression);
  const std::size_t dataEnd = whole.size() - 8 - (9 + 20) - (9 + 4);
  for (std::size_t size = 0; size <= dataEnd; ++size) {
    CAPTURE(compression, size);
    std::string sentence;
    try {
      readAll(whole.substr(0, size));
    } catch (const InputError& error) {
      sentence = error.what();
    }
    CHECK(sentence.starts_with("ride.mcap"));
    CHECK(sentence.find("expected") != std::string::npos);
  }
}

TEST_CASE("damaged MCAP recordings are refused with place, expected and found") {
  struct Broken {
    std::string bytes, sentence;
  };
  const std::string start{"\x89MCAP0\r\n", 8};
  const auto chunk = [](const std::string& compression, std::uint64_t size, const std::string& data) {
    return McapWriter::record(0x06, McapWriter::number(std::uint64_t{0}) + McapWriter::number(std::uint64_t{0}) +
                                        McapWriter::number(size) + McapWriter::number(std::uint32_t{0}) +
                                        McapWriter::text(compression) + McapWriter::number(std::uint64_t{data.size()}) +
                                        data);
  };
  const std::vector<Broken> all{
      {"SQLite format 3", "expected an MCAP recording, found another format"},
      {recording("zstd", 1), "the file is damaged"},
      {recording("", 1), "expected a chunk with the checksum"},
      {start + chunk("bz2", 5, "abcde"), "expected the compression zstd, lz4 or none, found \"bz2\""},
      {start + chunk("zstd", 5, "abcde"), "expected 5 bytes compressed by zstd, found damaged data"},
      {start + chunk("lz4", 5, "abcdefghijklmnop"), "expected 5 bytes compressed by lz4, found damaged data"},
      {start + chunk("", 7, "abcde"), "expected a chunk of 7 bytes, found 5"},
      {start + chunk("zstd", std::uint64_t{1} << 40, "abcde"), "expected a chunk of at most 256 MiB"},
      {start + McapWriter::record(0x05, std::string(22, '\0')), "expected the channel 0 before its message"},
      {start + McapWriter::record(0x05, "abc"), "expected 4 more bytes in this record, found 1"},
      {start + McapWriter::record(0x04, McapWriter::number(std::uint16_t{1}) + McapWriter::number(std::uint16_t{7}) +
                                            McapWriter::text("/a") + McapWriter::text("cdr")),
       "expected the schema 7 before its channel \"/a\""},
      {start + "\x05" + McapWriter::number(std::uint64_t{1} << 50), "expected a record of at most 256 MiB"},
      {start + "\x63" + McapWriter::number(~std::uint64_t{0}), "the recording was cut off"},
  };
  for (const Broken& broken : all) {
    CAPTURE(broken.sentence);
    CHECK_THROWS_WITH(readAll(broken.bytes), Catch::Contains(broken.sentence) && Catch::StartsWith("ride.mcap"));
  }
}

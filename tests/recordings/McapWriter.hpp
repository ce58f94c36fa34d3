#pragma once

#include <fastcdr/Cdr.h>

#include <cstring>
#include <lz4frame.h>
#include <string>
#include <utility>
#include <vector>
#include <zlib.h>
#include <zstd.h>

namespace naocal::testing {

/// Writes MCAP as the format describes it (https://mcap.dev/spec), independent of the reader.
class McapWriter {
public:
  /// `compression`: "none" (no chunks), "" (chunks as they are), "zstd", "lz4".
  explicit McapWriter(std::string compression = "none") : compression_{std::move(compression)} {
    file_ = std::string{"\x89MCAP0\r\n", 8};
    file_ += record(0x01, text("ros2") + text("test"));
  }

  int addChannel(const std::string& topic, const std::string& type, const std::string& encoding = "cdr") {
    const auto id = static_cast<std::uint16_t>(++channels_);
    add(record(0x03, number(id) + text(type) + text("ros2msg") + text("")));
    add(record(0x04, number(id) + number(id) + text(topic) + text(encoding) + number(std::uint32_t{0})));
    return id;
  }

  void addMessage(int channel, double seconds, const std::string& data) {
    const auto time = static_cast<std::uint64_t>(seconds * 1e9);
    add(record(0x05, number(static_cast<std::uint16_t>(channel)) + number(std::uint32_t{0}) + number(time) +
                         number(time) + data));
  }

  /// Ends a chunk; with a checksum of its own, or a false one.
  void endChunk(std::uint32_t checksumError = 0) {
    if (compression_ == "none" || chunk_.empty()) {
      return;
    }
    const auto checksum = static_cast<std::uint32_t>(
        crc32(0, reinterpret_cast<const Bytef*>(chunk_.data()), static_cast<uInt>(chunk_.size())));
    const std::string packed = compress();
    file_ += record(0x06, number(std::uint64_t{0}) + number(std::uint64_t{0}) + number(std::uint64_t{chunk_.size()}) +
                              number(checksum ^ checksumError) + text(compression_) +
                              number(std::uint64_t{packed.size()}) + packed);
    file_ += record(0x07, number(std::uint16_t{1}) + number(std::uint32_t{0})); // an index, which readers may skip
    chunk_.clear();
  }

  std::string finish() {
    endChunk();
    return file_ + record(0x0F, number(std::uint32_t{0})) +
           record(0x02, number(std::uint64_t{0}) + number(std::uint64_t{0}) + number(std::uint32_t{0})) +
           std::string{"\x89MCAP0\r\n", 8};
  }

  static std::string record(int opcode, const std::string& content) {
    return std::string{static_cast<char>(opcode)} + number(std::uint64_t{content.size()}) + content;
  }
  template <typename T> static std::string number(T value) {
    std::string bytes(sizeof(T), '\0');
    std::memcpy(bytes.data(), &value, sizeof(T));
    return bytes;
  }
  static std::string text(const std::string& value) { return number(static_cast<std::uint32_t>(value.size())) + value; }

private:
  void add(const std::string& bytes) { (compression_ == "none" ? file_ : chunk_) += bytes; }

  std::string compress() const {
    std::string packed;
    if (compression_ == "zstd") {
      packed.resize(ZSTD_compressBound(chunk_.size()));
      packed.resize(ZSTD_compress(packed.data(), packed.size(), chunk_.data(), chunk_.size(), 3));
    } else if (compression_ == "lz4") {
      packed.resize(LZ4F_compressFrameBound(chunk_.size(), nullptr));
      packed.resize(LZ4F_compressFrame(packed.data(), packed.size(), chunk_.data(), chunk_.size(), nullptr));
    } else {
      packed = chunk_;
    }
    return packed;
  }

  std::string compression_, file_, chunk_;
  int channels_ = 0;
};

/// Serialises values as a ROS 2 message.
template <typename... Values> std::string cdr(const Values&... values) {
  eprosima::fastcdr::FastBuffer buffer;
  eprosima::fastcdr::Cdr stream{buffer, eprosima::fastcdr::Cdr::DEFAULT_ENDIAN, eprosima::fastcdr::Cdr::DDS_CDR};
  stream.serialize_encapsulation();
  (void)(stream << ... << values);
  return {buffer.getBuffer(), stream.getSerializedDataLength()};
}

inline std::string jointStateMessage(double seconds, const std::vector<std::string>& names,
                                     const std::vector<double>& positions) {
  const auto whole = static_cast<std::int32_t>(seconds);
  return cdr(whole, static_cast<std::uint32_t>((seconds - whole) * 1e9), std::string{"base"}, names, positions,
             std::vector<double>{}, std::vector<double>{});
}

inline std::string imageMessage(double seconds, const std::string& frame, std::uint32_t width, std::uint32_t height,
                                const std::string& encoding, std::uint32_t step,
                                const std::vector<std::uint8_t>& pixels) {
  const auto whole = static_cast<std::int32_t>(seconds);
  return cdr(whole, static_cast<std::uint32_t>((seconds - whole) * 1e9), frame, height, width, encoding,
             std::uint8_t{0}, step, pixels);
}

} // namespace naocal::testing

#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

namespace naocal {

/// A message of an MCAP recording. Valid during the visit only.
struct McapMessage {
  std::string_view topic;
  std::string_view schema;         // name of its type, such as "sensor_msgs/msg/JointState"; empty: none
  std::string_view encoding;       // of `data`, such as "cdr"
  std::chrono::nanoseconds time{}; // log time
  std::string_view data;
};

inline constexpr std::uint64_t largestMcapRecord = std::uint64_t{1} << 28; // [bytes], also of a decompressed chunk

/// Visits the messages of an MCAP recording in the file's order. Reads one record at a time, so that memory does not
/// grow with the recording; ignores the index. Stops when `visit` returns false.
///
/// Throws InputError with `name`, the byte, expected and found: another format, a recording that was cut off, lengths
/// beyond their record, a wrong checksum, a compression other than zstd and lz4. Source: https://mcap.dev/spec.
void visitMcapMessages(std::istream& file, const std::string& name,
                       const std::function<bool(const McapMessage&)>& visit);

} // namespace naocal

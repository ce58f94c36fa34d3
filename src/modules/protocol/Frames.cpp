#include "protocol/Frames.hpp"

#include <cassert>
#include <fmt/format.h>

namespace naocal {
namespace {

template <class Integer> void append(std::string& bytes, Integer value) {
  for (std::size_t i = 0; i < sizeof(Integer); ++i) {
    bytes.push_back(static_cast<char>(value >> (8 * i) & 0xff));
  }
}

std::string frame(const FrameFormat& format, std::uint8_t type, std::string_view body) {
  std::string bytes;
  bytes.reserve(format.headerSize + body.size());
  bytes.append(format.magic);
  bytes.push_back(static_cast<char>(format.version));
  bytes.push_back(static_cast<char>(type));
  append(bytes, std::uint16_t{0});
  append(bytes, static_cast<std::uint32_t>(body.size()));
  bytes.resize(format.headerSize, '\0');
  return bytes.append(body);
}

} // namespace

FrameHeader parseHeader(const FrameFormat& format, std::string_view header) {
  assert(header.size() == format.headerSize);
  if (header.substr(0, 4) != format.magic) {
    return {0, 0, fmt::format("expected the four letters {} at the start of a frame, found others", format.magic)};
  }
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(header[i]); };
  if (byte(4) != format.version) {
    return {0, 0, fmt::format("expected version {} of the protocol, found {}", format.version, byte(4))};
  }
  FrameHeader parsed{byte(5), 0, ""};
  for (std::size_t i = 0; i < 4; ++i) {
    parsed.bodySize |= static_cast<std::uint32_t>(byte(8 + i)) << (8 * i);
  }
  if (parsed.type > format.largestType) {
    parsed.problem = fmt::format("expected a message type from 0 to {}, found {}", format.largestType, parsed.type);
  } else if (parsed.bodySize > format.maxBodyBytes) {
    parsed.problem =
        fmt::format("expected at most {} bytes in a frame, found {} announced", format.maxBodyBytes, parsed.bodySize);
  }
  return parsed;
}

std::string encodeDebugFrame(DebugType type, std::string_view body) {
  return frame(debugFormat, static_cast<std::uint8_t>(type), body);
}

std::string encodeConfigFrame(ConfigType type, std::string_view body) {
  return frame(configFormat, static_cast<std::uint8_t>(type), body);
}

std::string encodeImageBody(std::uint64_t timestamp, std::uint16_t width, std::uint16_t height, std::string_view key,
                            std::string_view file) {
  std::string bytes;
  append(bytes, timestamp);
  append(bytes, width);
  append(bytes, height);
  append(bytes, static_cast<std::uint16_t>(key.size()));
  return bytes.append(key).append(file);
}

} // namespace naocal

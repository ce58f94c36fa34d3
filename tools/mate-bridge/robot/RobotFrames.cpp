#include "robot/RobotFrames.hpp"

#include <fmt/format.h>

namespace naocal {

namespace {

/// The little-endian number in `size` bytes at `first`.
std::uint64_t numberAt(std::string_view bytes, std::size_t first, std::size_t size) {
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < size; ++i) {
    number |= std::uint64_t{static_cast<unsigned char>(bytes[first + i])} << (8 * i);
  }
  return number;
}

} // namespace

std::string robotFrame(const RobotFormat& format, std::uint8_t type, std::string_view body) {
  std::string bytes{format.magic};
  bytes += static_cast<char>(format.version);
  bytes += static_cast<char>(type);
  bytes += std::string(2, '\0');
  for (std::size_t i = 0; i < 4; ++i) {
    bytes += static_cast<char>(body.size() >> (8 * i) & 0xff);
  }
  bytes.resize(format.headerSize, '\0');
  return bytes.append(body);
}

RobotHeader robotHeader(const RobotFormat& format, std::string_view header) {
  if (header.substr(0, 4) != format.magic) {
    return {0, 0, fmt::format("does not speak HULKs' protocol (expected a frame that begins with {})", format.magic)};
  }
  RobotHeader result{static_cast<std::uint8_t>(header[5]), numberAt(header, 8, 4), ""};
  if (static_cast<std::uint8_t>(header[4]) != format.version) {
    result.problem = fmt::format("speaks another version of HULKs' protocol (expected {}, found {})", format.version,
                                 static_cast<unsigned>(static_cast<unsigned char>(header[4])));
  } else if (result.bodySize > mostInFrame) {
    result.problem = fmt::format("announced a frame of {} bytes; at most {} are taken", result.bodySize, mostInFrame);
  }
  return result;
}

std::optional<RobotPicture> robotPicture(std::string_view body) {
  constexpr std::size_t prefix = 14;
  if (body.size() < prefix) {
    return std::nullopt;
  }
  const std::size_t keySize = numberAt(body, 12, 2);
  if (body.size() < prefix + keySize) {
    return std::nullopt;
  }
  return RobotPicture{numberAt(body, 0, 8), static_cast<unsigned>(numberAt(body, 8, 2)),
                      static_cast<unsigned>(numberAt(body, 10, 2)), body.substr(prefix, keySize),
                      body.substr(prefix + keySize)};
}

} // namespace naocal

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

/// Little-endian integer at byte `first`.
template <class Integer> Integer integerAt(std::string_view bytes, std::size_t first) {
  Integer value = 0;
  for (std::size_t i = 0; i < sizeof(Integer); ++i) {
    value |= static_cast<Integer>(static_cast<Integer>(static_cast<std::uint8_t>(bytes[first + i])) << (8 * i));
  }
  return value;
}

} // namespace

FrameHeader parseHeader(const FrameFormat& format, std::string_view header, std::uint32_t maxBodyBytes) {
  assert(header.size() == format.headerSize);
  if (header.substr(0, 4) != format.magic) {
    return {.problem = FrameProblem::magic};
  }
  FrameHeader parsed{integerAt<std::uint8_t>(header, 4), integerAt<std::uint8_t>(header, 5),
                     integerAt<std::uint32_t>(header, 8), FrameProblem::none};
  if (parsed.version != format.version) {
    parsed.problem = FrameProblem::version;
  } else if (parsed.bodySize > maxBodyBytes) {
    parsed.problem = FrameProblem::size;
  }
  return parsed;
}

std::string describeProblem(const FrameHeader& header, const FrameFormat& format, std::uint32_t maxBodyBytes) {
  if (header.problem == FrameProblem::magic) {
    return fmt::format("expected the four letters {} at the start of a frame, found others", format.magic);
  }
  if (header.problem == FrameProblem::version) {
    return fmt::format("expected version {} of the protocol, found {}", format.version, header.version);
  }
  if (header.type > format.largestType) {
    return fmt::format("expected a message type from 0 to {}, found {}", format.largestType, header.type);
  }
  if (header.problem == FrameProblem::size) {
    return fmt::format("expected at most {} bytes in a frame, found {} announced", maxBodyBytes, header.bodySize);
  }
  return "";
}

std::string encodeFrame(const FrameFormat& format, std::uint8_t type, std::string_view body) {
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

std::string encodeDebugFrame(DebugType type, std::string_view body) {
  return encodeFrame(debugFormat, static_cast<std::uint8_t>(type), body);
}

std::string encodeConfigFrame(ConfigType type, std::string_view body) {
  return encodeFrame(configFormat, static_cast<std::uint8_t>(type), body);
}

std::string encodeImageBody(const ImageBody& image) {
  std::string bytes;
  append(bytes, image.timestamp);
  append(bytes, image.width);
  append(bytes, image.height);
  append(bytes, static_cast<std::uint16_t>(image.key.size()));
  return bytes.append(image.key).append(image.file);
}

std::optional<ImageBody> parseImageBody(std::string_view body) {
  constexpr std::size_t prefix = 14; // [bytes] before the key
  if (body.size() < prefix) {
    return std::nullopt;
  }
  const std::size_t keySize = integerAt<std::uint16_t>(body, 12);
  if (body.size() < prefix + keySize) {
    return std::nullopt;
  }
  return ImageBody{integerAt<std::uint64_t>(body, 0), integerAt<std::uint16_t>(body, 8),
                   integerAt<std::uint16_t>(body, 10), body.substr(prefix, keySize), body.substr(prefix + keySize)};
}

} // namespace naocal

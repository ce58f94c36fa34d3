#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace naocal {

/// The frames of HULKs' debug and configuration sockets as a client needs them, little endian:
///
///     debug:  "DMSG", u8 version 1, u8 type, u16 0, u32 length of the body, u32 0
///     config: "CONF", u8 version 2, u8 type, u16 0, u32 length of the body
///
/// Source: HULKs code release 2019, Modules/Debug/DebugMessageFormat.h, Modules/Configuration/ConfigMessageHeader.h.
struct RobotFormat {
  std::string_view magic;
  std::uint8_t version;
  std::size_t headerSize; // [bytes]
};
inline constexpr RobotFormat debugFrames{"DMSG", 1, 16};
inline constexpr RobotFormat configFrames{"CONF", 2, 12};

enum class DebugFrame : std::uint8_t { subscribe, unsubscribe, update, requestList, list, subscribeBulk, image };
enum class ConfigFrame : std::uint8_t { set, getMounts, getKeys, save, sendKeys, sendMounts };

/// No robot sends more at once: a list of all keys with their values, or a picture [bytes].
constexpr std::size_t mostInFrame = 32 << 20;

std::string robotFrame(const RobotFormat& format, std::uint8_t type, std::string_view body);

/// What a header announces; `problem` says what is wrong with it, empty when nothing is.
struct RobotHeader {
  std::uint8_t type = 0;
  std::size_t bodySize = 0;
  std::string problem;
};
RobotHeader robotHeader(const RobotFormat& format, std::string_view header);

/// An IMAGE's body: u64 timestamp [ms], u16 width, u16 height, u16 length of the key, key, file.
struct RobotPicture {
  std::uint64_t timestamp = 0; // [ms]
  unsigned width = 0, height = 0;
  std::string_view key, file;
};
std::optional<RobotPicture> robotPicture(std::string_view body);

} // namespace naocal

#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace naocal {

/// The frames of HULKs' debug and configuration sockets, little endian:
///
///     debug:  "DMSG", u8 version 1, u8 type, u16 0, u32 length of the body, u32 0
///     config: "CONF", u8 version 2, u8 type, u16 0, u32 length of the body
///
/// Source: HULKs code release 2019, Modules/Debug/DebugMessageFormat.h, Modules/Configuration/ConfigMessageHeader.h.
struct FrameFormat {
  std::string_view magic;
  std::uint8_t version;
  std::size_t headerSize; // [bytes]
  std::uint8_t largestType;
  std::uint32_t maxBodyBytes; // that a client's body may have
};
inline constexpr FrameFormat debugFormat{"DMSG", 1, 16, 6, 1 << 16};
inline constexpr FrameFormat configFormat{"CONF", 2, 12, 5, 1 << 20};

enum class DebugType : std::uint8_t { subscribe, unsubscribe, update, requestList, list, subscribeBulk, image };
enum class ConfigType : std::uint8_t { set, getMounts, getKeys, save, sendKeys, sendMounts };

/// What a header announces; `problem` says in words what is wrong with it, empty when nothing is.
struct FrameHeader {
  std::uint8_t type = 0;
  std::uint32_t bodySize = 0;
  std::string problem;
};
FrameHeader parseHeader(const FrameFormat& format, std::string_view header);

/// Header and body.
std::string encodeDebugFrame(DebugType type, std::string_view body);
std::string encodeConfigFrame(ConfigType type, std::string_view body);

/// An IMAGE's body: u64 timestamp [ms], u16 width, u16 height, u16 length of the key, key, file.
std::string encodeImageBody(std::uint64_t timestamp, std::uint16_t width, std::uint16_t height, std::string_view key,
                            std::string_view file);

} // namespace naocal

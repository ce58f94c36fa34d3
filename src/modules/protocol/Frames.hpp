#pragma once

#include <cstdint>
#include <optional>
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
};
inline constexpr FrameFormat debugFormat{"DMSG", 1, 16, 6};
inline constexpr FrameFormat configFormat{"CONF", 2, 12, 5};

enum class DebugType : std::uint8_t { subscribe, unsubscribe, update, requestList, list, subscribeBulk, image };
enum class ConfigType : std::uint8_t { set, getMounts, getKeys, save, sendKeys, sendMounts };

/// Why a header is invalid. A type beyond `largestType` is not a problem here: clients ignore it.
enum class FrameProblem { none, magic, version, size };

/// A parsed header. With the problem `magic` the other fields are not set.
struct FrameHeader {
  std::uint8_t version = 0, type = 0;
  std::uint32_t bodySize = 0; // [bytes]
  FrameProblem problem = FrameProblem::none;
};

/// `header`: `format.headerSize` bytes. `maxBodyBytes`: largest accepted body.
FrameHeader parseHeader(const FrameFormat& format, std::string_view header, std::uint32_t maxBodyBytes);

/// The reason why a server refuses a client's frame, including unknown types: "expected ..., found ..."; empty if
/// valid.
std::string describeProblem(const FrameHeader& header, const FrameFormat& format, std::uint32_t maxBodyBytes);

/// A complete frame: header and body.
std::string encodeFrame(const FrameFormat& format, std::uint8_t type, std::string_view body);
std::string encodeDebugFrame(DebugType type, std::string_view body = {});
std::string encodeConfigFrame(ConfigType type, std::string_view body = {});

/// An IMAGE's body: u64 timestamp [ms], u16 width, u16 height, u16 length of the key, key, file.
struct ImageBody {
  std::uint64_t timestamp = 0;         // [ms]
  std::uint16_t width = 0, height = 0; // [px]
  std::string_view key, file;
};
std::string encodeImageBody(const ImageBody& image);

/// Key and file are views into `body`; absent if it is truncated.
std::optional<ImageBody> parseImageBody(std::string_view body);

} // namespace naocal

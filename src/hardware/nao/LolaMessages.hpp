#pragma once

#include "hardware/RobotInterface.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace naocal {

/// Messages of LoLA, the V6's hardware service: a state every 12 ms and the command in reply, as MessagePack maps of
/// fixed size. Names and orders: HULKs code release 2021, tools/hula/src/lola.rs.
inline constexpr std::size_t lolaStateSize = 896, lolaCommandSize = 786; // [byte]

/// LoLA's joint order, as indices into `jointNames`: no right hip yaw-pitch, hands last.
inline constexpr std::array<std::size_t, 25> lolaJointOrder{0,  1,  2,  3,  4,  5,  6,  8,  9,  10, 11, 12, 13,
                                                            15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 7,  25};

/// A parsed state message; its time is not set.
struct LolaState {
  RobotIdentity identity;
  RobotState state;
};

/// Parses a complete state message; otherwise returns the problem in one sentence.
std::variant<LolaState, std::string> parseLolaState(std::span<const std::uint8_t> message);

/// Whether a message starts like a state; detects a stream that is out of step.
bool hasLolaStateHeader(std::span<const std::uint8_t> message);

/// Encodes commands; reuses its document, so that encoding hardly allocates.
class LolaCommandWriter {
public:
  LolaCommandWriter();
  ~LolaCommandWriter();

  /// A message of `lolaCommandSize` bytes, valid until the next call; empty if an angle or stiffness is not finite.
  std::span<const std::uint8_t> encode(const RobotCommand& command);

private:
  struct Document;
  std::unique_ptr<Document> document_;
  std::vector<std::uint8_t> bytes_;
};

} // namespace naocal

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

/// What LoLA, the V6's hardware service, says every 12 ms, and what it wants to hear: MessagePack maps of always the
/// same size. Names and orders: HULKs code release 2021, tools/hula/src/lola.rs.
inline constexpr std::size_t lolaStateSize = 896, lolaCommandSize = 786; // [byte]

/// LoLA's joints: no second hip yaw-pitch, hands last. The place of each in `jointNames`.
inline constexpr std::array<std::size_t, 25> lolaJointOrder{0,  1,  2,  3,  4,  5,  6,  8,  9,  10, 11, 12, 13,
                                                            15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 7,  25};

/// A state message as understood, its time not set.
struct LolaState {
  RobotIdentity identity;
  RobotState state;
};

/// Understands a whole state message, or says in one sentence why not.
std::variant<LolaState, std::string> parseLolaState(std::span<const std::uint8_t> message);

/// Whether a message begins as every state does: enough to notice a stream that is out of step.
bool hasLolaStateHeader(std::span<const std::uint8_t> message);

/// Writes commands; keeps its document from cycle to cycle, so that a message costs no allocations worth mentioning.
class LolaCommandWriter {
public:
  LolaCommandWriter();
  ~LolaCommandWriter();

  /// `lolaCommandSize` bytes, valid until the next call; none when an angle or a stiffness is not a finite number.
  std::span<const std::uint8_t> encode(const RobotCommand& command);

private:
  struct Document;
  std::unique_ptr<Document> document_;
  std::vector<std::uint8_t> bytes_;
};

} // namespace naocal

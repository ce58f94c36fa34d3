#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace naocal {

/// Limits per client of a socket; docs/limits.md gives the reason of each.
struct ClientLimits {
  double messagesPerSecond = 1000;       // average; bursts of twice as many
  std::uint32_t maxBodyBytes = 1 << 16;  // [bytes] per received frame
  std::size_t maxPendingBytes = 8 << 20; // [bytes] queued for a client that does not read
  /// Maximum time that sent data may stay unacknowledged before the connection counts as lost (TCP_USER_TIMEOUT); this
  /// also ends clients that do not read. 0: system default, no limit for a client that does not read.
  std::chrono::milliseconds unacknowledgedTimeout{0};
  std::chrono::milliseconds firstMessage{5000}; // from the connection to its first complete message
  std::chrono::milliseconds rest{60000};        // between complete messages, unless `Protocol::mayBeSilent`
};

} // namespace naocal

#pragma once

#include "hardware/nao/LolaMessages.hpp"

#include <filesystem>
#include <optional>

namespace naocal {

/// LoLA's UNIX stream socket, cut into whole messages: connects, gathers states from fragments of any size, sends
/// commands whole, and starts anew whenever the other side closes or the stream is out of step. Used by one thread.
class LolaStream {
public:
  explicit LolaStream(std::filesystem::path socket);
  ~LolaStream();
  LolaStream(const LolaStream&) = delete;
  LolaStream& operator=(const LolaStream&) = delete;

  /// A state, as soon as one is whole; the newest of several. Absent at `deadline`.
  struct Received {
    std::array<std::uint8_t, lolaStateSize> message;
    TimePoint arrived;           // its last byte
    std::uint64_t overtaken = 0; // older ones that were whole too and are dropped
  };
  const Received* receive(TimePoint deadline);

  /// Sends a whole message or nothing: what the socket does not take at once follows before the next one, and a
  /// message that would have to wait behind another is dropped.
  void send(std::span<const std::uint8_t> message);

  /// Closes; the next `receive` connects again. `reason`: a sentence.
  void reconnect(std::string reason);

  bool isConnected() const { return socket_ >= 0; }
  std::uint64_t connections() const { return connections_; }
  const std::string& problem() const { return problem_; }

private:
  bool connectOnce();
  bool drain();
  void sendRest();

  std::filesystem::path path_;
  int socket_ = -1;
  TimePoint nextAttempt_{}; // to connect
  Received received_{};
  std::size_t gathered_ = 0; // bytes of the next message
  std::array<std::uint8_t, lolaStateSize> next_{};
  bool fresh_ = false; // `received_` was not given yet
  std::vector<std::uint8_t> unsent_;
  std::uint64_t connections_ = 0;
  std::string problem_ = "not connected yet";
};

} // namespace naocal

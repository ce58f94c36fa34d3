#pragma once

#include "hardware/nao/LolaMessages.hpp"

#include <filesystem>
#include <optional>

namespace naocal {

/// LoLA's UNIX stream socket, split into messages: connects, assembles states from fragments, sends whole commands, and
/// reconnects after a close or when the stream is out of step. For a single thread.
class LolaStream {
public:
  explicit LolaStream(std::filesystem::path socket);
  ~LolaStream();
  LolaStream(const LolaStream&) = delete;
  LolaStream& operator=(const LolaStream&) = delete;

  /// The newest complete state; blocks until there is one. nullptr at `deadline`.
  struct Received {
    std::array<std::uint8_t, lolaStateSize> message;
    TimePoint arrived;           // arrival of its last byte
    std::uint64_t overtaken = 0; // older complete states that were dropped
  };
  const Received* receive(TimePoint deadline);

  /// Sends a message whole or not at all: the rest of a partly sent message follows before the next one; a message that
  /// would have to queue is dropped.
  void send(std::span<const std::uint8_t> message);

  /// Closes the socket; the next `receive` reconnects. `reason`: a sentence.
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
  TimePoint nextAttempt_{}; // earliest time of the next connection attempt
  Received received_{};
  std::size_t gathered_ = 0; // bytes received of the next message
  std::array<std::uint8_t, lolaStateSize> next_{};
  bool fresh_ = false; // `received_` has not been returned yet
  std::vector<std::uint8_t> unsent_;
  std::uint64_t connections_ = 0;
  std::string problem_ = "not connected yet";
};

} // namespace naocal

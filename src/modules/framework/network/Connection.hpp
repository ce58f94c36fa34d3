#pragma once

#include "framework/core/Clock.hpp"
#include "framework/network/ClientLimits.hpp"
#include "framework/network/Peer.hpp"
#include "protocol/Frames.hpp"

#include <boost/asio/generic/stream_protocol.hpp>
#include <deque>
#include <functional>
#include <memory>
#include <string>

/// Heavy header (Boost.Asio): include it in Connection.cpp and Sockets.cpp only.
namespace naocal {

using Socket = boost::asio::generic::stream_protocol::socket;

/// One client's socket: splits received bytes into frames, sends without blocking. Closes on the first protocol
/// violation and logs a sentence. Runs on the sockets' thread only.
class Connection final : public Peer {
public:
  using Ended = std::function<void(Connection&)>;

  Connection(Socket socket, std::string address, Protocol& protocol, const ClientLimits& limits, Log log, Ended ended);

  void start();
  void end(); // notifies the protocol and calls `ended`, once

  /// Closes the connection if its first message, or any message of a client that may not be silent, is overdue.
  void closeIfSilent(TimePoint now);

  bool hasSpoken() const { return hasSpoken_; }          // has sent a complete message
  TimePoint lastMessage() const { return lastMessage_; } // of the start, before the first message
  bool hasDataWaiting() const;                           // received bytes that were not read yet

  std::shared_ptr<Connection> self() { return std::static_pointer_cast<Connection>(shared_from_this()); }

  void send(std::shared_ptr<const std::string> bytes) override;
  bool isBusy() const override { return !queue_.empty(); }
  const std::string& address() const override { return address_; }

private:
  void readHeader();
  void readBody(std::uint8_t type, std::uint32_t size);
  void handle(std::uint8_t type);
  void continueMessage();
  void attempt(const std::function<bool()>& work);
  void write();
  void writeWhenPossible();
  bool tooFast();
  void refuse(const std::string& sentence);
  void readFailed(const boost::system::error_code& error);

  Socket socket_;
  std::string address_;
  Protocol& protocol_;
  ClientLimits limits_;
  Log log_;
  Ended ended_;
  bool open_ = true, hasSpoken_ = false;
  std::string header_, body_;
  std::deque<std::shared_ptr<const std::string>> queue_; // the front is being written
  std::size_t written_ = 0;                              // bytes of the front already written
  std::size_t pendingBytes_ = 0;
  double allowance_; // token bucket: messages accepted now
  TimePoint lastMessage_ = Clock::now();
};

} // namespace naocal

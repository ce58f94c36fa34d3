#pragma once

#include "framework/core/Clock.hpp"
#include "framework/network/Peer.hpp"
#include "protocol/Frames.hpp"

#include <boost/asio/generic/stream_protocol.hpp>
#include <deque>
#include <functional>
#include <memory>
#include <string>

/// Heavy (Boost.Asio): included by Connection.cpp and Sockets.cpp only.
namespace naocal {

using Socket = boost::asio::generic::stream_protocol::socket;

/// Limits of one client.
struct ClientLimits {
  double messagesPerSecond = 1000;       // on average; twice as many at once
  std::uint32_t maxBodyBytes = 1 << 16;  // [bytes] of one of its frames
  std::size_t maxPendingBytes = 8 << 20; // [bytes] that wait for a client that does not read
  /// How long what was sent may stay unconfirmed before the network counts as gone, and with it a client that only does
  /// not read; 0: as long as the system has patience with the network, and for ever with the client.
  std::chrono::milliseconds unacknowledgedTimeout{0};
};

/// One client's socket: cuts what it sends into frames, and writes what it is sent without ever waiting for it. Ends at
/// the first thing that breaks the protocol, with a logged sentence. All on the sockets' thread.
class Connection final : public Peer {
public:
  using Ended = std::function<void(Connection&)>;

  Connection(Socket socket, std::string address, Protocol& protocol, const ClientLimits& limits, Log log, Ended ended);

  void start();
  void end(); // tells the protocol and `ended`, once

  std::shared_ptr<Connection> self() { return std::static_pointer_cast<Connection>(shared_from_this()); }

  void send(std::shared_ptr<const std::string> bytes) override;
  bool isBusy() const override { return !queue_.empty(); }
  const std::string& address() const override { return address_; }

private:
  void readHeader();
  void readBody(std::uint8_t type, std::uint32_t size);
  void handle(std::uint8_t type);
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
  bool open_ = true;
  std::string header_, body_;
  std::deque<std::shared_ptr<const std::string>> queue_; // the first is being written
  std::size_t written_ = 0;                              // of the first [bytes]
  std::size_t pendingBytes_ = 0;
  double allowance_; // messages that it may send at once now
  TimePoint lastMessage_ = Clock::now();
};

} // namespace naocal

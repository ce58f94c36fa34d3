#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace naocal {

struct FrameFormat;

/// Sink of log sentences about clients.
using Log = std::function<void(std::string_view sentence)>;

/// One connected client as a protocol sees it; always held by a std::shared_ptr. Used on the sockets' thread only.
class Peer : public std::enable_shared_from_this<Peer> {
public:
  virtual ~Peer() = default;
  /// Queues bytes; order is kept. Closes a client that does not read while too many bytes are pending.
  virtual void send(std::shared_ptr<const std::string> bytes) = 0;
  /// Whether earlier data is still queued.
  virtual bool isBusy() const = 0;
  /// The address without the port; empty for a client on a UNIX socket.
  virtual const std::string& address() const = 0;
};

/// Per-client state of a protocol. Owner-based keys stay unique: a later client at the same memory address does not
/// match, and a lookup for an ended client finds nothing.
template <class Kept> using ByPeer = std::map<std::weak_ptr<Peer>, Kept, std::owner_less<>>;

/// A protocol violation that closes the client's connection; the message is one sentence.
class ProtocolError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// Handles the frames of a server's clients. `onOpened` is called first, `onClosed` last. `onReceived` and
/// `continueMessage` may throw ProtocolError.
class Protocol {
public:
  virtual ~Protocol() = default;
  virtual const FrameFormat& format() const = 0;
  virtual void onOpened(Peer& peer) = 0;
  virtual void onReceived(Peer& peer, std::uint8_t type, std::string body) = 0;
  virtual void onClosed(Peer& peer) = 0;
  /// Works on the next part of a long message of the client; true if more remains. Called once per turn of the sockets'
  /// thread, so that others are served in between; the client's next message is read after the last part.
  virtual bool continueMessage(Peer&) { return false; }
  /// Whether the client needs no secret or has sent it; an untrusted client is closed first when all places are taken.
  virtual bool isTrusted(const Peer& peer) const = 0;
  /// Whether a new client at this address (empty: on a UNIX socket) is not trusted yet.
  virtual bool needsSecret(const std::string& address) const = 0;
  /// Whether the robot does something for the client while it is silent; such a client is closed last when all places
  /// are taken.
  virtual bool isInUse(const Peer& peer) const = 0;
  /// Whether the client may be silent for longer than ClientLimits::rest.
  virtual bool mayBeSilent(const Peer& peer) const = 0;
};

} // namespace naocal

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

/// Where sentences about clients go.
using Log = std::function<void(std::string_view sentence)>;

/// One connected client as a protocol sees it, always held by a std::shared_ptr. All on the sockets' thread.
class Peer : public std::enable_shared_from_this<Peer> {
public:
  virtual ~Peer() = default;
  /// Sends in the order of calls; a client that takes none of it while too many bytes are pending is closed.
  virtual void send(std::shared_ptr<const std::string> bytes) = 0;
  /// Something that was sent before has not gone out yet.
  virtual bool isBusy() const = 0;
  /// The address without the port; empty for a client on this computer's file system (UNIX socket).
  virtual const std::string& address() const = 0;
};

/// What a protocol keeps of its clients. The keys own their place: no later client takes it, as one may take the
/// address in memory of a client that has ended, and who asks for a client that has ended finds none.
template <class Kept> using ByPeer = std::map<std::weak_ptr<Peer>, Kept, std::owner_less<>>;

/// What a client did that closes its connection: one sentence.
class ProtocolError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// What a server does with its clients' frames: `onOpened` comes before all, `onClosed` after all others. `onReceived`
/// may throw ProtocolError.
class Protocol {
public:
  virtual ~Protocol() = default;
  virtual const FrameFormat& format() const = 0;
  virtual void onOpened(Peer& peer) = 0;
  virtual void onReceived(Peer& peer, std::uint8_t type, std::string body) = 0;
  virtual void onClosed(Peer& peer) = 0;
  /// Where the secret is needed, whether the client has shown it: else it makes room for others when all is full.
  virtual bool isTrusted(const Peer& peer) const = 0;
};

} // namespace naocal
